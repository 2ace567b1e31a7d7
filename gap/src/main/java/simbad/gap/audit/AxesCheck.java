package simbad.gap.audit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import simbad.gap.audit.AuditFinding.File;
import simbad.sonar.frame.Pose;
import simbad.sonar.model.NominalModel;
import simbad.sonar.model.SightLine;
import simbad.sonar.model.TransducerPose;

/**
 * Whether poses are written in another frame than the scene's: readings that nothing in the cone
 * accounts for as the poses stand, and that what is in the cone does account for when they are read
 * otherwise.
 */
final class AxesCheck {
  private static final int MOST_ROWS = 250;
  private static final int LEAST_ROWS = 10;

  /** With more accounted for as they stand, poses are right and something else is wrong. */
  private static final double WRONG = 0.5;

  private static final double RIGHT = 0.8;

  /** So many times fewer are left over. */
  private static final double FEWER = 5;

  /** Of conventions that account for as much, but for chance, the simplest is named. */
  private static final double ALIKE = 0.03;

  private final AuditView view;
  private final NominalModel model;
  private final int[] sample;

  AxesCheck(AuditView view) {
    this.view = view;
    model = new NominalModel(view.sensor(), view.setup().scene());
    double[] common = common();
    int[] echoes =
        view.echoes().filter(i -> Arrays.binarySearch(common, view.rangeM(i)) < 0).toArray();
    int size = Math.min(MOST_ROWS, echoes.length);
    sample = IntStream.range(0, size).map(k -> echoes[k * echoes.length / size]).toArray();
  }

  /** Values that are no distances: the least and the greatest, where they stand for no echo. */
  private double[] common() {
    double[] sorted = view.echoes().mapToDouble(view::rangeM).sorted().toArray();
    if (sorted.length == 0) {
      return sorted;
    }
    double greatest = sorted[sorted.length - 1];
    return Arrays.stream(sorted)
        .distinct()
        .filter(v -> Code.meaning(v, view.sensor(), greatest).isPresent())
        .toArray();
  }

  Optional<AuditFinding> find() {
    if (sample.length < LEAST_ROWS) {
      return Optional.empty();
    }
    boolean[] asItStands = accounted(pose -> pose);
    if (share(asItStands) >= WRONG) {
      return Optional.empty();
    }
    List<Convention> all = Convention.all();
    List<Convention> fitting = new ArrayList<>();
    double best = 0;
    for (Convention one : all) {
      boolean[] otherwise = accounted(one::mended);
      double share = share(otherwise);
      boolean fits =
          share >= RIGHT
              && FEWER * (1 - share) <= 1 - share(asItStands)
              && chance(asItStands, otherwise) < Tail.LEVEL / all.size()
              && (varies() || isOnePlace());
      if (fits) {
        if (share > best + ALIKE) {
          fitting.clear();
          best = share;
        }
        if (share >= best - ALIKE) {
          fitting.add(one);
        }
      }
    }
    return fitting.isEmpty() ? Optional.empty() : Optional.of(finding(asItStands, fitting));
  }

  /** Which readings something in the cone has the distance of. */
  private boolean[] accounted(Convention.Step step) {
    boolean[] accounted = new boolean[sample.length];
    TransducerPose from = new TransducerPose();
    SightLine line = new SightLine();
    for (int k = 0; k < sample.length; k++) {
      Pose pose = step.mended(view.row(sample[k]).pose());
      from.aim(pose.position().xM(), pose.position().zM(), pose.heading().radians());
      for (int o = 0; o < model.size(); o++) {
        model.trace(o, from, line);
        accounted[k] |= view.isOf(line.nearestM(), view.rangeM(sample[k]));
      }
    }
    return accounted;
  }

  private static double share(boolean[] of) {
    int count = 0;
    for (boolean one : of) {
      count += one ? 1 : 0;
    }
    return (double) count / of.length;
  }

  /** Of one place only headings can be wrong: as they are read, all fits or nothing. */
  private boolean isOnePlace() {
    return IntStream.of(sample).mapToObj(i -> view.row(i).pose().position()).distinct().count()
        == 1;
  }

  /** Readings that hardly differ fit wherever something is near: no more than a guess then. */
  private boolean varies() {
    double[] sorted = IntStream.of(sample).mapToDouble(view::rangeM).sorted().toArray();
    double spread = sorted[3 * sorted.length / 4] - sorted[sorted.length / 4];
    return spread > 2 * view.toleranceM(sorted[sorted.length / 2]);
  }

  /** That of rows which differ so many are for the other way (McNemar 1947, exact). */
  private static double chance(boolean[] asItStands, boolean[] otherwise) {
    int gained = 0;
    int differ = 0;
    for (int k = 0; k < asItStands.length; k++) {
      differ += asItStands[k] == otherwise[k] ? 0 : 1;
      gained += !asItStands[k] && otherwise[k] ? 1 : 0;
    }
    return Tail.atLeast(gained, differ, 0.5);
  }

  private AuditFinding finding(boolean[] asItStands, List<Convention> fitting) {
    Convention first = fitting.get(0);
    boolean sure = varies();
    String others =
        fitting.size() == 1
            ? ""
            : "; these data do not tell it from: "
                + String.join(
                    "; ", fitting.stream().skip(1).limit(2).map(Convention::words).toList());
    return new AuditFinding(
        AuditCheck.AXES,
        File.READINGS,
        "as the poses stand, "
            + Say.number(100 * share(asItStands))
            + " of 100 readings are of something in the cone: "
            + (sure ? "" : "perhaps ")
            + first.words()
            + others,
        List.of(),
        sure
            ? "write poses as docs/guide/diagnose.md says: z down the page, degrees counter-clockwise"
                + " from +x"
            : "see whether the log fits after simbad dataset mend " + first.mend(),
        first.mend(),
        sure ? Severity.REFUSE : Severity.NOTE);
  }
}
