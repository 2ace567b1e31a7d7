package simbad.blindworld.effect;

import static simbad.blindworld.effect.Changes.echo;
import static simbad.blindworld.effect.Changes.echoes;
import static simbad.blindworld.effect.Changes.isEcho;

import java.util.List;
import java.util.Map;
import java.util.function.Function;
import simbad.blindworld.effect.Changes.Length;
import simbad.blindworld.effect.Form.Drawn;
import simbad.blindworld.world.Ping;

/** Echoes that are not the nearest obstacle's: crosstalk, multipath, floor-echo, previous-ping. */
final class ArrivalForms {

  private static final double NEAREST_M = 0.05;

  /** Air of 20 degrees. */
  private static final double SOUND_M_PER_S = 343.2;

  private static final double RANGES = 4;

  private ArrivalForms() {}

  static List<Form> all() {
    return List.of(
        Form.anywhere("crosstalk", "any", ArrivalForms::crosstalk),
        Form.anywhere("crosstalk", "nearer", ArrivalForms::crosstalkNearer),
        Form.anywhere("crosstalk", "when silent", ArrivalForms::crosstalkSilent),
        Form.anywhere("crosstalk", "clustered", ArrivalForms::crosstalkClustered),
        Form.anywhere("crosstalk", "beat", ArrivalForms::crosstalkBeat),
        Form.anywhere("multipath", "additive", ArrivalForms::longer),
        Form.anywhere("multipath", "factor", ArrivalForms::factor),
        Form.anywhere("multipath", "mixture", ArrivalForms::mixture),
        Form.anywhere("multipath", "tail", ArrivalForms::tail),
        Form.anywhere("floor-echo", "from the mount", ArrivalForms::floorFromMount),
        Form.anywhere("floor-echo", "fixed", ArrivalForms::floorFixed),
        Form.anywhere("floor-echo", "two joints", ArrivalForms::floorJoints),
        stale("second bounce", ArrivalForms::secondBounce),
        stale("share", ArrivalForms::share),
        stale("constant sum", ArrivalForms::constantSum));
  }

  /** Where a ping's echoes can still be heard when the next one listens. */
  private static Form stale(String label, Function<Circumstances, Drawn> draw) {
    return new Form("previous-ping", label, ArrivalForms::isStillHeard, draw);
  }

  /**
   * Half of the way that sound goes from ping to ping is at most four times the sensor's range:
   * spreading takes 40 log10(4), that is 24 dB, and from there on no room answers.
   */
  private static boolean isStillHeard(Circumstances c) {
    double wayM = SOUND_M_PER_S * c.recording().periodS() / 2;
    return wayM <= RANGES * c.sensor().maxRangeM();
  }

  private static double reachM(Circumstances c) {
    return c.sensor().maxRangeM() * c.between(0.5, 0.95);
  }

  private static boolean happens(Ping ping, double chance) {
    return ping.random().nextDouble() < chance;
  }

  private static double anywhere(Ping ping, double reachM) {
    return NEAREST_M + ping.random().nextDouble() * (reachM - NEAREST_M);
  }

  private static Drawn crosstalk(Circumstances c) {
    double p = c.sized(0.06);
    double reach = reachM(c);
    return new Drawn(
        Map.of("p", p, "hi", reach),
        echo((d, ping) -> happens(ping, p) ? anywhere(ping, reach) : d));
  }

  private static Drawn crosstalkNearer(Circumstances c) {
    double p = c.sized(0.07);
    double reach = reachM(c);
    return new Drawn(
        Map.of("p", p, "hi", reach),
        echo((d, ping) -> happens(ping, p) ? Math.min(d, anywhere(ping, reach)) : d));
  }

  private static Drawn crosstalkSilent(Circumstances c) {
    double p = c.sized(0.08);
    double reach = reachM(c);
    return new Drawn(
        Map.of("p", p, "hi", reach),
        echo((d, ping) -> !isEcho(d) && happens(ping, p) ? anywhere(ping, reach) : d));
  }

  /** The other sonar is near for a while: a chain of two states. */
  private static Drawn crosstalkClustered(Circumstances c) {
    double begins = c.sized(0.012);
    double ends = c.between(0.15, 0.35);
    double reach = reachM(c);
    return new Drawn(
        Map.of("begins", begins, "ends", ends, "hi", reach),
        echoes(
            () -> {
              Chain chain = new Chain(begins, ends);
              return (d, ping) -> {
                boolean on = chain.next(ping) && happens(ping, 0.8);
                return on ? Math.min(d, anywhere(ping, reach)) : d;
              };
            }));
  }

  /** Another clock's pings walk through this one's listening time. */
  private static Drawn crosstalkBeat(Circumstances c) {
    double p = c.sized(0.1);
    double reach = reachM(c);
    double perPing = c.between(0.037, 0.21);
    return new Drawn(
        Map.of("p", p, "hi", reach, "walk_m", perPing),
        echo(
            (d, ping) -> {
              double at = NEAREST_M + (ping.indexInTrack() * perPing) % (reach - NEAREST_M);
              return happens(ping, p) ? Math.min(d, at) : d;
            }));
  }

