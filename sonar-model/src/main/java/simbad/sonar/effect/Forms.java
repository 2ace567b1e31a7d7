package simbad.sonar.effect;

import static java.lang.Math.toRadians;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;

/**
 * The catalogue of the forms that an effect can take before a given set-up: the one place where
 * effects get their parameters, names and bounds.
 */
public final class Forms {
  /** Bearings of a fitted table, as many as the thesis measured. */
  public static final int TABLE_SIZE = 72;

  /** Waves of a fitted shadow of few lobes. */
  public static final int SHADOW_WAVES = 3;

  private static final Parameter SHARE = Parameter.of("share", 0, 0, 1, 0.05, 0.2, 0.5).asClosed();

  /** "Now and then" is less than two times in five. */
  private static final Parameter NOW_AND_THEN = Parameter.of("share", 0, 0, 0.4, 0.03, 0.1, 0.3);

  private static final Parameter SMALL_SHARE = Parameter.of("share", 0, 0, 0.7, 0.03, 0.1, 0.3);

  /**
   * Spread of a detour over its length, and for one in proportion over that of an echo at 1 m: a
   * way that scatters by more than it is longer would be noise.
   */
  private static final double MOST_SPREAD = 0.5;

  /** What scatters by more than so much of an offset is noise beside it. */
  private static final double MOST_OFFSET_SCATTER = 0.15;

  /** Nobody takes a number for "no echo" that an echo may well have. */
  private static final double CODE_FROM = 0.95;

  /** "A little elsewhere": what a tape or a ruler may be off by. */
  private static final double MOST_MISPLACED_M = 0.05;

  /** Numbers for "no echo" end where a log is one of another unit. */
  private static final double MOST_CODE_M = 100;

  /** What comes from nearly the same range each time has to do with something. */
  private static final double LEAST_BAND_M = 0.3;

  /** A wrong unit or constant scales ranges by a fifth to five times; neither is at a bound. */
  private static final double MOST_SCALE = 5.5;

  /**
   * Believed over read: what is taken for another unit or way is so exactly, and steps that are
   * scaled leave no room between (inches, feet, one way for both, some timers).
   */
  private static final double[] UNITS = {
    0.2, 0.25, 0.3048, 1 / 2.54, 0.5, 0.94, 0.98, 1.02, 1.06, 2, 2.54, 1 / 0.3048, 4, 5
  };

  /** And so has what hardly walks. */
  private static final double LEAST_STEP_M = 0.01;

  private final SensingSetup setup;
  private final List<Form> forms = new ArrayList<>();

  private Forms(SensingSetup setup) {
    this.setup = setup;
  }

  /**
   * Returns all forms of all effects, in the order of the vocabulary.
   *
   * @param setup whose obstacles and sensor they are for
   * @param sensors labels of the transducers in the log
   */
  public static List<Form> all(SensingSetup setup, List<String> sensors) {
    Forms forms = new Forms(setup);
    forms.ranges();
    forms.crosstalk();
    forms.detours();
    forms.losses();
    forms.thresholds();
    forms.beam();
    forms.floor();
    forms.objects();
    forms.gates();
    forms.codes();
    forms.forms.addAll(MemoryForms.all(setup.sensor()));
    forms.forms.addAll(PlaceForms.all(setup, sensors));
    if (setup.sensor().law().isLevel()) {
      LevelForms.replace(forms.forms, setup.sensor());
    }
    forms.forms.sort(Comparator.comparing(Form::effect));
    return List.copyOf(forms.forms);
  }

  /** Finds a form by its effect and name. */
  public static Optional<Form> find(
      Effect effect, String name, SensingSetup setup, List<String> sensors) {
    // A scene that believes in thresholds may have been diagnosed under the level law.
    return Stream.concat(all(setup, sensors).stream(), LevelForms.effects(setup.sensor()).stream())
        .filter(form -> form.effect() == effect && form.name().equals(name))
        .findFirst();
  }

  private void add(Effect effect, String name, Form.Maker maker, Parameter... parameters) {
    forms.add(new Form(effect, name, List.of(parameters), maker));
  }

