package simbad.sonar.change;

import simbad.sonar.check.Checks;
import simbad.sonar.frame.Angles;
import simbad.sonar.ping.PoseChange;
import simbad.sonar.ping.TruePose;

/**
 * A pose is written late: the reading belongs to where the sensor is some time after the believed
 * pose. A log says where that was. While a simulation runs nobody knows yet: there it goes on as it
 * went in the same time before, by the same way and the same turn, and stands until that time has
 * gone by in a run.
 *
 * @param lateS seconds, at least 0; 0 is neutral
 */
public record LatePose(double lateS) implements PoseChange {
  /** Checks the figure; NaN is refused. */
  public LatePose {
    Checks.notNegative("lateS", lateS);
  }

  @Override
  public int order() {
    return 2;
  }

  @Override
  public double aheadS() {
    return lateS;
  }

  @Override
  public Track start(String sensor, double runStartS) {
    return lateS == 0 ? Track.STILL : new Ahead(new Latency(lateS).start(sensor, runStartS));
  }

  private record Ahead(Track earlier) implements Track {
    @Override
    public void next(double timeS, TruePose pose) {
      TruePose was = pose.copy();
      earlier.next(timeS, was);
      double turn = Angles.signed(pose.headingRad() - was.headingRad());
      double xM = pose.xM() - was.xM();
      double zM = pose.zM() - was.zM();
      // z grows down the page, turns are counter-clockwise.
      pose.set(
          pose.xM() + xM * Math.cos(turn) + zM * Math.sin(turn),
          pose.zM() - xM * Math.sin(turn) + zM * Math.cos(turn),
          pose.headingRad() + turn);
    }
  }
}
