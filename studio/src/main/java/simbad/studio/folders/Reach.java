package simbad.studio.folders;

import java.util.ArrayList;
import java.util.List;
import simbad.sonar.frame.Angles;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Point;
import simbad.sonar.frame.Pose;
import simbad.sonar.model.ReadingDistribution;
import simbad.sonar.ping.PingLog;
import simbad.sonar.predict.ChangedModel;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;

/**
 * How far an obstacle is heard on the axis by a model, by bearing: the farthest distance from its
 * centre at which an echo of it comes half as often as where it comes most on that bearing. So it
 * can be asked of any model, of thresholds or of levels, with any effects; what a sensor remembers
 * of the ping before is left out.
 */
final class Reach {
  /** As fine as most tables. */
  static final int BEARINGS = 72;

  private static final double STEP_M = 0.05;
  private static final int HALVINGS = 5;

  /** Seldomer than that nothing is heard. */
  private static final double LEAST = 0.02;

  /** How wrong a range may be and still be of the obstacle: a share, and metres. */
  private static final double OFF_SHARE = 0.3;

  private static final double OFF_M = 0.3;

  private final ChangedModel model;
  private final Obstacle obstacle;
  private final String sensor;
  private final double outlineM;

  private Reach(ChangedModel model, Obstacle obstacle, String sensor) {
    this.model = model;
    this.obstacle = obstacle;
    this.sensor = sensor;
    outlineM = obstacle.outline().reachM(0, 0);
  }

  /**
   * Computes it.
   *
   * @param model with a scene in which the obstacle stands alone
   * @param sensor label of the transducer
   * @param mostM as far as is looked
   * @return metres from the obstacle's centre, by bearings from 0, evenly spaced; 0 where nothing
   *     is heard
   */
  static double[] of(ChangedModel model, Obstacle obstacle, String sensor, double mostM) {
    Reach reach = new Reach(model, obstacle, sensor);
    double[] farM = new double[BEARINGS];
    double[] half = new double[BEARINGS];
    reach.scan(farM, half, mostM);
    double[] beyondM = new double[BEARINGS];
    for (int i = 0; i < BEARINGS; i++) {
      beyondM[i] = farM[i] + STEP_M;
    }
    for (int halving = 0; halving < HALVINGS; halving++) {
      reach.halve(farM, beyondM, half);
    }
    return farM;
  }

  /** The last of some distances at which it is still heard, 0 for none. */
  private void scan(double[] farM, double[] half, double mostM) {
    int steps = (int) Math.ceil(mostM / STEP_M);
    double[] distanceM = new double[BEARINGS * steps];
    for (int i = 0; i < distanceM.length; i++) {
      distanceM[i] = outlineM + STEP_M * (1 + i % steps);
    }
    double[] share = heard(distanceM, steps);
    for (int bearing = 0; bearing < BEARINGS; bearing++) {
      for (int step = 0; step < steps; step++) {
        half[bearing] = Math.max(half[bearing], share[bearing * steps + step] / 2);
      }
      for (int step = 0; step < steps && half[bearing] > LEAST / 2; step++) {
        if (share[bearing * steps + step] >= half[bearing]) {
          farM[bearing] = distanceM[bearing * steps + step];
        }
      }
    }
  }

  private void halve(double[] farM, double[] beyondM, double[] half) {
    double[] middleM = new double[BEARINGS];
    for (int i = 0; i < BEARINGS; i++) {
      middleM[i] = Math.max(outlineM + STEP_M, (farM[i] + beyondM[i]) / 2);
    }
    double[] share = heard(middleM, 1);
    for (int i = 0; i < BEARINGS; i++) {
      if (farM[i] > 0 && share[i] >= half[i]) {
        farM[i] = middleM[i];
      } else {
        beyondM[i] = middleM[i];
      }
    }
  }

  /** The share of pings with an echo of the obstacle, looking at its centre. */
  private double[] heard(double[] distanceM, int each) {
    List<ReadingRow> rows = new ArrayList<>(distanceM.length);
    Placement placement = obstacle.worldFromObstacle();
    Point centre = placement.worldFromObstacle(new Point(0, 0));
    for (int i = 0; i < distanceM.length; i++) {
      int index = i / each;
      double bearing = Angles.TURN_RAD * index / BEARINGS;
      Point at =
          placement.worldFromObstacle(
              new Point(distanceM[i] * Math.sin(bearing), distanceM[i] * Math.cos(bearing)));
      double heading = Math.atan2(at.zM() - centre.zM(), centre.xM() - at.xM());
      Pose pose = Pose.of(at.xM(), at.zM(), heading);
      // Each in a run of its own: nothing is remembered.
      rows.add(new ReadingRow(Integer.toString(i), sensor, 0, pose, NoEcho.NO_ECHO));
    }
    PingLog log = new PingLog(rows);
    List<ReadingDistribution> forecasts = model.forecast(model.geometry(log));
    double[] share = new double[distanceM.length];
    for (int ping = 0; ping < share.length; ping++) {
      double farM = distanceM[log.row(ping)];
      double mostM = (1 + OFF_SHARE) * farM + OFF_M;
      double leastM = Math.max(0, (1 - OFF_SHARE) * farM - outlineM - OFF_M);
      ReadingDistribution forecast = forecasts.get(ping);
      share[log.row(ping)] = forecast.echoUpTo(mostM) - forecast.echoUpTo(leastM);
    }
    return share;
  }
}
