package simbad.blindworld.effect;

import static simbad.blindworld.effect.Changes.threshold;

import java.util.List;
import java.util.Map;
import java.util.function.DoubleUnaryOperator;
import simbad.blindworld.effect.Form.Drawn;

/** Effects on the strength of echoes: gain, absorption, beam-pattern, hysteresis. */
final class EnergyForms {

  private static final double DB_PER_NEPER = 20 / StrictMath.log(10);

  private EnergyForms() {}

  static List<Form> all() {
    return List.of(
        Form.anywhere("gain", "factor", EnergyForms::gainFactor),
        Form.anywhere("gain", "decibels", EnergyForms::gainDecibels),
        Form.anywhere("gain", "fluttering", EnergyForms::gainFlutter),
        Form.anywhere("absorption", "exponential", EnergyForms::exponential),
        Form.anywhere("absorption", "sonar equation", EnergyForms::sonarEquation),
        Form.anywhere("absorption", "rational", EnergyForms::rational),
        beam("cosine", e -> u -> StrictMath.cos(u * StrictMath.acos(e))),
        beam("gaussian", e -> u -> StrictMath.pow(e, u * u)),
        beam("linear", e -> u -> 1 - (1 - e) * u),
        beam("flat top", e -> u -> 1 - (1 - e) * Math.max(0, (u - 0.4) / 0.6)),
        beam("fourth power", e -> u -> 1 - (1 - e) * u * u * u * u),
        beam("sinc", EnergyForms::sinc),
        Form.anywhere("hysteresis", "both ways", EnergyForms::bothWays),
        Form.anywhere("hysteresis", "pick-up only", EnergyForms::pickUp),
        Form.anywhere("hysteresis", "metres", EnergyForms::metres));
  }

  private static Drawn gainFactor(Circumstances c) {
    double k = StrictMath.exp(c.eitherWay(0.14));
    return new Drawn(Map.of("k", k), threshold((t, sight, ping) -> t * k));
  }

  /** Spherical spreading both ways: 40 dB of level are ten times the distance. */
  private static Drawn gainDecibels(Circumstances c) {
    double decibels = c.eitherWay(2.4);
    double k = StrictMath.pow(10, decibels / 40);
    return new Drawn(Map.of("db", decibels, "k", k), threshold((t, sight, ping) -> t * k));
  }

  private static Drawn gainFlutter(Circumstances c) {
    double k = StrictMath.exp(c.eitherWay(0.16));
    double flutter = Math.abs(StrictMath.log(k)) * 0.12;
    return new Drawn(
        Map.of("k", k, "flutter", flutter),
        threshold((t, sight, ping) -> t * k * (1 + flutter * ping.random().nextGaussian())));
  }

  private static Drawn exponential(Circumstances c) {
    double perM = c.sized(0.14);
    return new Drawn(
        Map.of("per_m", perM), threshold((t, sight, ping) -> t * StrictMath.exp(-perM * t)));
  }

  /** Solves 40 log10(r / t) + 2 a r = 0 for r by Newton's rule in log r, where it is convex. */
  private static Drawn sonarEquation(Circumstances c) {
    double dbPerM = c.sized(1.5);
    return new Drawn(
        Map.of("db_per_m", dbPerM), threshold((t, sight, ping) -> attenuatedM(t, dbPerM)));
  }

  static double attenuatedM(double thresholdM, double dbPerM) {
    if (thresholdM <= 0 || dbPerM == 0) {
      return thresholdM;
    }
    double slope = 2 * DB_PER_NEPER;
    double log = StrictMath.log(thresholdM);
    double x = log;
    for (int i = 0; i < 6; i++) {
      double loss = 2 * dbPerM * StrictMath.exp(x);
      x -= (slope * (x - log) + loss) / (slope + loss);
    }
    return StrictMath.exp(x);
  }

  private static Drawn rational(Circumstances c) {
    double perM = c.sized(0.16);
    return new Drawn(Map.of("per_m", perM), threshold((t, sight, ping) -> t / (1 + perM * t)));
  }

  private interface Taper {
    /** The factor by the share of the half-angle, given what it is at the edge. */
    DoubleUnaryOperator reaching(double edge);
  }

  private static Form beam(String label, Taper taper) {
    return Form.anywhere(
        "beam-pattern",
        label,
        c -> {
          double edge = StrictMath.exp(-c.sized(0.6));
          double halfRad = c.sensor().halfAngleRad();
          DoubleUnaryOperator shape = taper.reaching(edge);
          DoubleUnaryOperator factor = u -> Math.max(0, shape.applyAsDouble(Math.min(1.5, u)));
          return new Drawn(
              Map.of("at_edge", edge),
              threshold(
                  (t, s, ping) -> t * factor.applyAsDouble(Math.abs(s.offAxisRad()) / halfRad)));
        });
  }

  /** A main lobe as of a line of sources; its width is found by halving. */
  private static DoubleUnaryOperator sinc(double edge) {
    double low = 0;
    double high = Math.PI;
    for (int i = 0; i < 30 && edge < 1; i++) {
      double middle = (low + high) / 2;
      if (StrictMath.sin(middle) / middle > edge) {
        low = middle;
      } else {
        high = middle;
      }
    }
    double width = low;
    return u -> u * width == 0 ? 1 : Math.abs(StrictMath.sin(u * width) / (u * width));
  }

  private static Drawn bothWays(Circumstances c) {
    double k = c.sized(0.18);
    return new Drawn(
        Map.of("k", k),
        threshold((t, s, ping) -> t * (1 + (ping.heardBefore(s.body()) ? k / 2 : -k / 2))));
  }

  private static Drawn pickUp(Circumstances c) {
    double k = Math.min(0.8, c.sized(0.18));
    return new Drawn(
        Map.of("k", k), threshold((t, s, ping) -> ping.heardBefore(s.body()) ? t : t * (1 - k)));
  }

  private static Drawn metres(Circumstances c) {
    double width = c.sized(0.25);
    return new Drawn(
        Map.of("m", width),
        threshold(
            (t, s, ping) ->
                t <= 0 || ping.heardBefore(s.body()) ? t : Math.max(0.3 * t, t - width)));
  }
}