  private void ranges() {
    double assumed = setup.sensor().assumedSoundSpeedMPerS();
    double resolution = setup.sensor().resolutionM();
    add(
        Effect.SOUND_SPEED,
        "scale",
        v -> new SoundSpeed(assumed / v[0]),
        speed(assumed, 0.94, 0.98, 1.02, 1.06));
    add(
        Effect.SOUND_SPEED,
        "reading",
        v -> new ReadingScale(assumed / v[0], resolution),
        speed(assumed, UNITS));
    add(Effect.RANGE_OFFSET, "constant", v -> new RangeOffset(v[0]), offset());
    add(
        Effect.RANGE_OFFSET,
        "scattered",
        v -> new ScatteredOffset(new RangeOffset(v[0]), v[1]),
        offset(),
        Parameter.of("scatter_share", 0, 0, MOST_OFFSET_SCATTER, 0.1));
    noise();
    steps();
  }

  private static Parameter speed(double assumed, double... shares) {
    return Parameter.of(
        "sound_speed_m_s",
        assumed,
        assumed / MOST_SCALE,
        assumed * MOST_SCALE,
        Arrays.stream(shares).map(share -> share * assumed).toArray());
  }

  private static Parameter offset() {
    return Parameter.of("offset_m", 0, -1, 1, -0.1, -0.03, 0.03, 0.1);
  }

  private void noise() {
    add(
        Effect.RANGE_NOISE,
        "constant",
        v -> new RangeNoise(v[0], 0),
        Parameter.of("added_m", 0, 0, 0.5, 0.01, 0.03, 0.1));
    add(
        Effect.RANGE_NOISE,
        "growing",
        v -> new RangeNoise(v[0], v[1]),
        Parameter.of("added_m", 0, 0, 0.5, 0.002, 0.02),
        Parameter.of("added_per_m", 0, 0, 0.3, 0.01, 0.04));
    add(
        Effect.RANGE_NOISE,
        "tails",
        v -> new NoiseTails(v[0], v[1]),
        Parameter.of("share", 0, 0, 1, 0.1, 0.4).asClosed(),
        Parameter.of("deviation_m", 0, 0, 0.25, 0.03, 0.1));
  }

  private void steps() {
    for (CoarseResolution.Reported reported : CoarseResolution.Reported.values()) {
      add(
          Effect.COARSE_RESOLUTION,
          reported.name().toLowerCase(Locale.ROOT),
          v -> new CoarseResolution(v[0], reported),
          step());
    }
  }

  private static Parameter step() {
    return Parameter.of("step_m", 0, 0, 0.5, 0.02, 0.025, 0.03, 0.04, 0.05, 0.08, 0.1);
  }

  private void crosstalk() {
    double most = setup.sensor().maxRangeM();
    Parameter low = Parameter.of("low_m", 0, 0, 0.9 * most, 0.05);
    Parameter band = Parameter.of("band_m", most, LEAST_BAND_M, most, 0.5 * most, most);
    add(
        Effect.CROSSTALK,
        "any",
        v -> new Crosstalk(v[0], v[1], v[1] + v[2], false),
        NOW_AND_THEN,
        low,
        band);
    add(
        Effect.CROSSTALK,
        "silent",
        v -> new Crosstalk(v[0], v[1], v[1] + v[2], true),
        NOW_AND_THEN,
        low,
        band);
    add(
        Effect.CROSSTALK,
        "earlier",
        v -> new EarlyCrosstalk(v[0], v[1], v[1] + v[2]),
        NOW_AND_THEN,
        low,
        band);
    walking("walking", Parameter.of("step_m", LEAST_STEP_M, LEAST_STEP_M, 1, 0.1));
    walking("walking back", Parameter.of("step_m", -LEAST_STEP_M, -1, -LEAST_STEP_M, -0.1));
  }

  private void walking(String name, Parameter step) {
    double most = setup.sensor().maxRangeM();
    add(
        Effect.CROSSTALK,
        name,
        v -> new WalkingCrosstalk(v[0], v[1], v[2], v[3], v[4], v[5]),
        NOW_AND_THEN,
        Parameter.of("low_m", 0, 0, 0.5, 0),
        Parameter.of("band_m", most, 0.5, 3 * most, most),
        step,
        Parameter.of("start_m", 0, -3 * most, 3 * most, 0),
        Parameter.of("spread_m", 0, 0, 0.1, 0.01));
  }

