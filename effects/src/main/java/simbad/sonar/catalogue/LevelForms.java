package simbad.sonar.catalogue;

import static java.lang.Math.toRadians;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.IntToDoubleFunction;
import java.util.stream.Stream;
import simbad.definition.Parameter;
import simbad.sonar.effect.Form;
import simbad.sonar.level.Curve;
import simbad.sonar.level.LevelDefaults;
import simbad.sonar.level.LevelLaw;
import simbad.sonar.level.PistonBeam;
import simbad.sonar.level.StrengthTable;
import simbad.sonar.ping.EchoPath;
import simbad.sonar.ping.LevelRule;
import simbad.sonar.ping.LevelStrength;
import simbad.sonar.ping.NearEcho;
import simbad.sonar.ping.NearField;
import simbad.sonar.ping.NearRange;
import simbad.sonar.ping.Scenes;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;

/**
 * The level law as a calibration of the set-up. Names and order of the values are those of files.
 */
public final class LevelForms {
  /** Bearings of a calibrated strength: half the spacing of the thesis's tables. */
  public static final int BEARINGS = 144;

  /** Distances at which the receiver's threshold departs from the believed one, metres. */
  public static final List<Double> RECEIVER_M =
      List.of(0.08, 0.15, 0.25, 0.4, 0.6, 0.9, 1.3, 1.9, 2.7, 3.8, 5.5);

  /** Levels at which the walk is fitted, decibels over the threshold. */
  public static final List<Double> WALK_DB = List.of(0.0, 4.0, 8.0, 14.0, 24.0);

  /** Levels at which the noise is fitted, decibels over the threshold. */
  public static final List<Double> NOISE_DB = List.of(2.0, 8.0, 16.0);

  /**
   * Distances at which it is fitted by how much a near echo is read too far, metres; 0 from the
   * last one on.
   */
  public static final List<Double> NEAR_M = List.of(0.1, 0.14, 0.2, 0.28, 0.4);

  /** Radius of a ranger's piston that is not known: between SRF04 and HC-SR04, metres. */
  public static final double APERTURE_M = 0.007;

  /** No ranger hears further than so many times what is said of it. */
  private static final double FURTHEST_TIMES = 5;

  private static final String NEAR_FIELD = "near-field:";
  private static final String NEAR_RANGE = "near-range";

  /** Name of the law's form. */
  public static final String LAW = "level";

  /** Among the values of the law, the first of the receiver's departures. */
  private static final int RECEIVER = 8;

  private static final double MOST_DB = StrengthTable.GREATEST_DB;
  private static final double MOST_RECEIVER_DB = 60;
  private static final double MOST_PATH_M = 0.25;

  private LevelForms() {}

  /** Returns the form of the law before a set-up. */
  public static Form law(SensingSetup setup) {
    LevelLaw stated = setup.sensor().levelLaw();
    List<Parameter> parameters = new ArrayList<>();
    parameters.add(Parameter.of("spreading_exponent", stated.spreadingExponent(), 0, 6));
    parameters.add(Parameter.of("absorption_db_per_m", stated.absorptionDbPerM(), 0, 20));
    double radius = radiusM(stated);
    parameters.add(Parameter.of("aperture_radius_m", radius, 1e-4, Math.max(1, radius)));
    parameters.add(Parameter.of("aperture_deviation", 0, 0, 10));
    parameters.add(Parameter.of("squint_deg", 0, -45, 45));
    parameters.add(Parameter.of("squint_deviation_deg", 0, 0, 45));
    parameters.add(Parameter.of("excess_sd_db", stated.excessSdDb(), 0, 100));
    parameters.add(Parameter.of("miss_rate", setup.sensor().missRate(), 0, 1));
    for (double at : RECEIVER_M) {
      parameters.add(
          Parameter.of(at("receiver_added_db", at), 0, -MOST_RECEIVER_DB, MOST_RECEIVER_DB));
    }
    for (double at : WALK_DB) {
      parameters.add(Parameter.of(at("walk_m", at), stated.walkM().at(at), -1, 1));
    }
    for (double at : NOISE_DB) {
      parameters.add(Parameter.of(at("noise_m", at), stated.noiseM().at(at), 0, 1));
    }
    SonarSpec sensor = setup.sensor();
    double least = sensor.minRangeM();
    double most = sensor.maxRangeM();
    parameters.add(Parameter.of("min_range_m", least, 0, least).asClosed());
    parameters.add(Parameter.of("max_range_m", most, most, FURTHEST_TIMES * most).asClosed());
    parameters.add(Parameter.of("range_scale", 1, 0.5, 2));
    double wavenumber = wavenumberPerM(setup);
    return form(LAW, v -> rule(stated, wavenumber, v), parameters);
  }

