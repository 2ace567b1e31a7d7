package simbad.gap.joint;

import java.util.ArrayList;
import java.util.List;
import simbad.gap.Diagnoser;
import simbad.gap.diagnosis.DataSet;
import simbad.gap.diagnosis.Diagnosis;
import simbad.gap.diagnosis.Estimate;
import simbad.gap.diagnosis.Verdict;
import simbad.gap.fit.Hypothesis;
import simbad.gap.motion.MotionDiagnoser;
import simbad.gap.motion.MotionDiagnosis;
import simbad.gap.score.Blocks;
import simbad.motion.effect.FittedMotion;
import simbad.motion.format.MotionData;
import simbad.sonar.ping.PingLog;

/**
 * Diagnoses joint logs. Commands and track are diagnosed first, for they say more of how a robot
 * moves; what they show of its wheels is offered to the readings. A cause that either half shows is
 * one cause with one value where both halves can be of that value: the product of what both say.
 */
public final class JointDiagnoser {
  private final DataSet data;
  private final List<Counterpart> counterparts;
  private final MotionDiagnoser mover;

  /**
   * Prepares a diagnosis.
   *
   * @param data scene and readings, at the poses that the robot reckoned
   * @param drive commands and track of the same robot at the same time
   */
  public JointDiagnoser(DataSet data, MotionData drive) {
    this.data = data;
    counterparts = Counterpart.all(data, drive.robot());
    mover = new MotionDiagnoser(drive);
  }

  /**
   * Returns the diagnosis.
   *
   * @param diagnoser of the readings
   */
  public JointDiagnosis diagnose(Diagnoser diagnoser) {
    MotionDiagnosis motion = mover.diagnose();
    Diagnosis sensing = diagnoser.diagnose(data, offered(motion));
    List<Shared> shared = new ArrayList<>();
    Diagnosis heard = sensing;
    MotionDiagnosis moved = motion;
    Heard readings = new Heard(data, sensing);
    for (Counterpart one : counterparts) {
      boolean tracked = isTracked(one, motion);
      boolean isHeard = isNamed(sensing) && sensing.fitted().forms().contains(one.hears());
      if (tracked || isHeard) {
        Shared cause = shared(one, tracked, isHeard, motion, readings);
        shared.add(cause);
        if (cause.isOne()) {
          double value = cause.together().value();
          heard = heard.with(Heard.with(heard.fitted(), one.hears(), value));
          moved = mover.with(moved, one.moves(), value);
        }
      }
    }
    boolean enough = new Blocks(new PingLog(data.readings())).canBeHeldOut();
    return new Together(shared, heard, moved, enough).diagnosis();
  }

  /** What the track shows, as the readings would hear it: each effect of a sensor once. */
  private Hypothesis offered(MotionDiagnosis motion) {
    Hypothesis offered = Hypothesis.NONE;
    for (Counterpart one : counterparts) {
      for (FittedMotion fitted : motion.fitted()) {
        if (fitted.form().equals(one.moves()) && !offered.has(one.hears().effect())) {
          double value = one.hears().parameters().get(0).clamp(fitted.values()[0]);
          offered = offered.and(one.hears(), value);
        }
      }
    }
    return offered;
  }

  private static boolean isTracked(Counterpart one, MotionDiagnosis motion) {
    return motion.findings().stream().anyMatch(f -> f.effect().equals(one.moves().effect()))
        && motion.fitted().stream().anyMatch(f -> f.form().equals(one.moves()));
  }

  private static boolean isNamed(Diagnosis sensing) {
    return sensing.verdict() != Verdict.NONE && sensing.verdict() != Verdict.UNEXPLAINED;
  }

  private Shared shared(
      Counterpart one, boolean tracked, boolean isHeard, MotionDiagnosis motion, Heard readings) {
    Estimate seen = mover.estimate(motion, one.moves());
    Estimate heard = readings.estimate(one.hears(), seen.value());
    return new Shared(
        one.moves().effect(),
        one.hears().effect(),
        one.moves().parameters().get(0).name(),
        tracked,
        isHeard,
        seen,
        heard,
        seen.agrees(heard, one.immaterial()));
  }
}
