package simbad.gap.place;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import simbad.sonar.effect.Effect;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.effect.Parameter;
import simbad.sonar.effect.PingLog;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;

/**
 * The table of what size of which effect matters in practice.
 *
 * <ul>
 *   <li>Ranges: 3 m/s is 5 degrees of the air; 1 cm, 1 cm of scatter and steps of 2 cm are what
 *       cheap sensors are specified to.
 *   <li>Echoes: a twentieth lost, doubled or repeated, a fiftieth from elsewhere, a tenth from the
 *       floor; an object that answers half of the pings that face it.
 *   <li>Thresholds: 3 % is how well they repeat on a bench; 0.05 for each metre is a tenth at two;
 *       a taper that takes 6 % at the cone's edge; a cone or an axis a degree off; a tenth by
 *       bearing; a twentieth between pick-up and loss.
 *   <li>Poses: 50 ms and one ping, an obstacle 1 cm or 2 degrees off, 2 % of the path, a degree in
 *       ten seconds.
 *   <li>Gates: sensors are specified to be blind up to 0.3 m; a time-out matters where it takes a
 *       quarter of what the scene or the sensor reaches, or readings start again.
 *   <li>Readings: a number for half of the silent pings; a fifth a wave late; placements 1 cm off,
 *       as a tape is read in passing.
 * </ul>
 */
final class Probes {
  private static final double BLIND_M = 0.3;
  private static final double AHEAD_M = 0.5;
  private static final int OBJECTS = 6;

  private final SensingSetup setup;
  private final PingLog log;

  private Probes(SensingSetup setup, PingLog log) {
    this.setup = setup;
    this.log = log;
  }

  /** Returns the probes of an effect; none where the set-up does not admit the effect. */
  static List<Probe> of(Effect effect, SensingSetup setup, PingLog log) {
    Probes probes = new Probes(setup, log);
    return switch (effect) {
      case UNMODELLED_OBJECT -> probes.objects();
      case ORIENTATION_SHADOW -> probes.shadows();
      case OBSTACLE_TURN, OBSTACLE_OFFSET -> probes.placed(effect);
      case EARLY_TIMEOUT -> List.of(probes.timeout());
      case GAIN, ABSORPTION, BEAM_PATTERN, BEAM_WIDTH ->
          List.of(setup.sensor().law().isLevel() ? probes.level(effect) : probes.plain(effect));
      default -> List.of(probes.plain(effect));
    };
  }

  /** Under the level law: half a decibel, a fifth of a decibel per metre, a tenth of a beam. */
  private Probe level(Effect effect) {
    return switch (effect) {
      case GAIN -> Probe.alone(first(effect), 0, 0.5);
      case ABSORPTION -> Probe.alone(first(effect), 0, 0.2);
      default -> Probe.alone(first(effect), 0, 0.1);
    };
  }

  private Form form(Effect effect, String name) {
    return Forms.find(effect, name, setup, log.sensors()).orElseThrow();
  }

