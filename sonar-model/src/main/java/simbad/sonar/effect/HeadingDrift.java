package simbad.sonar.effect;

import simbad.sonar.check.Checks;

/**
 * The believed heading drifts with the time since the start of a run.
 *
 * @param radPerS true less believed heading, for each second at the start; 0 is neutral
 * @param settlingS after how long the drift has slowed to a share of 1/e, seconds; infinity for one
 *     that does not slow
 * @param reckoned whether places were reckoned with the drifting heading, so that the way is bent
 */
public record HeadingDrift(double radPerS, double settlingS, boolean reckoned)
    implements PoseChange {
  /** Checks the figures; NaN is refused. */
  public HeadingDrift {
    Checks.finite("radPerS", radPerS);
    Checks.positiveOrInfinite("settlingS", settlingS);
  }

  /** Creates a drift that does not slow. */
  public HeadingDrift(double radPerS, boolean reckoned) {
    this(radPerS, Double.POSITIVE_INFINITY, reckoned);
  }

  @Override
  public int order() {
    return 1;
  }

  @Override
  public Track start(String sensor, double runStartS) {
    if (radPerS == 0) {
      return Track.STILL;
    }
    return reckoned ? new Bend(runStartS) : (timeS, pose) -> pose.turn(turnRad(timeS - runStartS));
  }

  private double turnRad(double sinceS) {
    return settlingS == Double.POSITIVE_INFINITY
        ? radPerS * sinceS
        : -radPerS * settlingS * Math.expm1(-sinceS / settlingS);
  }

  /** Lays the way from its start again, each piece turned by the drift of its time. */
  private final class Bend implements Track {
    private final double runStartS;
    private final TruePose believed = new TruePose();
    private double xM;
    private double zM;
    private double turnRad;
    private boolean started;

    Bend(double runStartS) {
      this.runStartS = runStartS;
    }

    @Override
    public void next(double timeS, TruePose pose) {
      double before = turnRad;
      turnRad = HeadingDrift.this.turnRad(timeS - runStartS);
      if (started) {
        double angle = (before + turnRad) / 2;
        double dx = pose.xM() - believed.xM();
        double dz = pose.zM() - believed.zM();
        xM += dx * Math.cos(angle) + dz * Math.sin(angle);
        zM += dz * Math.cos(angle) - dx * Math.sin(angle);
      } else {
        xM = pose.xM();
        zM = pose.zM();
        started = true;
      }
      believed.set(pose);
      pose.set(xM, zM, pose.headingRad() + turnRad);
    }
  }
}