  private static Drawn late(Circumstances c, Map<String, Object> parameters, Length path) {
    double maxM = c.sensor().maxRangeM();
    return new Drawn(
        parameters,
        echo(
            (d, ping) -> {
              double longer = isEcho(d) ? path.of(d, ping) : d;
              return longer <= maxM ? longer : Double.POSITIVE_INFINITY;
            }));
  }

  private static Drawn longer(Circumstances c) {
    double p = c.sized(0.14);
    double extra = c.between(0.15, 0.5);
    double sd = c.between(0.01, 0.05);
    return late(
        c,
        Map.of("p", p, "extra", extra, "sd", sd),
        (d, ping) ->
            happens(ping, p) ? d + Math.max(0, extra + sd * ping.random().nextGaussian()) : d);
  }

  private static Drawn factor(Circumstances c) {
    double p = c.sized(0.14);
    double factor = c.between(1.2, 2);
    return late(
        c,
        Map.of("p", p, "factor", factor),
        (d, ping) ->
            happens(ping, p) ? d * Math.max(1, factor + 0.02 * ping.random().nextGaussian()) : d);
  }

  private static Drawn mixture(Circumstances c) {
    double p = c.sized(0.15);
    double extra = c.between(0.12, 0.4);
    double factor = c.between(1.3, 2.1);
    return late(
        c,
        Map.of("p", p, "extra", extra, "factor", factor),
        (d, ping) -> {
          if (!happens(ping, p)) {
            return d;
          }
          return ping.random().nextBoolean() ? d + extra : d * factor;
        });
  }

  /** Many ways, the longer the rarer. */
  private static Drawn tail(Circumstances c) {
    double p = c.sized(0.2);
    double mean = c.between(0.15, 0.4);
    return late(
        c,
        Map.of("p", p, "mean_extra", mean),
        (d, ping) ->
            happens(ping, p) ? d - mean * StrictMath.log(1 - ping.random().nextDouble()) : d);
  }

  private static Drawn floor(Map<String, Object> parameters, double p, double sd, Length range) {
    return new Drawn(
        parameters,
        echo(
            (d, ping) -> {
              if (!happens(ping, p)) {
                return d;
              }
              return Math.min(d, range.of(d, ping) + sd * ping.random().nextGaussian());
            }));
  }

  /** Where the lower rim of the cone, or a little inside it, meets the floor. */
  private static Drawn floorFromMount(Circumstances c) {
    double p = Math.min(1, c.sized(0.5));
    double rim = c.sensor().halfAngleRad() * c.between(0.55, 1);
    double slant =
        Math.min(0.9 * c.sensor().maxRangeM(), c.sensor().mountHeightM() / StrictMath.sin(rim));
    return floor(Map.of("p", p, "m", slant, "sd", 0.012), p, 0.012, (d, ping) -> slant);
  }

  private static Drawn floorFixed(Circumstances c) {
    double p = Math.min(1, c.sized(0.45));
    double at = c.between(0.6, 0.6 * c.sensor().maxRangeM());
    double sd = c.between(0.008, 0.035);
    return floor(Map.of("p", p, "m", at, "sd", sd), p, sd, (d, ping) -> at);
  }

  private static Drawn floorJoints(Circumstances c) {
    double p = Math.min(1, c.sized(0.45));
    double at = c.between(0.6, 0.5 * c.sensor().maxRangeM());
    double apart = c.between(0.03, 0.09);
    return floor(
        Map.of("p", p, "m", at, "apart_m", apart),
        p,
        0.01,
        (d, ping) -> ping.random().nextBoolean() ? at : at + apart);
  }

  /** A burst that comes later than anything is listened for is none. */
  private static Drawn previous(
      Circumstances c, Map<String, Object> parameters, double p, Length candidate) {
    double latestM = c.sensor().maxRangeM();
    return new Drawn(
        parameters,
        echo(
            (d, ping) -> {
              if (!isEcho(ping.lastReadingM()) || !happens(ping, p)) {
                return d;
              }
              double other = candidate.of(d, ping);
              return other > NEAREST_M && other < Math.min(d, latestM) ? other : d;
            }));
  }

  /** The former burst went twice to the obstacle and arrives a ping later. */
  private static Drawn secondBounce(Circumstances c) {
    double p = Math.min(1, c.sized(0.45));
    double gap = 2 * c.distanceM(0.5) - c.distanceM(0.5) * c.between(0.3, 0.8);
    return previous(c, Map.of("p", p, "gap_m", gap), p, (d, ping) -> 2 * ping.lastReadingM() - gap);
  }

  private static Drawn share(Circumstances c) {
    double p = Math.min(1, c.sized(0.4));
    double share = c.between(0.35, 0.75);
    double plus = c.between(-0.08, 0.08);
    return previous(
        c,
        Map.of("p", p, "share", share, "plus_m", plus),
        p,
        (d, ping) -> share * ping.lastReadingM() + plus);
  }

  /** Two readings in a row that add up to a constant less than twice the distance. */
  private static Drawn constantSum(Circumstances c) {
    double p = Math.min(1, c.sized(0.45));
    double less = c.between(0.1, 0.45);
    return previous(
        c,
        Map.of("p", p, "less_m", less),
        p,
        (d, ping) -> isEcho(d) ? 2 * d - ping.lastReadingM() - less : d);
  }
}
