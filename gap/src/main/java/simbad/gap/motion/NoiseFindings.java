package simbad.gap.motion;

import java.util.List;
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
    double along = best.full().scatter().scales()[0] * MEDIAN_OF_STUDENT / MEDIAN_OF_TWO;
    if (robot.trackSigmaM() > 0 && along > MATTERS * robot.trackSigmaM()) {
      findings.add(noise(MotionForms.MOTION_NOISE, "sigma_m", along, "let displacements scatter"));
    }
    double slip = slip(evidence, best);
    if (slip > 0) {
      findings.add(
          noise(MotionForms.SLIP, "share_of_windows", slip, "let wheels slip now and then"));
    }
  }

  private static MotionFinding noise(String effect, String name, double value, String remedy) {
    double least = value / 1.2;
    return new MotionFinding(
        effect,
        effect,
        0.95,
        List.of(new MotionFinding.Parameter(name, value, new Interval(least, value * 1.2), false)),
        List.of(),
        remedy);
  }

  /** Far outliers that fall short more often than they run ahead; 0 where they do not. */
  private static double slip(Evidence evidence, HeldOut best) {
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
    double excess = shorter - longer;
    boolean sure = excess > SURE * Math.sqrt(shorter + longer);
    return sure && excess > LEAST_SLIP * residuals.length ? excess / residuals.length : 0;
  }
}