  private void detours() {
    Parameter spread = Parameter.of("spread_share", 0, 0, MOST_SPREAD, 0.1);
    add(
        Effect.MULTIPATH,
        "added",
        v -> added(v[0], v[1], v[2]),
        SMALL_SHARE,
        Parameter.of("extra_m", 0, 0.02, 2, 0.1, 0.3, 0.6),
        spread);
    add(
        Effect.MULTIPATH,
        "factor",
        v -> scaled(v[0], v[1], v[2]),
        SMALL_SHARE,
        Parameter.of("factor", 1, 1.02, 3, 1.2, 1.5, 2),
        spread);
    add(
        Effect.MULTIPATH,
        "tail",
        v -> new TailedMultipath(v[0], v[1]),
        SMALL_SHARE,
        Parameter.of("mean_extra_m", 0, 0.05, 1, 0.08, 0.2, 0.5));
    add(
        Effect.MULTIPATH,
        "both",
        v -> new MixedMultipath(added(v[0], v[1], v[4]), scaled(v[2], v[3], v[4])),
        SMALL_SHARE,
        Parameter.of("extra_m", 0, 0.02, 2, 0.1, 0.3, 0.6),
        Parameter.of("scaled_share", 0, 0, 0.7, 0.1),
        Parameter.of("factor", 1, 1.02, 3, 1.2, 1.5, 2),
        spread);
  }

  private static Multipath added(double share, double extraM, double spread) {
    return new Multipath(share, 1, extraM, spread * extraM);
  }

  private static Multipath scaled(double share, double factor, double spread) {
    return new Multipath(share, factor, 0, spread * (factor - 1));
  }

  private void losses() {
    add(Effect.DROPOUT, "single", v -> new Dropout(v[0]), SHARE);
    add(
        Effect.DROPOUT,
        "bursts",
        v -> new Burst(v[0], v[1], 1),
        Parameter.of("share", 0, 0, 0.9, 0.1, 0.3),
        Parameter.of("length_pings", 1, 1, Burst.LONGEST_PINGS, 3, 8));
  }

  private void thresholds() {
    add(
        Effect.GAIN,
        "factor",
        v -> new Gain(v[0]),
        Parameter.of("factor", 1, 0.2, 3, 0.7, 0.85, 0.95, 1.05, 1.15, 1.3));
    for (Absorption.Law law : Absorption.Law.values()) {
      add(
          Effect.ABSORPTION,
          law.name().toLowerCase(Locale.ROOT),
          v -> new Absorption(v[0], law),
          Parameter.of("loss_per_m", 0, 0, 1.5, 0.05, 0.1, 0.2, 0.4));
    }
  }

  private void beam() {
    double half = Math.toDegrees(setup.sensor().coneHalfAngleRad());
    for (BeamPattern.Law law : BeamPattern.Law.values()) {
      String name = law.name().toLowerCase(Locale.ROOT);
      pattern(name, law, BeamPattern.Angle.CENTRE, half);
      pattern(name + "-outline", law, BeamPattern.Angle.OUTLINE, half);
      pattern(name + "-nearest", law, BeamPattern.Angle.NEAREST, half);
    }
    add(
        Effect.BEAM_WIDTH,
        "cone",
        v -> new BeamWidth(toRadians(v[0])),
        Parameter.of(
            "added_deg",
            0,
            -0.9 * half,
            Math.min(60, 180 - half),
            -0.4 * half,
            -0.2 * half,
            -1.5,
            1.5,
            0.2 * half,
            0.4 * half));
  }

  private void pattern(String name, BeamPattern.Law law, BeamPattern.Angle angle, double halfDeg) {
    double least = law == BeamPattern.Law.BELL ? 0.2 * halfDeg : 0.5 * halfDeg;
    add(
        Effect.BEAM_PATTERN,
        name,
        v -> new BeamPattern(toRadians(v[0]), v[1], law, angle),
        Parameter.of(
            "width_deg",
            Double.POSITIVE_INFINITY,
            least,
            20 * halfDeg,
            0.7 * halfDeg,
            1.1 * halfDeg,
            2 * halfDeg),
        Parameter.of("power", 1, 0.3, 8, 0.7, 2).asClosed());
  }

  private void floor() {
    double most = setup.sensor().maxRangeM();
    add(
        Effect.FLOOR_ECHO,
        "fixed",
        v -> new FloorEcho(v[0], v[1], v[2]),
        Parameter.of("range_m", most, 0.02, most, 0.3 * most),
        Parameter.of("spread_m", 0, 0, 0.15, 0.02),
        SHARE);
    add(
        Effect.FLOOR_ECHO,
        "two",
        v -> new TwoFloorEchoes(new FloorEcho(v[0], v[1], v[2]), v[3], v[4]),
        Parameter.of("range_m", most, 0.02, most, 0.3 * most),
        Parameter.of("spread_m", 0, 0, 0.15, 0.02),
        SHARE,
        Parameter.of("apart_m", 0, 0.01, 0.4, 0.05),
        Parameter.of("farther_share", 0, 0, 1, 0.2).asClosed());
  }

