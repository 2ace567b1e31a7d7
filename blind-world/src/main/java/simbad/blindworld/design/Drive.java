package simbad.blindworld.design;

import java.util.ArrayList;
import java.util.List;
import simbad.blindworld.world.Chance;
import simbad.blindworld.world.Obstacle;
import simbad.blindworld.world.Point;
import simbad.blindworld.world.Pose;
import simbad.blindworld.world.Recording;
import simbad.blindworld.world.Row;
import simbad.blindworld.world.Scene;

/** A robot with one to six sonars drives round, past, along and towards the obstacles. */
final class Drive implements Design {

  private static final double CLEARANCE_M = 0.09;
  private static final double MOST_TURN_RAD_PER_S = 1.4;
  private static final double REACHED_M = 0.12;

  private final int transducers;
  private final double periodS;
  private final double[] anglesRad;
  private final double forwardM;
  private final boolean staggered;
  private final int runs;
  private final double speedMPerS;
  private final List<String> names;
  private final String runName;

  Drive(Chance random) {
    transducers = random.nextInt(1, 7);
    periodS = new double[] {0.05, 0.06, 0.1, 0.1, 0.2, 0.25, 0.5}[random.nextInt(7)];
    double spread = Math.toRadians(random.nextInt(15, 61));
    double aim = Math.toRadians(random.nextInt(-90, 91));
    anglesRad = new double[transducers];
    for (int s = 0; s < transducers; s++) {
      anglesRad[s] = aim + (s - (transducers - 1) / 2.0) * spread;
    }
    forwardM = random.nextBoolean() ? 0 : 0.01 * random.nextInt(2, 10);
    staggered = random.nextInt(4) == 0;
    runs = random.nextInt(3, 8);
    speedMPerS = Math.min(random.nextDouble(0.12, 0.6), 0.12 / periodS);
    String[] styles = {"s%d", "us%d", "sonar-%d", "T%d"};
    String style = styles[random.nextInt(styles.length)];
    List<String> labels = new ArrayList<>();
    for (int s = 0; s < transducers; s++) {
      labels.add(style.formatted(s + 1));
    }
    names = List.copyOf(labels);
    runName = new String[] {"run%d", "lap-%d", "drive %d", "log%02d"}[random.nextInt(4)];
  }

  @Override
  public String kind() {
    return "run";
  }

  @Override
  public double periodS() {
    return periodS;
  }

  @Override
  public Recording record(Scene scene, int rows, Chance random) {
    List<Row> all = new ArrayList<>();
    int pings = Math.max(20, rows / (runs * transducers));
    for (int run = 0; run < runs; run++) {
      int length = (int) (pings * random.nextDouble(0.85, 1.15));
      double speed = speedMPerS * random.nextDouble(0.7, 1.3);
      List<Pose> course = course(scene, length, speed, random);
      all.addAll(pings(scene, course, runName.formatted(run + 1)));
    }
    return new Recording(all);
  }

  private List<Row> pings(Scene scene, List<Pose> course, String run) {
    List<Row> rows = new ArrayList<>();
    for (int k = 0; k < course.size(); k++) {
      for (int s = 0; s < transducers; s++) {
        double late = staggered ? (double) s / transducers : 0;
        Pose robot =
            late > 0 && k + 1 < course.size()
                ? clear(scene, course.get(k).towards(course.get(k + 1), late))
                : course.get(k);
        Pose look = robot.turned(anglesRad[s]);
        double x = robot.xM() + forwardM * StrictMath.cos(look.headingRad());
        double z = robot.zM() - forwardM * StrictMath.sin(look.headingRad());
        rows.add(Rows.row(run, names.get(s), (k + late) * periodS, look.at(x, z)));
      }
    }
    return rows;
  }

  /** Steers after way-points with a limited rate of turn, at a speed that varies a little. */
  private List<Pose> course(Scene scene, int length, double speed, Chance random) {
    Routes routes = new Routes(scene, random);
    List<Point> route = routes.next();
    int goal = 1;
    Pose pose = clear(scene, begin(route));
    double swing = random.nextDouble(0, 0.6);
    double beat = random.nextDouble(0.2, 1.5);
    List<Pose> course = new ArrayList<>();
    for (int k = 0; k < length; k++) {
      course.add(pose);
      while (distanceM(pose, route.get(goal)) < REACHED_M) {
        goal++;
        if (goal == route.size()) {
          route = routes.next();
          goal = 0;
        }
      }
      double now = speed * (1 + swing * StrictMath.sin(beat * k * periodS));
      pose = clear(scene, step(pose, route.get(goal), now));
    }
    return course;
  }

  private static Pose begin(List<Point> route) {
    Point from = route.get(0);
    Point to = route.get(1);
    double heading = StrictMath.atan2(from.zM() - to.zM(), to.xM() - from.xM());
    return new Pose(from.xM(), from.zM(), heading);
  }

  private static double distanceM(Pose pose, Point point) {
    return StrictMath.hypot(point.xM() - pose.xM(), point.zM() - pose.zM());
  }

  private Pose step(Pose pose, Point goal, double speed) {
    double wanted = StrictMath.atan2(pose.zM() - goal.zM(), goal.xM() - pose.xM());
    double turn = Math.IEEEremainder(wanted - pose.headingRad(), 2 * Math.PI);
    double most = MOST_TURN_RAD_PER_S * periodS;
    double heading = pose.headingRad() + Math.max(-most, Math.min(most, turn));
    double slow = Math.max(0.15, StrictMath.cos(turn / 2));
    double way = speed * slow * periodS;
    return new Pose(
        pose.xM() + way * StrictMath.cos(heading),
        pose.zM() - way * StrictMath.sin(heading),
        heading);
  }

  /** Pushes the robot out of the obstacles, so that it slides round them. */
  private Pose clear(Scene scene, Pose pose) {
    Pose clear = pose;
    for (Obstacle obstacle : scene.obstacles()) {
      double least = obstacle.radiusM() + CLEARANCE_M + forwardM;
      double dx = clear.xM() - obstacle.place().xM();
      double dz = clear.zM() - obstacle.place().zM();
      double away = StrictMath.hypot(dx, dz);
      if (away < least && away > 0) {
        clear =
            clear.at(
                obstacle.place().xM() + dx / away * least,
                obstacle.place().zM() + dz / away * least);
      }
    }
    return clear;
  }
}
