package simbad.blindworld.effect;

import static simbad.blindworld.effect.Changes.range;

import java.util.List;
import java.util.Map;
import java.util.random.RandomGenerator;
import simbad.blindworld.effect.Form.Drawn;
import simbad.blindworld.world.Change;
import simbad.blindworld.world.Hearing;
import simbad.blindworld.world.Ping;

/** Effects on the range of an echo: sound-speed, range-offset, range-noise. */
final class RangeForms {

  private static final double ZERO_C_SPEED = 331.3;
  private static final double ZERO_C_K = 273.15;

  private RangeForms() {}

  static List<Form> all() {
    return List.of(
        Form.anywhere("sound-speed", "speed", RangeForms::speed),
        Form.anywhere("sound-speed", "temperature", RangeForms::temperature),
        Form.anywhere("sound-speed", "time-out in time", RangeForms::timedOut),
        Form.anywhere("range-offset", "constant", RangeForms::offset),
        Form.anywhere("range-offset", "trigger", RangeForms::trigger),
        Form.anywhere("range-noise", "gaussian", RangeForms::gaussian),
        Form.anywhere("range-noise", "growing", RangeForms::growing),
        Form.anywhere("range-noise", "tails", RangeForms::tails),
        Form.anywhere("range-noise", "even", RangeForms::even));
  }

  private static Drawn speed(Circumstances c) {
    double speed = c.sensor().soundSpeedMPerS() * (1 + c.eitherWay(0.03));
    double factor = c.sensor().soundSpeedMPerS() / speed;
    return new Drawn(Map.of("c", speed), range((r, ping) -> r * factor));
  }

  private static Drawn temperature(Circumstances c) {
    double assumed = c.sensor().soundSpeedMPerS();
    double believedK = ZERO_C_K * StrictMath.pow(assumed / ZERO_C_SPEED, 2);
    double kelvin = believedK + c.eitherWay(19);
    double factor = Math.sqrt(believedK / kelvin);
    return new Drawn(
        Map.of("temperature_c", kelvin - ZERO_C_K, "c", assumed / factor),
        range((r, ping) -> r * factor));
  }

  /** The time-out is a time: with another speed it lies at another distance as well. */
  private static Drawn timedOut(Circumstances c) {
    double factor = 1 + c.eitherWay(0.03);
    double maxM = c.sensor().maxRangeM();
    Hearing hearing =
        new Hearing() {
          @Override
          public double echoM(double distanceM, Ping ping) {
            return distanceM * factor > maxM ? Double.POSITIVE_INFINITY : distanceM;
          }

          @Override
          public double rangeM(double rangeM, Ping ping) {
            return rangeM * factor;
          }
        };
    return new Drawn(Map.of("c", c.sensor().soundSpeedMPerS() / factor), Changes.hearing(hearing));
  }

  private static Drawn offset(Circumstances c) {
    double offset = c.eitherWay(0.04);
    return new Drawn(Map.of("m", offset), range((r, ping) -> r + offset));
  }

  /** The clock starts too early or late, a little differently each time. */
  private static Drawn trigger(Circumstances c) {
    double offset = c.eitherWay(0.045);
    double jitter = Math.abs(offset) * 0.12;
    return new Drawn(
        Map.of("m", offset, "jitter_m", jitter),
        range((r, ping) -> r + offset + jitter * ping.random().nextDouble(-1, 1)));
  }

  private static Drawn gaussian(Circumstances c) {
    double sd = c.sized(0.035);
    return scatter(Map.of("added_sd", sd), (r, random) -> sd * random.nextGaussian());
  }

  private static Drawn growing(Circumstances c) {
    double perM = c.sized(0.03);
    return scatter(Map.of("added_sd_per_m", perM), (r, random) -> perM * r * random.nextGaussian());
  }

  /** Student's t with three degrees of freedom, as a Gaussian of random scale. */
  private static Drawn tails(Circumstances c) {
    double scale = c.sized(0.022);
    return scatter(
        Map.of("t3_scale", scale),
        (r, random) -> {
          double chi2 = 0;
          for (int i = 0; i < 3; i++) {
            chi2 += StrictMath.pow(random.nextGaussian(), 2);
          }
          return scale * random.nextGaussian() / Math.sqrt(chi2 / 3);
        });
  }

  private static Drawn even(Circumstances c) {
    double half = c.sized(0.06);
    return scatter(Map.of("half_width", half), (r, random) -> half * (2 * random.nextDouble() - 1));
  }

  private interface Scatter {
    double at(double rangeM, RandomGenerator random);
  }

  private static Drawn scatter(Map<String, Object> parameters, Scatter scatter) {
    Change change = range((r, ping) -> r + scatter.at(r, ping.random()));
    return new Drawn(parameters, change);
  }
}