  private void objects() {
    Parameter x = Parameter.of("x_m", 0, -20, 20, 0);
    Parameter z = Parameter.of("z_m", 0, -20, 20, 0);
    Parameter normal = Parameter.of("normal_deg", 0, -400, 400, 0).asClosed();
    Parameter width = Parameter.of("half_width_m", 0, 0.02, 10, 0.4).asClosed();
    Parameter sure = Parameter.of("share", 0, 0.1, 1, 0.95).asClosed();
    double most = setup.sensor().maxRangeM();
    Parameter reach = Parameter.of("reach_m", most, 0.05, most, most);
    add(
        Effect.UNMODELLED_OBJECT,
        "mirror",
        v -> new UnmodelledObject(v[0], v[1], toRadians(v[2]), v[3], 0, most, v[4]),
        x,
        z,
        normal,
        width,
        sure);
    add(
        Effect.UNMODELLED_OBJECT,
        "face",
        v -> new UnmodelledObject(v[0], v[1], toRadians(v[2]), v[3], toRadians(v[5]), v[6], v[4]),
        x,
        z,
        normal,
        width,
        sure,
        Parameter.of("square_deg", 30, 3, 90, 15, 40).asClosed(),
        reach);
    add(
        Effect.UNMODELLED_OBJECT,
        "post",
        v -> new UnmodelledPost(v[0], v[1], v[2], v[3], toRadians(v[5]), v[4]),
        x,
        z,
        Parameter.of("radius_m", 0, 0, 0.5, 0.05),
        reach,
        sure,
        Parameter.of("square_deg", 90, 3, 90, 90).asClosed());
  }

  private void gates() {
    double most = setup.sensor().maxRangeM();
    Parameter soft = Parameter.of("soft_m", 0, 0, 0.3, 0.02);
    Parameter end = Parameter.of("end_m", 0, 0, most, 0.15, 0.3, 0.5, 0.8);
    Parameter start =
        Parameter.of(
            "start_m", Double.POSITIVE_INFINITY, 0.1, most, 0.3 * most, 0.5 * most, 0.7 * most);
    add(Effect.DEAD_ZONE, "sharp", v -> new DeadZone(v[0], 0), end);
    add(Effect.DEAD_ZONE, "soft", v -> new DeadZone(v[0], v[1]), end, soft);
    add(Effect.EARLY_TIMEOUT, "sharp", v -> new EarlyTimeout(v[0], 0), start);
    add(Effect.EARLY_TIMEOUT, "soft", v -> new EarlyTimeout(v[0], v[1]), start, soft);
    add(
        Effect.NEAR_CLAMP,
        "clamp",
        v -> new NearClamp(v[0]),
        Parameter.of("least_m", 0, 0, most, 0.1, 0.2, 0.35, 0.6));
  }

  private void codes() {
    SonarSpec sensor = setup.sensor();
    double most = sensor.maxRangeM();
    code("near", Parameter.of("code_m", most, 0, Math.max(1e-3, sensor.minRangeM() / 2), 0));
    code("far", Parameter.of("code_m", 0, CODE_FROM * most, Math.max(MOST_CODE_M, most), most));
    add(
        Effect.WRAP,
        "modulus",
        v -> new Wrap(v[0]),
        Parameter.of("modulus_m", Double.POSITIVE_INFINITY, 0.1, most, 0.256, 1.28, 2.55, 2.56));
    add(
        Effect.PLACEMENT_ERROR,
        "range",
        v -> new RangeNoise(v[0], 0),
        Parameter.of("deviation_m", 0, 0, MOST_MISPLACED_M, 0.002, 0.01, 0.03));
    add(
        Effect.WAVE_HOP,
        "later",
        v -> new WaveHop(v[0], v[1]),
        Parameter.of("share", 0, 0, 1, 0.1, 0.4).asClosed(),
        Parameter.of("step_m", 0, 0.002, 0.009, 0.0043, 0.0086));
  }

  private void code(String name, Parameter code) {
    add(
        Effect.NO_ECHO_CODE,
        name,
        v -> new NoEchoCode(v[0], v[1], v[2]),
        code.asClosed(),
        Parameter.of("share", 0, 0, 1, 0.9).asClosed(),
        Parameter.of("lost_share", 0, 0, 0.95, 0, 0.1, 0.4));
  }
}
