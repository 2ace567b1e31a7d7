package simbad.experiments.export;

import java.util.Arrays;
import simbad.obstacles.ObstacleType;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.shape.Outline;
import simbad.sonar.shape.ThresholdTable;

/**
 * The figures of an obstacle and a sensor in whole numbers. What does not fit is refused by name:
 * products of them must stay below 2^31.
 */
@SuppressWarnings("ArrayRecordComponent") // read only
record HeaderFigures(
    int[] thresholdMm,
    int[] cornerHalfMm,
    int coneSin,
    int coneCos,
    int leastHalves,
    int mostHalves) {
  private static final double MOST_REACH_M = 1;
  private static final double MOST_CONE_RAD = Math.PI / 2;
  private static final int MOST_BEARINGS = 3600;
  private static final int MOST_CORNERS = 1000;
  private static final double MOST_M = IntegerSonar.MOST_PLACE_MM / 1000.0;

  /**
   * Takes the figures.
   *
   * @throws IllegalArgumentException for one that no header can hold; the message names it
   */
  static HeaderFigures of(ObstacleType type, SonarSpec sensor) {
    ThresholdTable table = type.thresholds().table();
    Outline outline = type.outline();
    atMost("bearings of the table", table.size(), MOST_BEARINGS);
    atMost("greatest threshold in metres", table.greatestM(), MOST_M);
    requireFit(outline, sensor);
    if (sensor.coneHalfAngleRad() >= MOST_CONE_RAD) {
      throw new IllegalArgumentException(
          "cone_half_angle_deg = "
              + Math.toDegrees(sensor.coneHalfAngleRad())
              + " is not below 90, which the header's cone needs");
    }
    return new HeaderFigures(
        thresholds(table),
        corners(outline),
        (int) Math.rint(IntegerSonar.ONE * Math.sin(sensor.coneHalfAngleRad())),
        (int) Math.rint(IntegerSonar.ONE * Math.cos(sensor.coneHalfAngleRad())),
        halves(sensor.minRangeM()),
        halves(sensor.maxRangeM()));
  }

  /** Refuses what no header can hold of an outline and of a sensor's ranges, by its name. */
  static void requireFit(Outline outline, SonarSpec sensor) {
    atMost("corners of the outline", outline.size(), MOST_CORNERS);
    atMost("reach of the outline in metres", outline.reachM(0, 0), MOST_REACH_M);
    atMost("max_range_m", sensor.maxRangeM(), MOST_M);
  }

  /** As in the table, the first stands again at the end; halves of a millimetre. */
  static int[] corners(Outline outline) {
    int[] corner = new int[2 * outline.size() + 2];
    for (int i = 0; i <= outline.size(); i++) {
      int at = i % outline.size();
      corner[2 * i] = halves(outline.xM(at));
      corner[2 * i + 1] = halves(outline.zM(at));
    }
    return corner;
  }

  /** Halves of a millimetre. */
  static int halves(double metres) {
    return (int) Math.rint(2000 * metres);
  }

  static int[] thresholds(ThresholdTable table) {
    int[] all = new int[table.size() + 1];
    Arrays.setAll(all, i -> (int) Math.rint(1000 * table.valueM(i % table.size())));
    return all;
  }

  private static void atMost(String name, double value, double most) {
    if (!(value <= most)) {
      throw new IllegalArgumentException(
          name + " = " + value + ", expected at most " + most + " in a C99 header");
    }
  }
}
