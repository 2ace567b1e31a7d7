package simbad.blindworld.design;

import java.util.ArrayList;
import java.util.List;
import simbad.blindworld.world.Chance;
import simbad.blindworld.world.Obstacle;
import simbad.blindworld.world.Pose;
import simbad.blindworld.world.Recording;
import simbad.blindworld.world.Row;
import simbad.blindworld.world.Scene;

/** One sonar on a bench: sweeps out and in, turns on the spot, turntables and single poses. */
final class Bench implements Design {

  private final double periodS;
  private final double stepM;
  private final double sweeps;
  private final double scans;
  private final double tables;
  private final double reach;
  private final double aside;
  private final String sensor;
  private final List<String> labels;

  Bench(Chance random) {
    periodS = new double[] {0.05, 0.1, 0.2, 0.25, 0.3, 0.5}[random.nextInt(6)];
    stepM = 0.005 * random.nextInt(2, 11);
    sweeps = random.nextDouble(0.15, 0.6);
    scans = random.nextDouble(0.05, 0.2);
    tables = random.nextDouble(0, 0.25);
    reach = random.nextDouble(1.05, 1.9);
    aside = random.nextDouble(1.1, 2.6);
    sensor = new String[] {"s0", "bench", "T1", "srf"}[random.nextInt(4)];
    labels =
        random.nextBoolean()
            ? List.of("sweep", "scan", "turntable", "random")
            : List.of("A", "B", "C", "D");
  }

  @Override
  public String kind() {
    return "bench";
  }

  @Override
  public double periodS() {
    return periodS;
  }

  @Override
  public Recording record(Scene scene, int rows, Chance random) {
    Session session = new Session(scene, random);
    session.fill(labels.get(0), (int) (rows * sweeps), session::sweep);
    session.fill(labels.get(1), (int) (rows * scans), session::scan);
    session.fill(labels.get(2), (int) (rows * tables), session::turntable);
    session.fill(labels.get(3), rows - session.rows.size(), session::anywhere);
    return new Recording(session.rows);
  }

  /** The pose at a bearing and distance of the obstacle, looking at its centre. */
  static Pose facing(Obstacle goal, double bearing, double r) {
    double direction = bearing + goal.turnRad();
    double dx = r * StrictMath.sin(direction);
    double dz = r * StrictMath.cos(direction);
    return new Pose(goal.place().xM() + dx, goal.place().zM() + dz, StrictMath.atan2(dz, -dx));
  }

  /** One day at the bench. */
  private final class Session {

    private final Scene scene;
    private final Chance random;
    private final List<Row> rows = new ArrayList<>();

    Session(Scene scene, Chance random) {
      this.scene = scene;
      this.random = random;
    }

    private interface Series {
      List<Pose> poses(Obstacle obstacle);
    }

    private void fill(String run, int wanted, Series series) {
      int begin = rows.size();
      while (rows.size() - begin < wanted) {
        List<Obstacle> obstacles = scene.obstacles();
        Obstacle goal = obstacles.get(random.nextInt(obstacles.size()));
        for (Pose pose : series.poses(goal)) {
          if (rows.size() - begin < wanted && isFree(pose)) {
            rows.add(Rows.row(run, sensor, (rows.size() - begin) * periodS, pose));
          }
        }
      }
    }

    private boolean isFree(Pose pose) {
      return scene.obstacles().stream()
          .allMatch(
              o ->
                  StrictMath.hypot(pose.xM() - o.place().xM(), pose.zM() - o.place().zM())
                      > o.radiusM() + 0.05);
    }

    private double reachM(Obstacle goal) {
      return goal.shadow().greatestM();
    }

    /** Out from near by until well behind the threshold at one bearing, and in again. */
    private List<Pose> sweep(Obstacle goal) {
      double bearing = Math.toRadians(5 * random.nextInt(72));
      double threshold = goal.shadow().atM(bearing);
      double from = goal.radiusM() + 0.08;
      double to = Math.max(from + 0.3, threshold * reach + 0.1);
      double off = Math.toRadians(random.nextDouble(-2, 2));
      List<Pose> poses = new ArrayList<>();
      for (double r = from; r < to; r += stepM) {
        poses.add(facing(goal, bearing, r).turned(off));
      }
      for (int k = poses.size() - 1; k >= 0; k--) {
        poses.add(poses.get(k));
      }
      return poses;
    }

    private List<Pose> scan(Obstacle goal) {
      double bearing = random.nextDouble(0, 2 * Math.PI);
      double threshold = Math.max(0.3, goal.shadow().atM(bearing));
      double r = goal.radiusM() + 0.08 + threshold * random.nextDouble(0.1, 0.95);
      double half = scene.sensor().halfAngleRad() * 1.4;
      List<Pose> poses = new ArrayList<>();
      for (int k = -40; k <= 40; k++) {
        poses.add(facing(goal, bearing, r).turned(half * k / 40));
      }
      return poses;
    }

    private List<Pose> turntable(Obstacle goal) {
      double r = goal.radiusM() + 0.1 + reachM(goal) * random.nextDouble(0.1, 0.9);
      List<Pose> poses = new ArrayList<>();
      for (int k = 0; k < 120; k++) {
        poses.add(facing(goal, Math.toRadians(3 * k), r));
      }
      return poses;
    }

    private List<Pose> anywhere(Obstacle goal) {
      double bearing = random.nextDouble(0, 2 * Math.PI);
      double limit =
          random.nextBoolean() ? reachM(goal) * reach : goal.shadow().atM(bearing) * (reach + 0.2);
      double r = goal.radiusM() + 0.08 + random.nextDouble() * Math.max(0.3, limit);
      double turn = scene.sensor().halfAngleRad() * aside * (2 * random.nextDouble() - 1);
      return List.of(facing(goal, bearing, r).turned(turn));
    }
  }
}
