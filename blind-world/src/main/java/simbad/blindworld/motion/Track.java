package simbad.blindworld.motion;

import java.util.ArrayList;
import java.util.List;

/** Poses of the frames of an outing, run by run; headings in radians and not wrapped. */
public final class Track {

  private final List<double[][]> runs = new ArrayList<>();

  Track() {}

  double[][] begin(int frames) {
    double[][] poses = new double[3][frames];
    runs.add(poses);
    return poses;
  }

  /** The poses of a run that is read, as columns of x, z and heading, which is unwrapped. */
  public static Track of(List<double[][]> columns) {
    Track track = new Track();
    for (double[][] run : columns) {
      double[][] poses = track.begin(run[0].length);
      for (int c = 0; c < poses.length; c++) {
        System.arraycopy(run[c], 0, poses[c], 0, run[c].length);
      }
      for (int i = 1; i < poses[2].length; i++) {
        double turned = poses[2][i] - poses[2][i - 1];
        poses[2][i] -= 2 * Math.PI * Math.rint(turned / (2 * Math.PI));
      }
    }
    return track;
  }

  /** How many runs there are. */
  public int size() {
    return runs.size();
  }

  /** Where a frame shows the robot. */
  public double xM(int run, int frame) {
    return runs.get(run)[0][frame];
  }

  /** Where a frame shows the robot. */
  public double zM(int run, int frame) {
    return runs.get(run)[1][frame];
  }

  /** The heading that a frame shows. */
  public double headingRad(int run, int frame) {
    return runs.get(run)[2][frame];
  }
}
