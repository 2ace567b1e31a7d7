package simbad.sonar.effect;

/**
 * The believed heading drifts with the time since the start of a run.
 *
 * @param radPerS true less believed heading, for each second; 0 is neutral
 * @param reckoned whether places were reckoned with the drifting heading, so that the way is bent
 */
public record HeadingDrift(double radPerS, boolean reckoned) implements PoseChange {
  @Override
  public int order() {
    return 1;
  }

  @Override
  public Track start(String sensor, double runStartS) {
    if (radPerS == 0) {
      return Track.STILL;
    }
    return reckoned
        ? new Bend(radPerS, runStartS)
        : (timeS, pose) -> pose.turn(radPerS * (timeS - runStartS));
  }

  /** Lays the way from its start again, each piece turned by the drift of its time. */
  private static final class Bend implements Track {
    private final double radPerS;
    private final double runStartS;
    private final TruePose believed = new TruePose();
    private double xM;
    private double zM;
    private double turnRad;
    private boolean started;

    Bend(double radPerS, double runStartS) {
      this.radPerS = radPerS;
      this.runStartS = runStartS;
    }

    @Override
    public void next(double timeS, TruePose pose) {
      double before = turnRad;
      turnRad = radPerS * (timeS - runStartS);
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
