package simbad.gap.audit;

import java.util.Arrays;
import java.util.Optional;
import java.util.stream.IntStream;
import simbad.gap.audit.AuditFinding.File;
import simbad.gap.fit.Robust;

/**
 * Single readings that are off by one and the same amount while those before and after are right: a
 * timer's byte that was read late, a constant that is added now and then.
 */
final class JumpCheck {
  /** 256 counts of a timer that counts microseconds. */
  private static final double BYTE_S = 256e-6;

  private static final int LEAST = 5;
  private static final double CORE = 4;

  /** So many windows the jumps could have been in, at least. */
  private static final double WINDOWS = 4;

  /** Noise has more jumps between its core and where they are densest; of the densest, so many. */
  private static final double BETWEEN = 0.5;

  private final AuditView view;
  private final double[] offM;
  private final double coreM;
  private final double windowM;

  JumpCheck(AuditView view) {
    this.view = view;
    offM = IntStream.range(0, view.size()).mapToDouble(this::off).toArray();
    double[] known = Arrays.stream(offM).filter(off -> !Double.isNaN(off)).toArray();
    double middle = Robust.median(known);
    Arrays.setAll(offM, i -> offM[i] - middle);
    double[] size = Arrays.stream(known).map(off -> Math.abs(off - middle)).toArray();
    double rough = 3 * Math.max(Robust.NORMAL_OVER_MAD * Robust.median(size), view.noiseM());
    // The median of steps is a step; the mean square of what is no jump is finer.
    double square =
        Arrays.stream(size).filter(off -> off <= rough).map(off -> off * off).average().orElse(0);
    double noise = Math.max(Math.sqrt(square), view.noiseM());
    coreM = CORE * noise;
    windowM = CORE / 2 * noise;
  }

  private double off(int i) {
    return view.isEcho(i) && view.isExpected(i) ? view.asM(i) - view.expectedM(i) : Double.NaN;
  }

  Optional<AuditFinding> find() {
    int[] jumps =
        IntStream.range(1, view.size() - 1)
            .filter(i -> Math.abs(offM[i]) > coreM)
            .filter(i -> view.follows(i) && view.follows(i + 1))
            .filter(i -> Math.abs(offM[i - 1]) <= coreM && Math.abs(offM[i + 1]) <= coreM)
            .toArray();
    double[] sizes = IntStream.of(jumps).mapToDouble(i -> offM[i]).sorted().toArray();
    if (sizes.length < LEAST) {
      return Optional.empty();
    }
    int from = densest(sizes);
    int hits = within(sizes, from);
    double size = Arrays.stream(sizes, from, from + hits).average().orElse(0);
    double span = Math.max(sizes[sizes.length - 1] - sizes[0], 2 * WINDOWS * windowM);
    boolean shows =
        hits >= LEAST
            && 2 * hits > sizes.length
            && !isTail(sizes, size, hits)
            && sizes.length * Tail.atLeast(hits, sizes.length, 2 * windowM / span) < Tail.LEVEL;
    return shows ? Optional.of(finding(jumps, size)) : Optional.empty();
  }

  /** Whether the core goes over into the jumps, as noise does. */
  private boolean isTail(double[] sizes, double size, int hits) {
    double low = size > 0 ? coreM : size + windowM;
    double high = size > 0 ? size - windowM : -coreM;
    long between = Arrays.stream(sizes).filter(one -> one > low && one < high).count();
    return Math.abs(size) < coreM + windowM || between > BETWEEN * hits;
  }

  private int densest(double[] sizes) {
    int best = 0;
    for (int from = 1; from < sizes.length; from++) {
      best = within(sizes, from) > within(sizes, best) ? from : best;
    }
    return best;
  }

  private int within(double[] sizes, int from) {
    int to = from;
    while (to < sizes.length && sizes[to] <= sizes[from] + 2 * windowM) {
      to++;
    }
    return to - from;
  }

  private AuditFinding finding(int[] jumps, double size) {
    int[] hits = IntStream.of(jumps).filter(i -> Math.abs(offM[i] - size) <= 2 * windowM).toArray();
    double byteM = BYTE_S * view.sensor().assumedSoundSpeedMPerS() / 2;
    double known = AuditView.AIR * byteM + windowM / Math.sqrt(hits.length);
    boolean isByte = Math.abs(Math.abs(size) - byteM) <= known;
    return new AuditFinding(
        AuditCheck.JUMP,
        File.READINGS,
        Say.readings(hits.length)
            + " alone among right ones are too "
            + (size > 0 ? "long" : "short")
            + " by the same "
            + Say.number(Math.abs(size))
            + " m"
            + (isByte ? ": 256 us of flight, a timer's byte read while it turns over" : ""),
        view.inFile(IntStream.of(hits)),
        isByte ? "read the timer's high byte again if the low byte was near its end" : "",
        "",
        isByte ? Severity.WARN : Severity.NOTE);
  }
}
