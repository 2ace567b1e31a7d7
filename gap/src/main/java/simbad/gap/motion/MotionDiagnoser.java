package simbad.gap.motion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import simbad.gap.diagnosis.Interval;
import simbad.gap.diagnosis.Verdict;
import simbad.motion.MotionChain;
import simbad.motion.effect.MotionForm;
import simbad.motion.effect.MotionParameter;
import simbad.motion.format.MotionData;

/** Diagnoses a motion folder. Uses no chance: equal data give an equal diagnosis. */
public final class MotionDiagnoser {
  /** Fewer blocks of ten seconds cannot be left out in fifths. */
  private static final int LEAST_BLOCKS = 6;

  /** A filter that takes less than this of what is left finds nothing that matters. */
  private static final double LEFT_SHARE = 0.1;

  private static final double LEFT_Z = 3;

  private final MotionData data;
  private final Evidence evidence;

  /**
   * Prepares a diagnosis.
   *
   * @param data what was believed, commanded and seen
   */
  public MotionDiagnoser(MotionData data) {
    this.data = data;
    evidence = new Evidence(data.runs(), Windows.HORIZONS_S[0]);
  }

  /** What is believed, and what a reference has shown beside it. */
  private MotionChain base() {
    MotionChain believed = data.robot().motion();
    if (data.reference().isEmpty()) {
      return believed;
    }
    Evidence trusted = new Evidence(data.reference(), Windows.HORIZONS_S[0]);
    Search search = new Search(trusted, data.robot().separateClocks());
    return trusted.blockCount() < LEAST_BLOCKS
        ? believed
        : search.search(search.nominal(believed)).full().hypothesis().chain();
  }

  /** Returns the diagnosis. */
  public MotionDiagnosis diagnose() {
    MotionChain base = base();
    Search search = new Search(evidence, data.robot().separateClocks());
    if (evidence.blockCount() < LEAST_BLOCKS) {
      return undecided();
    }
    HeldOut nominal = search.nominal(base);
    HeldOut best = search.search(nominal);
    Residue residue = new Residue(evidence);
    Residue.Left filter = residue.of(nominal.residuals(), nominal.full().scatter());
    Residue.Left left = residue.of(best.residuals(), best.full().scatter());
    MotionGap gap = MotionGap.of(evidence, data.robot(), base, best.folds());
    List<MotionFinding> findings = findings(search, best);
    boolean more = left.z() > LEFT_Z && Arrays.stream(left.share()).max().orElse(0) > LEFT_SHARE;
    Verdict verdict = verdict(findings, more);
    return new MotionDiagnosis(
        verdict,
        headline(verdict, findings, gap),
        findings,
        unknown(left),
        gap.before(),
        gap.after(),
        1 - gap.ratio(),
        new Interval(1 - gap.ci95().high(), 1 - gap.ci95().low()),
        filter.share(),
        modelShare(nominal.residuals(), best.residuals()),
        MotionPlaces.of(evidence, nominal.residuals(), best.residuals()),
        evidence.size());
  }

  private MotionDiagnosis undecided() {
    return new MotionDiagnosis(
        Verdict.UNDECIDED,
        "the track covers only "
            + evidence.blockCount()
            + " stretches of ten seconds, "
            + LEAST_BLOCKS
            + " are needed",
        List.of(),
        0.5,
        new double[3][3],
        new double[3][3],
        0,
        new Interval(0, 0),
        new double[3],
        new double[3],
        List.of(),
        evidence.size());
  }

  private static Verdict verdict(List<MotionFinding> findings, boolean more) {
    boolean atBound =
        findings.stream()
            .flatMap(finding -> finding.parameters().stream())
            .anyMatch(MotionFinding.Parameter::atBound);
    if (findings.isEmpty()) {
      return more ? Verdict.UNEXPLAINED : Verdict.NONE;
    }
    return more || atBound ? Verdict.PARTLY : Verdict.EXPLAINED;
  }

  private static String headline(Verdict verdict, List<MotionFinding> findings, MotionGap gap) {
    String names = String.join(" + ", findings.stream().map(MotionFinding::effect).toList());
    String shrink =
        String.format(Locale.ROOT, "the gap shrinks by %.0f %%", 100 - 100 * gap.ratio());
    return switch (verdict) {
      case NONE -> "no gap beyond chance";
      case UNEXPLAINED -> "something that no named effect accounts for";
      case PARTLY -> names + ", and something else; " + shrink;
      default -> names + "; " + shrink;
    };
  }

  /** A filter's evidence as a chance: even odds at the size that decides. */
  private static double unknown(Residue.Left left) {
    double share = Arrays.stream(left.share()).max().orElse(0);
    double surprise = Math.min(left.z() - LEFT_Z, (share - LEFT_SHARE) / LEFT_SHARE * LEFT_Z);
    return 1 / (1 + Math.exp(-surprise));
  }

  private static double[] modelShare(double[][] before, double[][] after) {
    double[] share = new double[3];
    for (int c = 0; c < 3; c++) {
      double sumBefore = 0;
      double sumAfter = 0;
      for (int i = 0; i < before.length; i++) {
        sumBefore += Math.abs(before[i][c]);
        sumAfter += Math.abs(after[i][c]);
      }
      share[c] = sumBefore > 0 ? 1 - sumAfter / sumBefore : 0;
    }
    return share;
  }

  private List<MotionFinding> findings(Search search, HeldOut best) {
    List<MotionFinding> findings = new ArrayList<>();
    Hypothesis chosen = best.full().hypothesis();
    double[] errors = new Fitter(evidence).standardErrors(chosen);
    int at = 0;
    for (MotionForm form : chosen.forms()) {
      double[] own = Arrays.copyOfRange(errors, at, at + form.parameters().size());
      double[] values = chosen.values(form);
      List<MotionFinding.Parameter> parameters = new ArrayList<>();
      for (int i = 0; i < values.length; i++) {
        parameters.add(parameter(form.parameters().get(i), values[i], own[i]));
      }
      String remedy =
          String.format(Locale.ROOT, form.remedy(), String.format(Locale.ROOT, "%.4g", values[0]));
      List<String> ties = search.ties(best, form);
      findings.add(
          new MotionFinding(
              form.effect(), form.form(), search.sure(best, form), parameters, ties, remedy));
      at += own.length;
    }
    NoiseFindings.add(findings, evidence, data.robot(), best);
    return findings;
  }

  private static MotionFinding.Parameter parameter(
      MotionParameter parameter, double value, double error) {
    boolean end = value <= parameter.low() || value >= parameter.high();
    return new MotionFinding.Parameter(
        parameter.name(),
        value,
        new Interval(
            parameter.within(value - Chance.NORMAL_95 * error),
            parameter.within(value + Chance.NORMAL_95 * error)),
        end && value != parameter.neutral());
  }
}
