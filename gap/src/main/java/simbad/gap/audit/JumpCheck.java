package simbad.gap.audit;

import java.util.Arrays;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import simbad.gap.audit.AuditFinding.File;

/**
 * Single readings that are off by one and the same amount while those before and after are right: a
 * timer's byte that was read late, a constant that is added now and then. Of a log without times
 * nobody knows what was before and after; there most readings must be right.
 */
final class JumpCheck {
  /** 256 counts of a timer that counts microseconds. */
  private static final double BYTE_S = 256e-6;

  private static final int LEAST = 3;

  /** To either side, of rows without times. */
  private static final int NEAR = 5;

  private static final double LEAST_RIGHT = 0.5;

  /** So many windows the jumps could have been in, at least: from the core on they could be. */
  private static final double WINDOWS = 4;

  /** Noise has more jumps between its core and where they are densest; of the densest, so many. */
  private static final double BETWEEN = 0.5;

  private final AuditView view;
  private final Rest rest;
  private final Set<Integer> told;
  private final double coreM;
  private final double windowM;

  /**
   * Prepares the check.
   *
   * @param view the rows
   * @param rest of their ranges
   * @param told rows of the file of which something else was found
   */
  JumpCheck(AuditView view, Rest rest, Set<Integer> told) {
    this.view = view;
    this.rest = rest;
    this.told = told;
    coreM = rest.coreM();
    windowM = Rest.CORE / 2 * rest.noiseM();
  }

  Optional<AuditFinding> find() {
    int[] jumps =
        rest.off()
            .filter(i -> !told.contains(view.inFile(i)))
            .filter(i -> view.row(i).isTimed() ? isBetweenRight(i) : isAmongRight(i))
            .toArray();
    double[] sizes = IntStream.of(jumps).mapToDouble(i -> rest.offM(i)).sorted().toArray();
    return jump(sizes)
        .map(one -> finding(one, IntStream.of(jumps).filter(i -> one.isOf(rest.offM(i))).toArray()))
        .or(() -> eitherWay(jumps));
  }

  /** As many too long as too short. */
  private Optional<AuditFinding> eitherWay(int... jumps) {
    double[] sizes =
        IntStream.of(jumps).mapToDouble(i -> Math.abs(rest.offM(i))).sorted().toArray();
    return jump(sizes)
        .map(
            one ->
                finding(
                    new Jump(one.sizeM, true, windowM),
                    IntStream.of(jumps).filter(i -> one.isOf(Math.abs(rest.offM(i)))).toArray()));
  }

  private boolean isBetweenRight(int i) {
    return view.follows(i) && view.follows(i + 1) && rest.isRight(i - 1) && rest.isRight(i + 1);
  }

  /** Without times rows stand in the order of their places: most of those near by must be right. */
  private boolean isAmongRight(int i) {
    int[] near =
        IntStream.rangeClosed(Math.max(0, i - NEAR), Math.min(view.size() - 1, i + NEAR))
            .filter(at -> at != i && rest.isKnown(at))
            .toArray();
    long right = IntStream.of(near).filter(rest::isRight).count();
    return near.length >= NEAR && right > LEAST_RIGHT * near.length;
  }

  /** An amount by which readings are off. */
  private record Jump(double sizeM, boolean eitherWay, double windowM) {
    boolean isOf(double off) {
      return Math.abs(off - sizeM) <= 2 * windowM;
    }

    String way() {
      return eitherWay ? "long or short" : sizeM > 0 ? "long" : "short";
    }
  }

  /** Whether most of the sizes, ascending, are one. */
  private Optional<Jump> jump(double... sizes) {
    if (sizes.length < LEAST) {
      return Optional.empty();
    }
    int from = densest(sizes);
    int hits = within(sizes, from);
    double size = Arrays.stream(sizes, from, from + hits).average().orElse(0);
    double spread = sizes[sizes.length - 1] - sizes[0];
    double beyond = Math.abs(size) - coreM;
    double span = Math.max(Math.max(spread, beyond), 2 * WINDOWS * windowM);
    boolean shows =
        hits >= LEAST
            && 2 * hits > sizes.length
            && !isTail(sizes, size, hits)
            && sizes.length * Tail.atLeast(hits, sizes.length, 2 * windowM / span) < Tail.LEVEL;
    return shows ? Optional.of(new Jump(size, false, windowM)) : Optional.empty();
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

  private AuditFinding finding(Jump jump, int... hits) {
    double size = Math.abs(jump.sizeM);
    double byteM = BYTE_S * view.sensor().assumedSoundSpeedMPerS() / 2;
    double known = windowM / Math.sqrt(hits.length);
    boolean isByte = Math.abs(size - byteM) <= AuditView.AIR * byteM + known;
    double metres = Math.rint(size);
    boolean isDigit =
        !jump.eitherWay && jump.sizeM < 0 && metres >= 1 && Math.abs(size - metres) <= known;
    String like = "";
    String mend = "";
    if (isByte) {
      like = ", as by a timer's byte that is read while it turns over: 256 us of flight";
      mend = "read the timer's high byte again if the low byte was near its end";
    } else if (isDigit) {
      like = ", as when a number in centimetres or millimetres loses its first digit";
      mend = "look at the line in the log, and wait for whole lines where they are read";
    }
    return new AuditFinding(
        AuditCheck.JUMP,
        File.READINGS,
        Say.readings(hits.length)
            + " alone among right ones are too "
            + jump.way()
            + " by the same "
            + Say.number(size)
            + " m"
            + like,
        view.inFile(IntStream.of(hits)),
        mend,
        "",
        isByte ? Severity.WARN : Severity.NOTE);
  }
}
