package simbad.gap.explain;

import java.util.ArrayList;
import java.util.DoubleSummaryStatistics;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import simbad.gap.fit.Evidence;
import simbad.sonar.effect.Effect;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Parameter;
import simbad.sonar.effect.PingLog;
import simbad.sonar.effect.Scenes;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.scene.UniformDetection;
import simbad.sonar.shape.Outline;

/**
 * What physics, symmetry or the design of a log forbids: an effect that cannot be there, or that
 * nothing in the log could show, is not looked for.
 */
final class Gates {
  /**
   * Beyond so many times the range at which the best target is just heard no echo of the ping
   * before is left: at four times that spreading takes 12 dB or more of a wall's echo and air of
   * 1.3 dB/m, over the way there and back from 4 m on, another 31 dB.
   */
  private static final double AUDIBLE_RANGES = 4;

  /** A polygon of so many corners whose distances from the axis differ by less is round. */
  private static final int ROUND_CORNERS = 12;

  private static final double ROUND = 0.97;

  /** Steps and noise that hide a wave of 4 mm. */
  private static final double HIDES_WAVES_M = 0.003;

  /** Fewer readings of one value are a coincidence. */
  private static final int LEAST_CODES = 3;

  private static final double MILLIMETRE = 1e-3;

  private final SensingSetup setup;
  private final PingLog log;
  private final boolean repeated;
  private final boolean noisier;
  private final boolean ghosts;
  private final List<String> round = new ArrayList<>();

  private Gates(Evidence evidence) {
    setup = evidence.setup();
    log = evidence.log();
    Placements placements = new Placements(evidence.log());
    repeated = placements.areRepeated();
    noisier = !repeated || PlacementScatter.isNoisier(evidence, placements);
    SonarSpec sensor = setup.sensor();
    double wayM = medianPeriodS(evidence.log()) * sensor.assumedSoundSpeedMPerS() / 2;
    ghosts = !(wayM > AUDIBLE_RANGES * sensor.maxRangeM());
    List<String> labels = Scenes.labels(setup.scene());
    for (int i = 0; i < labels.size(); i++) {
      Obstacle obstacle = setup.scene().obstacles().get(i);
      if (obstacle.detection() instanceof UniformDetection && isRound(obstacle.outline())) {
        round.add(labels.get(i));
      }
    }
  }

  /** Returns those of some forms that are possible. */
  static List<Form> open(Evidence evidence, List<Form> forms) {
    Gates gates = new Gates(evidence);
    return forms.stream().filter(gates::isOpen).toList();
  }

  private boolean isOpen(Form form) {
    return switch (form.effect()) {
      case PREVIOUS_PING -> ghosts;
      case PLACEMENT_ERROR -> repeated;
      // What scatters from placement to placement alone is no noise.
      case RANGE_NOISE -> noisier;
      // An offset that scatters is one that is put in place anew.
      case RANGE_OFFSET -> !repeated || form.parameters().size() == 1;
      case NO_ECHO_CODE -> isRead(form.parameters().get(0));
      case WAVE_HOP ->
          setup.sensor().resolutionM() <= HIDES_WAVES_M
              && setup.sensor().rangeNoiseM() <= HIDES_WAVES_M;
      case ORIENTATION_SHADOW, OBSTACLE_TURN -> !isOfRoundOnes(form);
      default -> true;
    };
  }

  /**
   * Whether one number is read at least as often as no echo is. A number that stands for "no echo"
   * stands for most of them; with a rarer one beside it the form would be one of lost echoes.
   */
  private boolean isRead(Parameter code) {
    Map<Long, Integer> readings = new HashMap<>();
    int silent = 0;
    int most = 0;
    for (int ping = 0; ping < log.size(); ping++) {
      if (!log.echo(ping)) {
        silent++;
      } else if (code.permits(log.rangeM(ping))) {
        most =
            Math.max(
                most, readings.merge(Math.round(log.rangeM(ping) / MILLIMETRE), 1, Integer::sum));
      }
    }
    return most >= Math.max(LEAST_CODES, silent);
  }

  /** Whether a form turns or shades nothing but what looks the same from all sides. */
  private boolean isOfRoundOnes(Form form) {
    Optional<String> one =
        Scenes.labels(setup.scene()).stream()
            .filter(
                label ->
                    form.name().equals("only:" + label) || form.name().contains(":" + label + "#"))
            .findFirst();
    long uniform =
        setup.scene().obstacles().stream()
            .filter(
                obstacle ->
                    form.effect() == Effect.OBSTACLE_TURN
                        || obstacle.detection() instanceof UniformDetection)
            .count();
    return one.map(round::contains).orElse(!round.isEmpty() && round.size() == uniform);
  }

  private static boolean isRound(Outline outline) {
    DoubleSummaryStatistics radii =
        outline.corners().stream()
            .mapToDouble(corner -> Math.hypot(corner.xM(), corner.zM()))
            .summaryStatistics();
    return radii.getCount() >= ROUND_CORNERS && radii.getMin() > ROUND * radii.getMax();
  }

  /** From ping to ping of one sensor in one run, seconds; 0 where there is no second ping. */
  private static double medianPeriodS(PingLog log) {
    double[] periods =
        IntStream.range(0, log.size())
            .filter(i -> i > log.sequenceStart(i))
            .mapToDouble(i -> log.timeS(i) - log.timeS(i - 1))
            .sorted()
            .toArray();
    return periods.length == 0 ? 0 : periods[periods.length / 2];
  }
}
