package simbad.sonar.format;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.DoublePredicate;
import simbad.sonar.level.Curve;
import simbad.sonar.level.LevelFigures;

/**
 * The fields of a sensor's {@code level}, all optional. A name that is none of them is refused: a
 * slip of the pen must not become a default. {@code source} may say where the figures are from.
 */
final class LevelFields {
  private static final String FREQUENCY = "frequency_hz";
  private static final String SPREADING = "spreading_exponent";
  private static final String ABSORPTION = "absorption_db_per_m";
  private static final String TEMPERATURE = "temperature_c";
  private static final String HUMIDITY = "humidity_percent";
  private static final String BEAM = "beam";
  private static final String APERTURE = "aperture_radius_m";
  private static final String TWO_WAY = "two_way_db";
  private static final String RECEIVER = "receiver_threshold_db";
  private static final String EXCESS_SD = "excess_sd_db";
  private static final String WALK = "walk_m";
  private static final String NOISE = "noise_m";
  private static final String PULSE = "pulse_length_s";
  private static final String LEVEL = "level_db";

  private static final List<String> NAMES =
      List.of(
          FREQUENCY,
          SPREADING,
          ABSORPTION,
          TEMPERATURE,
          HUMIDITY,
          BEAM,
          RECEIVER,
          EXCESS_SD,
          WALK,
          NOISE,
          PULSE,
          LEVEL,
          "source");

  private static final Range DECIBELS = new Range(-300, 300, "a level in [-300, 300] dB");
  private static final Range DEGREES = new Range(0, 180, "an angle in [0, 180] degrees");
  private static final Range DISTANCE = new Range(0, 1000, "a distance in [0, 1000] m");
  private static final Range SHIFT = new Range(-10, 10, "a length in [-10, 10] m");
  private static final Range LENGTH = new Range(0, 10, "a length in [0, 10] m");
  private static final Range EXPONENT = new Range(0, 10, "a number in [0, 10]");
  private static final Range LOSS = new Range(0, 100, "a number in [0, 100] dB per metre");
  private static final Range CELSIUS = new Range(-40, 60, "a temperature in [-40, 60] degrees");
  private static final Range PERCENT = new Range(0, 100, "a share in [0, 100] percent");
  private static final Range SPREAD = new Range(0, 300, "a number in [0, 300] dB");
  private static final Range DURATION = new Range(0, 1, "a time in [0, 1] s");

  /** Below any transducer in air and above any. */
  private static final Range HERTZ = new Range(1000, 1e6, "a frequency in [1000, 1e6] Hz");

  private static final Range RADIUS = new Range(1e-4, 1, "a radius in [0.0001, 1] m");

  private LevelFields() {}

  /** What a number may be. */
  private record Range(double least, double most, String words) implements DoublePredicate {
    @Override
    public boolean test(double value) {
      return value >= least && value <= most;
    }
  }

  static LevelFigures read(JsonInput level) throws DataFormatException {
    requireKnown(level, NAMES);
    Optional<JsonInput> beam = Optional.empty();
    if (level.has(BEAM)) {
      beam = Optional.of(beam(level.field(BEAM)));
    }
    return new LevelFigures(
        number(level, FREQUENCY, HERTZ),
        number(level, SPREADING, EXPONENT),
        number(level, ABSORPTION, LOSS),
        number(level, TEMPERATURE, CELSIUS),
        number(level, HUMIDITY, PERCENT),
        beam.isPresent() ? number(beam.get(), APERTURE, RADIUS) : OptionalDouble.empty(),
        beam.isPresent() ? curve(beam.get(), TWO_WAY, DEGREES, DECIBELS) : Optional.empty(),
        curve(level, RECEIVER, DISTANCE, DECIBELS),
        number(level, EXCESS_SD, SPREAD),
        curve(level, WALK, DECIBELS, SHIFT),
        curve(level, NOISE, DECIBELS, LENGTH),
        number(level, PULSE, DURATION),
        number(level, LEVEL, DECIBELS));
  }

  private static JsonInput beam(JsonInput beam) throws DataFormatException {
    requireKnown(beam, List.of(APERTURE, TWO_WAY));
    if (beam.has(APERTURE) == beam.has(TWO_WAY)) {
      throw beam.fault(
          (beam.has(APERTURE) ? "has both" : "has neither")
              + ", expected either "
              + APERTURE
              + " or "
              + TWO_WAY);
    }
    return beam;
  }

  private static void requireKnown(JsonInput object, List<String> names)
      throws DataFormatException {
    for (String name : object.names()) {
      if (!names.contains(name)) {
        throw object
            .field(name)
            .fault("is not a field here, expected some of " + String.join(", ", names));
      }
    }
  }

  private static OptionalDouble number(JsonInput object, String name, Range range)
      throws DataFormatException {
    return object.has(name)
        ? OptionalDouble.of(object.number(name, range, range.words()))
        : OptionalDouble.empty();
  }

  private static Optional<Curve> curve(JsonInput object, String name, Range x, Range y)
      throws DataFormatException {
    if (!object.has(name)) {
      return Optional.empty();
    }
    List<JsonInput> pairs = object.items(name);
    double[] points = new double[2 * pairs.size()];
    for (int i = 0; i < pairs.size(); i++) {
      JsonInput pair = pairs.get(i);
      if (!pair.isList() || pair.items().size() != 2) {
        throw pair.isNot("a pair [x, y] of a curve");
      }
      points[2 * i] = pair.items().get(0).number(x, x.words());
      points[2 * i + 1] = pair.items().get(1).number(y, y.words());
    }
    try {
      return Optional.of(Curve.of(points));
    } catch (IllegalArgumentException e) {
      throw object.field(name).fault(String.valueOf(e.getMessage()));
    }
  }

  static void write(ObjectNode node, LevelFigures level) {
    put(node, FREQUENCY, level.frequencyHz());
    put(node, SPREADING, level.spreadingExponent());
    put(node, ABSORPTION, level.absorptionDbPerM());
    put(node, TEMPERATURE, level.temperatureC());
    put(node, HUMIDITY, level.humidityPercent());
    if (level.apertureRadiusM().isPresent() || level.twoWayDb().isPresent()) {
      ObjectNode beam = node.putObject(BEAM);
      put(beam, APERTURE, level.apertureRadiusM());
      put(beam, TWO_WAY, level.twoWayDb());
    }
    put(node, RECEIVER, level.receiverThresholdDb());
    put(node, EXCESS_SD, level.excessSdDb());
    put(node, WALK, level.walkM());
    put(node, NOISE, level.noiseM());
    put(node, PULSE, level.pulseLengthS());
    put(node, LEVEL, level.levelDb());
  }

  private static void put(ObjectNode node, String name, OptionalDouble value) {
    value.ifPresent(number -> node.put(name, number));
  }

  private static void put(ObjectNode node, String name, Optional<Curve> curve) {
    curve.ifPresent(
        points -> {
          ArrayNode list = node.putArray(name);
          for (int i = 0; i < points.size(); i++) {
            list.addArray().add(points.x(i)).add(points.y(i));
          }
        });
  }
}