  private Probe plain(Effect effect) {
    SonarSpec sensor = setup.sensor();
    double blind = Math.max(BLIND_M, 1.5 * sensor.minRangeM());
    return switch (effect) {
      case SOUND_SPEED -> Probe.alone(form(effect, "scale"), 0, 3);
      case RANGE_OFFSET, RANGE_NOISE -> Probe.alone(form(effect, "constant"), 0, 0.01);
      case COARSE_RESOLUTION ->
          Probe.alone(form(effect, "start"), 0, Math.max(0.02, 2 * sensor.resolutionM()));
      case CROSSTALK -> Probe.tried(form(effect, "any"), 0, 0.02);
      case MULTIPATH -> Probe.tried(form(effect, "added"), 0, 0.05);
      case DROPOUT -> Probe.alone(form(effect, "single"), 0, 0.05);
      case GAIN -> Probe.alone(form(effect, "factor"), 0, 0.03);
      case BEAM_WIDTH -> Probe.alone(form(effect, "cone"), 0, 1);
      case BEAM_MISALIGNMENT -> Probe.alone(form(effect, "all"), 0, 1);
      case FLOOR_ECHO -> Probe.tried(form(effect, "fixed"), 2, 0.1);
      case LATENCY -> Probe.alone(form(effect, "time"), 0, 0.05);
      case STALE_READING -> Probe.alone(form(effect, "count"), 0, 1);
      case HYSTERESIS -> Probe.alone(form(effect, "both"), 0, 0.05);
      case ODOMETRY_SCALE -> Probe.alone(form(effect, "path"), 0, 0.02);
      case HEADING_DRIFT -> Probe.alone(form(effect, "heading"), 0, 0.1);
      case DEAD_ZONE -> Probe.alone(form(effect, "sharp"), 0, blind);
      case NEAR_CLAMP -> Probe.alone(form(effect, "clamp"), 0, blind);
      case PREVIOUS_PING -> Probe.tried(form(effect, "shift"), 0, 0.05);
      case NO_ECHO_CODE -> Probe.tried(form(effect, "far"), 1, 0.5);
      case WRAP -> Probe.alone(form(effect, "modulus"), 0, 0.75 * sensor.maxRangeM());
      case PLACEMENT_ERROR -> Probe.alone(form(effect, "range"), 0, 0.01);
      case WAVE_HOP -> Probe.tried(form(effect, "later"), 0, 0.2);
      case ABSORPTION -> Probe.alone(first(effect), 0, 0.05);
      case BEAM_PATTERN ->
          Probe.alone(first(effect), 0, 4 * Math.toDegrees(sensor.coneHalfAngleRad()));
      default -> throw new IllegalArgumentException(effect + " has probes of its own");
    };
  }

  private Form first(Effect effect) {
    return Forms.all(setup, log.sensors()).stream()
        .filter(form -> form.effect() == effect)
        .findFirst()
        .orElseThrow();
  }

  private List<Probe> placed(Effect effect) {
    if (setup.scene().obstacles().isEmpty()) {
      return List.of();
    }
    Form all = form(effect, "all");
    return effect == Effect.OBSTACLE_TURN
        ? List.of(Probe.alone(all, 0, 2))
        : List.of(Probe.alone(all, 0, 0.01), Probe.alone(all, 1, 0.01));
  }

  private Probe timeout() {
    double reach =
        setup.scene().obstacles().stream()
            .mapToDouble(obstacle -> obstacle.detection().greatestM())
            .filter(threshold -> threshold > 0)
            .max()
            .orElse(Double.POSITIVE_INFINITY);
    double practical = 0.75 * Math.min(setup.sensor().maxRangeM(), reach);
    return Probe.alone(form(Effect.EARLY_TIMEOUT, "sharp"), 0, practical);
  }

  /** Posts in front of poses spread over the log. */
  private List<Probe> objects() {
    List<double[]> places = new ArrayList<>();
    for (int i = 0; i < OBJECTS && log.size() > 0; i++) {
      int ping = (int) ((i + 0.5) / OBJECTS * log.size());
      double x = log.xM(ping) + AHEAD_M * Math.cos(log.headingRad(ping));
      double z = log.zM(ping) - AHEAD_M * Math.sin(log.headingRad(ping));
      places.add(new double[] {x, z, 0, setup.sensor().maxRangeM(), 0, 90});
    }
    return List.of(new Probe(form(Effect.UNMODELLED_OBJECT, "post"), 4, 0.5, places));
  }

  /** A threshold that swings twice about the believed one in a turn, of any that is uniform. */
  private List<Probe> shadows() {
    return Forms.all(setup, log.sensors()).stream()
        .filter(form -> form.effect() == Effect.ORIENTATION_SHADOW)
        .filter(table -> table.neutral()[0] > 0)
        .map(table -> Probe.alone(swinging(table), 0, 0.1))
        .toList();
  }

  private static Form swinging(Form table) {
    double[] uniformM = table.neutral();
    return new Form(
        Effect.ORIENTATION_SHADOW,
        table.name(),
        List.of(new Parameter("relative_swing", 0, 0, 0.9, List.of(), false)),
        v ->
            table.with(
                IntStream.range(0, uniformM.length)
                    .mapToDouble(i -> uniformM[i] * swing(v[0], i, uniformM.length))
                    .toArray()));
  }

  private static double swing(double share, int index, int size) {
    return 1 + share * Math.cos(index * 4 * Math.PI / size);
  }
}
