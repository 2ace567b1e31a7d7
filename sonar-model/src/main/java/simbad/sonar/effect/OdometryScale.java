package simbad.sonar.effect;

import simbad.sonar.check.Checks;

/**
 * The distances travelled since the start of a run are longer than believed.
 *
 * @param factor true over believed; 1 is neutral
 */
public record OdometryScale(double factor) implements PoseChange {
  /** Checks the figure; NaN is refused. */
  public OdometryScale {
    Checks.notNegative("factor", factor);
  }

  @Override
  public int order() {
    return 0;
  }

  @Override
  public Track start(String sensor, double runStartS) {
    return factor == 1 ? Track.STILL : new Stretch(factor);
  }

  private static final class Stretch implements Track {
    private final double factor;
    private final TruePose first = new TruePose();
    private boolean started;

    Stretch(double factor) {
      this.factor = factor;
    }

    @Override
    public void next(double timeS, TruePose pose) {
      if (!started) {
        first.set(pose);
        started = true;
      }
      pose.set(
          first.xM() + factor * (pose.xM() - first.xM()),
          first.zM() + factor * (pose.zM() - first.zM()),
          pose.headingRad());
    }
  }
}
