package simbad.blindworld.effect;

import static simbad.blindworld.effect.Changes.echo;
import static simbad.blindworld.effect.Changes.echoes;

import java.util.List;
import java.util.Map;
import simbad.blindworld.effect.Form.Drawn;
import simbad.blindworld.world.Chance;
import simbad.blindworld.world.Change;
import simbad.blindworld.world.Hearing;
import simbad.blindworld.world.Ping;
import simbad.blindworld.world.Recording;
import simbad.blindworld.world.Sight;
import simbad.blindworld.world.Track;

/** Effects that lose echoes: dropout, dead-zone, early-timeout. */
final class GateForms {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  private GateForms() {}

  static List<Form> all() {
    return List.of(
        Form.anywhere("dropout", "single", GateForms::single),
        Form.anywhere("dropout", "bursts", GateForms::bursts),
        Form.anywhere("dropout", "swelling", GateForms::swelling),
        Form.anywhere("dropout", "all transducers", GateForms::together),
        Form.anywhere("dead-zone", "sharp", GateForms::deadSharp),
        Form.anywhere("dead-zone", "soft", GateForms::deadSoft),
        Form.anywhere("dead-zone", "ramp", GateForms::deadRamp),
        Form.anywhere("early-timeout", "sharp", GateForms::timeoutSharp),
        Form.anywhere("early-timeout", "soft", GateForms::timeoutSoft),
        Form.anywhere("early-timeout", "jittered", GateForms::timeoutJittered));
  }

  private static Drawn single(Circumstances c) {
    double p = Math.min(0.9, c.sized(0.2));
    return new Drawn(Map.of("p", p), echo((d, ping) -> ping.random().nextDouble() < p ? NEVER : d));
  }

  private static Drawn bursts(Circumstances c) {
    double length = c.between(3, 14);
    double share = Math.min(0.7, c.sized(0.2));
    double begins = share / (1 - share) / length;
    return new Drawn(
        Map.of("share", share, "mean_length", length),
        echoes(
            () -> {
              Chain chain = new Chain(begins, 1 / length);
              return (d, ping) -> chain.next(ping) ? NEVER : d;
            }));
  }

  /** The chance of a miss itself wanders, one memory for each transducer. */
  private static Drawn swelling(Circumstances c) {
    double most = Math.min(0.95, c.sized(0.4));
    double keeps = 1 - 1 / c.between(8, 40);
    return new Drawn(
        Map.of("most", most, "keeps", keeps),
        echoes(
            () -> {
              double[] level = {0};
              return (d, ping) -> {
                double fresh = ping.random().nextGaussian();
                boolean first = ping.indexInTrack() == 0;
                level[0] = first ? fresh : keeps * level[0] + Math.sqrt(1 - keeps * keeps) * fresh;
                double chance = most / (1 + StrictMath.exp(-2 * level[0]));
                return ping.random().nextDouble() < chance ? NEVER : d;
              };
            }));
  }

  /** Windows of silence at random times of a run, the same for every transducer. */
  private static Drawn together(Circumstances c) {
    double lengthS = c.between(4, 12) * c.recording().periodS();
    double share = Math.min(0.7, c.sized(0.2));
    Change change =
        new Change() {
          @Override
          public Hearing hearing(Recording recording, Track track, long repeatSeed) {
            long seed = repeatSeed ^ (31L * track.run().hashCode());
            return Changes.onEcho(
                (d, ping) -> isSilent(ping.tS(), lengthS, share, seed) ? NEVER : d);
          }
        };
    return new Drawn(Map.of("share", share, "length_s", lengthS), change);
  }

  private static boolean isSilent(double tS, double lengthS, double share, long seed) {
    long window = (long) Math.floor(tS / lengthS);
    return new Chance(seed + 0x9E3779B97F4A7C15L * window).nextDouble() < share;
  }

  private interface Loss {
    double chance(double distanceM);
  }

  /** Loses each obstacle's echo by itself, and whatever else answers, by distance. */
  private static Change lost(Loss loss) {
    return Changes.hearing(
        new Hearing() {
          @Override
          public double thresholdM(double thresholdM, Sight sight, Ping ping) {
            return happens(sight.distanceM(), ping) ? 0 : thresholdM;
          }

          @Override
          public double echoM(double distanceM, Ping ping) {
            double sure = distanceM < NEVER ? loss.chance(distanceM) : 0;
            return sure >= 1 ? NEVER : distanceM;
          }

          private boolean happens(double distanceM, Ping ping) {
            double chance = loss.chance(distanceM);
            return chance >= 1 || (chance > 0 && ping.random().nextDouble() < chance);
          }
        });
  }

  private static double nearM(Circumstances c) {
    return c.strength() > 0 ? c.distanceM(Math.min(0.7, c.sized(0.25))) : c.sensor().minRangeM();
  }

  private static Drawn deadSharp(Circumstances c) {
    double least = nearM(c);
    return new Drawn(Map.of("m", least), lost(d -> d < least ? 1 : 0));
  }

  private static Drawn deadSoft(Circumstances c) {
    double least = c.strength() > 0 ? nearM(c) : -10;
    double soft = c.between(0.02, 0.06);
    return new Drawn(
        Map.of("m", least, "soft_m", soft),
        lost(d -> d > least + 8 * soft ? 0 : 1 / (1 + StrictMath.exp((d - least) / soft))));
  }

  private static Drawn deadRamp(Circumstances c) {
    double least = nearM(c);
    double inner = least * c.between(0.4, 0.8);
    return new Drawn(
        Map.of("m", least, "inner_m", inner),
        lost(d -> Math.max(0, Math.min(1, (least - d) / (least - inner)))));
  }

  private static double farM(Circumstances c) {
    return c.strength() > 0
        ? c.distanceM(Math.max(0.3, 1 - c.sized(0.22)))
        : c.sensor().maxRangeM();
  }

  private static Drawn timeoutSharp(Circumstances c) {
    double most = farM(c);
    return new Drawn(Map.of("m", most), lost(d -> d > most ? 1 : 0));
  }

  private static Drawn timeoutSoft(Circumstances c) {
    double most = c.strength() > 0 ? farM(c) : 100;
    double soft = c.between(0.02, 0.06);
    return new Drawn(
        Map.of("m", most, "soft_m", soft),
        lost(d -> d < most - 8 * soft ? 0 : 1 / (1 + StrictMath.exp((most - d) / soft))));
  }

  private static Drawn timeoutJittered(Circumstances c) {
    double most = farM(c);
    double jitter = c.strength() > 0 ? most * c.between(0.02, 0.06) : 0;
    return new Drawn(
        Map.of("m", most, "jitter_m", jitter),
        echo((d, ping) -> d > most + jitter * (2 * ping.random().nextDouble() - 1) ? NEVER : d));
  }
}
