package simbad.figures.report;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import simbad.figures.page.AxisScale;
import simbad.figures.page.Graph;
import simbad.figures.page.Html;
import simbad.figures.page.Numbers;
import simbad.figures.page.Svg;
import simbad.figures.page.Svg.Spot;
import simbad.obstacles.ObstacleType;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Pose;
import simbad.sonar.model.LevelModel;
import simbad.sonar.model.ReadingDistribution;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.scene.TableDetection;
import simbad.sonar.shape.ThresholdTable;

/**
 * What the level law changes against the threshold rule, at the bearing from which an obstacle is
 * heard farthest: how far off the axis it is heard, how soft its edge is, and how far beyond its
 * distance it reads.
 */
final class HearingGraph {
  private static final int HEIGHT = 490;
  private static final Graph.Frame ABOVE = new Graph.Frame(58, 12, 338, 120);
  private static final Graph.Frame MIDDLE = new Graph.Frame(58, 200, 338, 105);
  private static final Graph.Frame BELOW = new Graph.Frame(58, 325, 338, 105);
  private static final AxisScale ANGLES = new AxisScale(-60, 60, 20);
  private static final AxisScale CHANCES = new AxisScale(0, 1, 0.5);
  private static final double[] SHARES = {0.4, 0.7, 0.95};

  /** At which chances the curves are named, so that names stand apart. */
  private static final double[] NAMED_AT = {0.8, 0.5, 0.2};

  private static final double BEYOND = 1.25;
  private static final double LEAST_CHANCE = 0.02;
  private static final double HALF = 0.5;
  private static final double ASIDE_DEG = 3;
  private static final int STEPS = 180;
  private static final double MM = 1000;
  private static final String RULE = "table";
  private static final String LEVEL = "trace level";

  private final LevelModel model;
  private final Obstacle obstacle;
  private final SonarSpec sensor;
  private final double bearingRad;
  private final double thresholdM;
  private final Svg svg;

  private HearingGraph(ObstacleType type, SonarSpec sensor) {
    // In steps of the readings the curve of what is read would be a saw.
    this.sensor = sensor.withResolution(0);
    ThresholdTable table = type.thresholds().table();
    int best = 0;
    for (int i = 1; i < table.size(); i++) {
      best = table.valueM(i) > table.valueM(best) ? i : best;
    }
    bearingRad = table.bearingRad(best);
    thresholdM = table.valueM(best);
    obstacle =
        new Obstacle(
            type.name(), new Placement(0, 0, 0), type.outline(), new TableDetection(table));
    model = new LevelModel(this.sensor, new Scene(List.of(obstacle)));
    svg = new Svg(Graph.WIDTH, HEIGHT, "The level law beside the threshold rule: " + type.name());
  }

  /**
   * Draws the graphs.
   *
   * @param type the obstacle
   * @param sensor its figures
   */
  static Html of(ObstacleType type, SonarSpec sensor) {
    HearingGraph graph = new HearingGraph(type, sensor);
    graph.angles();
    graph.distances();
    return graph.svg.html();
  }

  /** Where the obstacle is heard from: its best bearing, in degrees. */
  static double bestBearingDeg(ObstacleType type, SonarSpec sensor) {
    return Math.toDegrees(new HearingGraph(type, sensor).bearingRad);
  }

  private void angles() {
    Graph graph = new Graph(svg, ABOVE, ANGLES, CHANCES);
    graph.columns();
    graph.axes("obstacle's angle off the sensor's axis, degrees", "chance of an echo");
    double half = Math.toDegrees(sensor.coneHalfAngleRad());
    svg.curve(
        List.of(
            graph.spot(-ANGLES.high(), 0),
            graph.spot(-half, 0),
            graph.spot(-half, 1),
            graph.spot(half, 1),
            graph.spot(half, 0),
            graph.spot(ANGLES.high(), 0)),
        Integer.MAX_VALUE,
        RULE);
    for (int i = 0; i < SHARES.length; i++) {
      double distanceM = SHARES[i] * thresholdM;
      curve(graph, ANGLES, deg -> chance(at(distanceM, deg)));
      svg.words(
          graph.spot(edgeDeg(distanceM) + ASIDE_DEG, NAMED_AT[i]),
          "start",
          Numbers.fixed(distanceM, 2) + " m");
    }
    graph.base();
  }

  /** The greatest angle at which an echo is as likely as none. */
  private double edgeDeg(double distanceM) {
    double edge = 0;
    for (double deg = 0; deg < ANGLES.high(); deg++) {
      edge = chance(at(distanceM, deg)) >= HALF ? deg : edge;
    }
    return edge;
  }

  private void distances() {
    AxisScale metres = AxisScale.over(0, Math.min(sensor.maxRangeM(), BEYOND * thresholdM), 6);
    Graph chances = new Graph(svg, MIDDLE, metres, CHANCES);
    chances.columns();
    chances.rows("chance");
    svg.curve(
        List.of(
            chances.spot(sensor.minRangeM(), 1),
            chances.spot(thresholdM, 1),
            chances.spot(thresholdM, 0),
            chances.spot(metres.high(), 0)),
        Integer.MAX_VALUE,
        RULE);
    curve(chances, metres, distanceM -> chance(at(distanceM, 0)));
    chances.base();
    double mostMm = 5;
    double leastMm = 0;
    for (int i = 1; i <= STEPS; i++) {
      double beyond = beyondMm(metres.high() * i / STEPS);
      mostMm = Double.isNaN(beyond) ? mostMm : Math.max(mostMm, beyond);
      leastMm = Double.isNaN(beyond) ? leastMm : Math.min(leastMm, beyond);
    }
    Graph walk = new Graph(svg, BELOW, metres, AxisScale.over(leastMm, mostMm, 4));
    walk.columns();
    walk.axes("distance from the obstacle's centre, m", "read beyond, mm");
    walk.level(0, RULE);
    curve(walk, metres, this::beyondMm);
    walk.base();
  }

  private void curve(Graph graph, AxisScale x, DoubleUnaryOperator value) {
    List<Spot> corners = new ArrayList<>();
    for (int i = 0; i <= STEPS; i++) {
      double at = x.low() + (x.high() - x.low()) * i / STEPS;
      double own = value.applyAsDouble(at);
      if (!Double.isNaN(own)) {
        corners.add(graph.spot(at, own));
      }
    }
    svg.curve(corners, Integer.MAX_VALUE, LEVEL);
  }

  private Pose at(double distanceM, double offAxisDeg) {
    double x = distanceM * Math.sin(bearingRad);
    double z = distanceM * Math.cos(bearingRad);
    double towards = Math.atan2(z, -x);
    return Pose.of(x, z, towards + Math.toRadians(offAxisDeg));
  }

  private double chance(Pose pose) {
    return 1 - model.distribution(pose).noEchoProbability();
  }

  /** How far beyond the nearest point the middle reading lies; not a number where none is. */
  private double beyondMm(double distanceM) {
    Pose pose = at(distanceM, 0);
    ReadingDistribution reading = model.distribution(pose);
    double chance = 1 - reading.noEchoProbability();
    if (chance < LEAST_CHANCE) {
      return Double.NaN;
    }
    double middle = reading.quantileM(chance / 2, sensor.maxRangeM());
    return MM * (middle - obstacle.outline().distanceM(pose.position().xM(), pose.position().zM()));
  }
}
