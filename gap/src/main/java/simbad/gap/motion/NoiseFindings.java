package simbad.gap.motion;

import java.util.List;
import java.util.Locale;
import simbad.gap.diagnosis.Interval;
import simbad.motion.Robot;
import simbad.motion.effect.MotionForms;

/** Effects that change how motion scatters and not where it leads. */
final class NoiseFindings {
  /** Of Gaussian scatter at both ends of a window: median size over sigma. */
  private static final double MEDIAN_OF_TWO = 0.6745 * Math.sqrt(2);

  private static final double MEDIAN_OF_STUDENT = 0.7407;
  private static final double MATTERS = 1.3;
  private static final double FAR = 4;
  private static final double SURE = 3;
  private static final double LEAST_SLIP = 0.005;

  private NoiseFindings() {}

  static void add(List<MotionFinding> findings, Evidence evidence, Robot robot, HeldOut best) {
    double[][] residuals = best.full().residuals();
    Fitter fitter = new Fitter(evidence);
    double along = sigma(residuals, fitter.all());
    double believed = robot.trackSigmaM();
    if (believed > 0 && along > MATTERS * believed) {
      double[] error =
          fitter.standardErrors(
              new double[] {along}, mask -> new double[] {sigma(residuals, mask)});
      double sure = Chance.below((along - believed) / error[0]);
      findings.add(
          finding(
              MotionForms.MOTION_NOISE,
              sure,
              parameter("sigma_m", along, error[0]),
              "let displacements scatter by %.2g m"));
    }
    slip(findings, evidence, best);
  }

  /** Of Gaussian scatter at each end of a window, along. */
  private static double sigma(double[][] residuals, boolean[] mask) {
    return Scatter.of(residuals, mask).scales()[0] * MEDIAN_OF_STUDENT / MEDIAN_OF_TWO;
  }

  private static MotionFinding.Parameter parameter(String name, double value, double error) {
    Interval ci95 =
        new Interval(
            Math.max(0, value - Chance.NORMAL_95 * error), value + Chance.NORMAL_95 * error);
    return new MotionFinding.Parameter(name, value, ci95, false);
  }

  private static MotionFinding finding(
      String effect, double sure, MotionFinding.Parameter parameter, String remedy) {
    String said = String.format(Locale.ROOT, remedy, parameter.value());
    return new MotionFinding(effect, effect, sure, List.of(parameter), List.of(), said);
  }

  /** Far outliers that fall short more often than they run ahead; counts of rare events. */
  private static void slip(List<MotionFinding> findings, Evidence evidence, HeldOut best) {
    double scale = best.full().scatter().scales()[0];
    int shorter = 0;
    int longer = 0;
    double[][] residuals = best.residuals();
    for (int i = 0; i < residuals.length; i++) {
      double expected = evidence.window(i).way().alongM() - residuals[i][0];
      double ahead = residuals[i][0] * Math.signum(expected);
      shorter += ahead < -FAR * scale ? 1 : 0;
      longer += ahead > FAR * scale ? 1 : 0;
    }
    double share = (double) (shorter - longer) / residuals.length;
    double error = Math.sqrt(shorter + longer) / residuals.length;
    if (share > SURE * error && share > LEAST_SLIP) {
      findings.add(
          finding(
              MotionForms.SLIP,
              Chance.below(share / error),
              parameter("share_of_windows", share, error),
              "let wheels slip in a share of %.2g of all half seconds"));
    }
  }
}
