package simbad.blindworld.effect;

import static simbad.blindworld.effect.Changes.isEcho;
import static simbad.blindworld.effect.Changes.range;
import static simbad.blindworld.effect.Changes.report;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleUnaryOperator;
import simbad.blindworld.effect.Form.Drawn;
import simbad.blindworld.world.Hearing;
import simbad.blindworld.world.Ping;
import simbad.blindworld.world.Sight;

/**
 * The names that joined the vocabulary in its second version: range-drift, no-echo-code, wrap,
 * range-walk, vertical-beam. They are drawn only where somebody asks for them, so that older draws
 * keep their bytes. wave-hop needs millimetres, which these worlds do not tell; placement-error is
 * in {@link PlacementForms}.
 */
final class FurtherForms {

  private FurtherForms() {}

  static List<Form> all() {
    return List.of(
        Form.anywhere("range-drift", "settling", FurtherForms::settling),
        Form.anywhere("range-drift", "steady", FurtherForms::steady),
        Form.anywhere("range-drift", "warming", FurtherForms::warming),
        Form.anywhere("no-echo-code", "nought", c -> code(c, 0)),
        Form.anywhere("no-echo-code", "end", c -> code(c, c.sensor().maxRangeM())),
        Form.anywhere("wrap", "counter", FurtherForms::counter),
        Form.anywhere("wrap", "printed", FurtherForms::printed),
        walk("straight rise", part -> part * part),
        walk("swelling", part -> -StrictMath.log(1 - 0.9 * part * part) / StrictMath.log(10)),
        Form.anywhere("vertical-beam", "slanting", c -> high(c, false)),
        Form.anywhere("vertical-beam", "over the beam", c -> high(c, true)));
  }

  private static double spanS(Circumstances c) {
    return Math.max(1, c.recording().longestS());
  }

  private static Drawn settling(Circumstances c) {
    double m = c.eitherWay(0.06);
    double timeS = spanS(c) * c.between(0.1, 0.4);
    return new Drawn(
        Map.of("m", m, "time_s", timeS),
        range((r, ping) -> r + m * (1 - StrictMath.exp(-ping.tS() / timeS))));
  }

  private static Drawn steady(Circumstances c) {
    double perS = c.eitherWay(0.08) / spanS(c);
    return new Drawn(Map.of("m_per_s", perS), range((r, ping) -> r + perS * ping.tS()));
  }

  /** The air warms: by a share of the range that grows to its end, not by a length. */
  private static Drawn warming(Circumstances c) {
    double share = c.eitherWay(0.05);
    double timeS = spanS(c) * c.between(0.1, 0.4);
    return new Drawn(
        Map.of("share", share, "time_s", timeS),
        range((r, ping) -> r * (1 + share * (1 - StrictMath.exp(-ping.tS() / timeS)))));
  }

  /** Of the silences a share is reported as a number; all of them at the practical size. */
  private static Drawn code(Circumstances c, double numberM) {
    double share = Math.min(1, c.sized(1));
    return new Drawn(
        Map.of("m", numberM, "share", share),
        report((r, ping) -> isEcho(r) || ping.random().nextDouble() >= share ? r : numberM));
  }

  /** Beyond the nearest three quarters of what is heard, at the practical size. */
  private static double modulusM(Circumstances c) {
    return c.strength() > 0
        ? c.distanceM(Math.max(0.2, 1 - c.sized(0.25)))
        : Double.POSITIVE_INFINITY;
  }

  private static double wrapped(double lengthM, double modulusM) {
    return isEcho(lengthM) && lengthM >= modulusM
        ? lengthM - modulusM * Math.floor(lengthM / modulusM)
        : lengthM;
  }

  private static Drawn counter(Circumstances c) {
    double modulus = modulusM(c);
    return new Drawn(Map.of("m", modulus), range((r, ping) -> wrapped(r, modulus)));
  }

  private static Drawn printed(Circumstances c) {
    double modulus = modulusM(c);
    return new Drawn(Map.of("m", modulus), report((r, ping) -> wrapped(r, modulus)));
  }

  /**
   * A weak echo passes the comparator later. How weak it is, is told by its distance in parts of
   * the threshold, beyond which it counts as just heard. With one threshold for all bearings this
   * depends on the distance alone, as other effects do.
   *
   * @param shape from 0 for a strong echo to 1 at the threshold
   */
  private static Form walk(String label, DoubleUnaryOperator shape) {
    return new Form(
        "range-walk",
        label,
        Circumstances::someTable,
        c -> {
          double m = c.sized(0.06);
          return new Drawn(Map.of("m", m), Changes.perTrack(() -> new Walk(m, shape)));
        });
  }

  /** Remembers how weak the echo of each obstacle is, until it is known which one is read. */
  private static final class Walk implements Hearing {

    private final double mostM;
    private final DoubleUnaryOperator shape;
    private final Map<Double, Double> lateM = new HashMap<>();
    private int row = -1;
    private double readLateM;

    Walk(double mostM, DoubleUnaryOperator shape) {
      this.mostM = mostM;
      this.shape = shape;
    }

    @Override
    public double thresholdM(double thresholdM, Sight sight, Ping ping) {
      if (ping.row() != row) {
        row = ping.row();
        lateM.clear();
      }
      double part = thresholdM > 0 ? Math.min(1, sight.centreM() / thresholdM) : 1;
      lateM.put(sight.distanceM(), mostM * shape.applyAsDouble(part));
      return thresholdM;
    }

    @Override
    public double echoM(double distanceM, Ping ping) {
      readLateM = lateM.getOrDefault(distanceM, 0.0);
      return distanceM;
    }

    @Override
    public double rangeM(double rangeM, Ping ping) {
      return rangeM + readLateM;
    }
  }

  /**
   * The target ends above or below the sonar, by so much at its nearest: the way there slants.
   *
   * @param isCut whether it is also over or under the beam where it is near
   */
  private static Drawn high(Circumstances c, boolean isCut) {
    double m = c.sized(0.2);
    double nearestM = isCut ? m / StrictMath.tan(c.sensor().halfAngleRad()) : 0;
    Hearing hearing =
        new Hearing() {
          @Override
          public double thresholdM(double thresholdM, Sight sight, Ping ping) {
            return sight.distanceM() < nearestM ? 0 : thresholdM;
          }

          @Override
          public double rangeM(double rangeM, Ping ping) {
            return Math.sqrt(rangeM * rangeM + m * m);
          }
        };
    return new Drawn(Map.of("m", m), Changes.hearing(hearing));
  }
}
