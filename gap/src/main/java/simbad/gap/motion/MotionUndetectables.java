package simbad.gap.motion;

import java.util.ArrayList;
import java.util.List;
import simbad.motion.CommandUse;
import simbad.motion.effect.MotionForm;
import simbad.motion.effect.MotionParameter;

/** Effects that would not have shown at a size that matters, from how steps vary with them. */
final class MotionUndetectables {
  /** What a single effect must gain to be named for sure. */
  private static final double NEEDED_NATS = 3 * Odds.COST_NATS / 2;

  private final MotionSteps given;
  private final ScoredMotion best;
  private final double clumping;

  MotionUndetectables(MotionSteps given, Odds odds) {
    this.given = given;
    best = odds.best();
    clumping = odds.clumping();
  }

  List<MotionDiagnosis.Hidden> among(List<MotionForm> forms, CommandUse use) {
    List<MotionDiagnosis.Hidden> hidden = new ArrayList<>();
    for (MotionForm form : forms) {
      MotionParameter parameter = form.parameters().get(0);
      if (best.hypothesis().names(form.effect()) || !Double.isFinite(parameter.neutral())) {
        continue;
      }
      double least = parameter.stepped() ? smallest(use) : leastSize(form, parameter);
      boolean said = hidden.stream().anyMatch(one -> one.effect().equals(form.effect()));
      if (least > parameter.practical() && !said) {
        hidden.add(new MotionDiagnosis.Hidden(form.effect(), parameter.name(), least));
      }
    }
    return hidden;
  }

  /** A band below every command leaves all as it is; steps of that size round none away. */
  private static double smallest(CommandUse use) {
    return use.speeds().length == 0 ? Double.POSITIVE_INFINITY : use.speeds()[0];
  }

  private double leastSize(MotionForm form, MotionParameter parameter) {
    double[] values = form.neutralValues();
    double by = parameter.probe();
    values[0] = values[0] + by <= parameter.high() ? values[0] + by : values[0] - by;
    MotionHypothesis with = best.hypothesis().with(form, values);
    double[][] moved = given.residuals(with.chain());
    double information = 0;
    for (int c = 0; c < moved.length; c++) {
      double[] slopes = new double[moved[c].length];
      for (int i = 0; i < slopes.length; i++) {
        slopes[i] = (best.fit().residuals()[c][i] - moved[c][i]) / by;
      }
      Whitening white = best.slopes().white()[c];
      for (double slope : white.of(slopes)) {
        information += slope * slope;
      }
    }
    return information > 0
        ? Math.sqrt(2 * NEEDED_NATS * clumping / information)
        : Double.POSITIVE_INFINITY;
  }
}
