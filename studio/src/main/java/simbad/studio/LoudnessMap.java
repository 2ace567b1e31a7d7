package simbad.studio;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Optional;
import simbad.experiments.run.SensorKind;
import simbad.obstacles.ObstacleType;
import simbad.sonar.frame.Angles;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Pose;
import simbad.sonar.scene.SonarSpec;

/**
 * Where an obstacle's echo is how loud, for a sensor that looks at its middle: the shadow as the
 * level law has it. For each of some levels over the receiver's threshold the farthest distance at
 * which the echo reaches it, by bearing.
 */
final class LoudnessMap {
  static final int BEARINGS = 72;

  /** Decibels over the threshold; the first is the edge. */
  private static final int[] LEVELS_DB = {0, 6, 12, 18, 24};

  private static final double STEP_M = 0.02;
  private static final ObjectMapper MAPPER = new ObjectMapper();

  private final Loudness loudness;
  private final double mostM;
  private final double[][] reachM = new double[LEVELS_DB.length][BEARINGS];

  private LoudnessMap(Loudness loudness, double mostM) {
    this.loudness = loudness;
    this.mostM = mostM;
  }

  /** Returns the map as JSON; without levels for a sensor that hears by thresholds. */
  static String json(SensorKind sensor, SonarSpec spec, ObstacleType type) {
    ObjectNode root = MAPPER.createObjectNode();
    ArrayNode levels = root.putArray("levels_db");
    ArrayNode reach = root.putArray("reach_m");
    Optional<Loudness> loudness = Loudness.of(sensor, spec, type, Placement.IDENTITY);
    if (loudness.isPresent()) {
      LoudnessMap map =
          new LoudnessMap(loudness.get(), spec.maxRangeM() + type.outline().reachM(0, 0));
      map.fill();
      for (int level = 0; level < LEVELS_DB.length; level++) {
        levels.add(LEVELS_DB[level]);
        ArrayNode row = reach.addArray();
        for (double metres : map.reachM[level]) {
          row.add(Math.rint(metres * 1e4) / 1e4);
        }
      }
    }
    return root.toString();
  }

  private void fill() {
    for (int bearing = 0; bearing < BEARINGS; bearing++) {
      double angle = Angles.TURN_RAD * bearing / BEARINGS;
      for (double farM = STEP_M; farM <= mostM; farM += STEP_M) {
        double xM = farM * Math.sin(angle);
        double zM = farM * Math.cos(angle);
        Loudness.Sight sight = loudness.at(Pose.of(xM, zM, Math.atan2(zM, -xM)));
        for (int level = 0; sight.isInRange() && level < LEVELS_DB.length; level++) {
          if (sight.excessDb() >= LEVELS_DB[level]) {
            reachM[level][bearing] = farM;
          }
        }
      }
    }
  }
}