  /** Tells whether a form is that of the law. */
  public static boolean isLaw(Form form) {
    return form.of().isEmpty() && form.name().equals(LAW);
  }

  private static double radiusM(LevelLaw law) {
    // A beam that is stated as a curve is taken for the piston of the default.
    return law.beam() instanceof PistonBeam piston ? piston.apertureRadiusM() : APERTURE_M;
  }

  /** Returns the wavenumber of a set-up's carrier in its air, radians per metre. */
  public static double wavenumberPerM(SensingSetup setup) {
    return wavenumberPerM(setup.sensor());
  }

  /** Returns the wavenumber of a sensor's carrier in its air, radians per metre. */
  public static double wavenumberPerM(SonarSpec sensor) {
    return sensor.law().level().air().wavenumberPerM(frequencyHz(sensor));
  }

  /** Returns a sensor's carrier, hertz. */
  static double frequencyHz(SonarSpec sensor) {
    return sensor.law().level().frequencyHz().orElse(LevelDefaults.FREQUENCY_HZ);
  }

  private static LevelRule rule(LevelLaw stated, double wavenumber, double... v) {
    int walk = RECEIVER + RECEIVER_M.size();
    int noise = walk + WALK_DB.size();
    LevelLaw law =
        new LevelLaw(
            stated.levelDb(),
            v[0],
            v[1],
            PistonBeam.of(v[2], wavenumber),
            receiver(stated.receiverThresholdDb(), Arrays.copyOfRange(v, RECEIVER, walk)),
            v[6],
            curve(WALK_DB, i -> v[walk + i]),
            curve(NOISE_DB, i -> v[noise + i]),
            stated.pulseLengthM());
    int limits = noise + NOISE_DB.size();
    return new LevelRule(
        law, toRadians(v[4]), v[7], v[3], toRadians(v[5]), v[limits], v[limits + 1], v[limits + 2]);
  }

  private static Curve curve(List<Double> x, IntToDoubleFunction y) {
    double[] points = new double[2 * x.size()];
    for (int i = 0; i < x.size(); i++) {
      points[2 * i] = x.get(i);
      points[2 * i + 1] = y.applyAsDouble(i);
    }
    return Curve.of(points);
  }

  /** The believed curve with departures that are straight over the logarithm of the distance. */
  private static Curve receiver(Curve believed, double[] addedDb) {
    if (Arrays.stream(addedDb).allMatch(added -> added == 0)) {
      return believed;
    }
    int steps = 200;
    double[] points = new double[2 * steps + 2];
    for (int i = 0; i <= steps; i++) {
      double at = 0.03 * Math.pow(400, (double) i / steps);
      double added = 0;
      for (int knot = 0; knot < addedDb.length; knot++) {
        added += addedDb[knot] * receiverWeight(knot, at);
      }
      points[2 * i] = at;
      points[2 * i + 1] = believed.at(at) + added;
    }
    return Curve.of(points);
  }

  /**
   * Returns which of the distances of {@link #RECEIVER_M} comes before a distance; the first of
   * them for what is nearer.
   *
   * @param distanceM metres
   */
  public static int receiverKnot(double distanceM) {
    int knot = 0;
    while (knot < RECEIVER_M.size() - 1 && distanceM > RECEIVER_M.get(knot + 1)) {
      knot++;
    }
    return knot;
  }

  /**
   * Returns how much the departure at one of {@link #RECEIVER_M} counts at a distance.
   *
   * @param knot index among them
   * @param distanceM metres, positive
   * @return in [0, 1]; those of all knots add up to 1
   */
  public static double receiverWeight(int knot, double distanceM) {
    double at = RECEIVER_M.get(knot);
    int other = distanceM < at ? knot - 1 : knot + 1;
    if (other < 0 || other == RECEIVER_M.size()) {
      return 1;
    }
    return Math.max(0, 1 - Math.log(distanceM / at) / Math.log(RECEIVER_M.get(other) / at));
  }

