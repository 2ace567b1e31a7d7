package simbad.sonar.effect;

import simbad.sonar.check.Checks;

/**
 * The believed heading drifts with the way made since the start of a run, as that of wheels of
 * unequal size does.
 *
 * @param radPerM true less believed heading, for each metre; 0 is neutral
 */
public record HeadingDriftByWay(double radPerM) implements PoseChange {
  /** Checks the figure; NaN is refused. */
  public HeadingDriftByWay {
    Checks.finite("radPerM", radPerM);
  }

  @Override
  public int order() {
    return 1;
  }

  @Override
  public Track start(String sensor, double runStartS) {
    return radPerM == 0 ? Track.STILL : new Way();
  }

  private final class Way implements Track {
    private final TruePose before = new TruePose();
    private double wayM;
    private boolean started;

    @Override
    public void next(double timeS, TruePose pose) {
      if (started) {
        wayM += Math.hypot(pose.xM() - before.xM(), pose.zM() - before.zM());
      }
      before.set(pose);
      started = true;
      pose.turn(radPerM * wayM);
    }
  }
}
