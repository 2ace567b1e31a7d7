package simbad.blindworld.effect;

import static simbad.blindworld.effect.Changes.isEcho;
import static simbad.blindworld.effect.Changes.report;
import static simbad.blindworld.effect.Changes.reports;
import static simbad.blindworld.effect.Changes.step;

import java.util.List;
import java.util.Map;
import simbad.blindworld.effect.Changes.Length;
import simbad.blindworld.effect.Form.Drawn;
import simbad.blindworld.world.Ping;

/** Effects on what is reported: coarse-resolution, near-clamp, stale-reading. */
final class OutputForms {

  private OutputForms() {}

  static List<Form> all() {
    return List.of(
        Form.anywhere("coarse-resolution", "start", OutputForms::start),
        Form.anywhere("coarse-resolution", "centre", OutputForms::centre),
        Form.anywhere("coarse-resolution", "nearest", OutputForms::nearest),
        Form.anywhere("coarse-resolution", "odd step", OutputForms::odd),
        Form.anywhere("near-clamp", "before steps", OutputForms::clampRange),
        Form.anywhere("near-clamp", "after steps", OutputForms::clampReading),
        Form.anywhere("stale-reading", "count", OutputForms::staleCount),
        Form.anywhere("stale-reading", "duration", OutputForms::staleDuration),
        Form.anywhere("stale-reading", "fading", OutputForms::staleFading));
  }

  /** Several times the believed step, a multiple of it; the believed step when the size is 0. */
  private static double multiple(Circumstances c) {
    double step = c.sensor().resolutionM();
    double wanted = Math.max(c.sized(0.045), 2 * step * Math.min(1, c.strength() * 1e9));
    return Math.max(1, Math.round(wanted / step)) * step;
  }

  private static Drawn start(Circumstances c) {
    double step = multiple(c);
    return new Drawn(Map.of("m", step), step(r -> Math.floor(r / step) * step));
  }

  private static Drawn centre(Circumstances c) {
    double step = multiple(c);
    double shift = c.strength() > 0 ? step / 2 : 0;
    return new Drawn(Map.of("m", step), step(r -> Math.floor(r / step) * step + shift));
  }

  private static Drawn nearest(Circumstances c) {
    double step = multiple(c);
    double half = c.strength() > 0 ? 0.5 : 0;
    return new Drawn(Map.of("m", step), step(r -> Math.floor(r / step + half) * step));
  }

  /** Ticks of a clock: no multiple of the believed step, truncated to that step when printed. */
  private static Drawn odd(Circumstances c) {
    double fine = c.sensor().resolutionM();
    double step = c.strength() > 0 ? multiple(c) * c.between(1.07, 1.43) : fine;
    return new Drawn(
        Map.of("m", step), step(r -> Math.floor(Math.floor(r / step) * step / fine + 1e-6) * fine));
  }

  private static double clampM(Circumstances c) {
    return c.strength() > 0 ? c.distanceM(Math.min(0.7, c.sized(0.25))) : 0;
  }

  private static Drawn clampRange(Circumstances c) {
    double least = clampM(c);
    double fine = c.sensor().resolutionM();
    return new Drawn(Map.of("m", least), step(r -> Math.floor(Math.max(r, least) / fine) * fine));
  }

  private static Drawn clampReading(Circumstances c) {
    double least = clampM(c);
    return new Drawn(Map.of("m", least), report((r, ping) -> isEcho(r) ? Math.max(r, least) : r));
  }

  private static Drawn staleCount(Circumstances c) {
    int count = (int) Math.round(c.sized(4));
    return new Drawn(Map.of("n", count), reports(() -> new Held(count, Double.MAX_VALUE, 1)));
  }

  private static Drawn staleDuration(Circumstances c) {
    double duration = c.sized(4.4) * c.recording().periodS();
    return new Drawn(
        Map.of("s", duration), reports(() -> new Held(Integer.MAX_VALUE, duration, 1)));
  }

  /** Held with a chance each time, until it is let go. */
  private static Drawn staleFading(Circumstances c) {
    double chance = c.strength() > 0 ? 1 - 0.25 / c.strength() : 0;
    return new Drawn(
        Map.of("chance", chance), reports(() -> new Held(Integer.MAX_VALUE, 1e9, chance)));
  }

  /** Repeats the last real reading on misses. */
  private static final class Held implements Length {

    private final int count;
    private final double durationS;
    private final double chance;
    private double heldM = Double.POSITIVE_INFINITY;
    private double sinceS;
    private int used;

    Held(int count, double durationS, double chance) {
      this.count = count;
      this.durationS = durationS;
      this.chance = chance;
    }

    @Override
    public double of(double readingM, Ping ping) {
      if (isEcho(readingM)) {
        heldM = readingM;
        sinceS = ping.tS();
        used = 0;
        return readingM;
      }
      used++;
      boolean holds =
          used <= count
              && ping.tS() - sinceS <= durationS
              && (chance >= 1 || ping.random().nextDouble() < chance);
      if (!holds) {
        heldM = Double.POSITIVE_INFINITY;
      }
      return heldM;
    }
  }
}