  /**
   * Returns the form of an obstacle's strength: that at all bearings, and how far it may be off.
   */
  public static Form strength(String label) {
    List<Parameter> parameters = new ArrayList<>();
    for (int i = 0; i < BEARINGS; i++) {
      parameters.add(Parameter.of(at("strength_db", bearingDeg(i)), 0, -MOST_DB, MOST_DB));
    }
    for (int i = 0; i < BEARINGS; i++) {
      parameters.add(Parameter.of(at("deviation_db", bearingDeg(i)), 0, 0, MOST_DB));
    }
    for (int i = 0; i < BEARINGS; i++) {
      parameters.add(Parameter.of(at("with_aperture_db", bearingDeg(i)), 0, -MOST_DB, MOST_DB));
    }
    return form(
        "strength:" + label,
        v -> new LevelStrength(Optional.of(label), table(v, 0), table(v, 1), table(v, 2)),
        parameters);
  }

  /**
   * Returns the form of an obstacle's echo path: what is added at all bearings, and how far that
   * may be off.
   */
  public static Form path(String label) {
    List<Parameter> parameters = new ArrayList<>();
    for (int i = 0; i < BEARINGS; i++) {
      parameters.add(Parameter.of(at("added_m", bearingDeg(i)), 0, -MOST_PATH_M, MOST_PATH_M));
    }
    for (int i = 0; i < BEARINGS; i++) {
      parameters.add(Parameter.of(at("deviation_m", bearingDeg(i)), 0, 0, MOST_PATH_M));
    }
    return form(
        "path:" + label,
        v ->
            new EchoPath(
                Optional.of(label),
                EchoPath.round(Arrays.copyOf(v, BEARINGS)),
                EchoPath.round(Arrays.copyOfRange(v, BEARINGS, 2 * BEARINGS))),
        parameters);
  }

  /**
   * Returns the form of where an obstacle's echo comes from: 1 for where it adds up.
   *
   * @param setup of which the carrier counts
   * @param label of the obstacle
   */
  public static Form nearField(SensingSetup setup, String label) {
    Optional<String> only = Optional.of(label);
    int at = Scenes.labels(setup.scene()).indexOf(label);
    Obstacle obstacle = setup.scene().obstacles().get(at);
    NearEcho known =
        new NearEcho(only, Optional.of(new NearField(obstacle, wavenumberPerM(setup))));
    NearEcho none = new NearEcho(only, Optional.empty());
    return form(
        NEAR_FIELD + label,
        v -> v[0] == 0 ? none : known,
        List.of(Parameter.of("where_it_adds_up", 0, 0, 1)));
  }

  /** Returns the form of by how much near echoes are read too far, at all but the last distance. */
  public static Form nearRange() {
    int knots = NEAR_M.size() - 1;
    List<Parameter> parameters = new ArrayList<>();
    for (int i = 0; i < knots; i++) {
      parameters.add(Parameter.of(at("added_m", NEAR_M.get(i)), 0, -MOST_PATH_M, MOST_PATH_M));
    }
    return form(
        NEAR_RANGE, v -> new NearRange(curve(NEAR_M, i -> i == knots ? 0 : v[i])), parameters);
  }

  private static StrengthTable table(double[] v, int number) {
    return StrengthTable.of(Arrays.copyOfRange(v, number * BEARINGS, (number + 1) * BEARINGS));
  }

  private static double bearingDeg(int index) {
    return index * 360.0 / BEARINGS;
  }

  /** Finds a calibration under the level law by its name. */
  static Optional<Form> find(String name, SensingSetup setup) {
    if (name.equals(LAW)) {
      return Optional.of(law(setup));
    }
    if (name.equals(NEAR_RANGE)) {
      return Optional.of(nearRange());
    }
    return Scenes.labels(setup.scene()).stream()
        .filter(label -> name.endsWith(":" + label))
        .flatMap(label -> Stream.of(strength(label), path(label), nearField(setup, label)))
        .filter(form -> form.name().equals(name))
        .findFirst();
  }

  private static String at(String name, double place) {
    return String.format(Locale.ROOT, "%s_at_%s", name, place);
  }

  private static Form form(String name, Form.Maker maker, List<Parameter> parameters) {
    return new Form(Optional.empty(), name, parameters, maker);
  }
}
