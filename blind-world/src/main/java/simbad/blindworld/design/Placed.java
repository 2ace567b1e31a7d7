package simbad.blindworld.design;

import java.util.ArrayList;
import java.util.List;
import simbad.blindworld.world.Chance;
import simbad.blindworld.world.Obstacle;
import simbad.blindworld.world.Pose;
import simbad.blindworld.world.Recording;
import simbad.blindworld.world.Row;
import simbad.blindworld.world.Scene;

/**
 * One sonar that a hand puts in place again and again, to read several times at each place: ladders
 * along a tape away from an obstacle, and places here and there before one.
 */
final class Placed implements Design {

  private static final double NEAREST_M = 0.3;

  private final double periodS;
  private final double moveS;
  private final int readings;
  private final double stepM;
  private final double ladders;
  private final double reach;

  Placed(Chance random) {
    periodS = new double[] {0.05, 0.1, 0.25, 0.5}[random.nextInt(4)];
    moveS = random.nextInt(10, 60);
    readings = random.nextInt(5, 21);
    stepM = 0.05 * random.nextInt(1, 5);
    ladders = random.nextDouble(0.3, 0.8);
    reach = random.nextDouble(1.05, 1.5);
  }

  @Override
  public String kind() {
    return "placed";
  }

  @Override
  public double periodS() {
    return periodS;
  }

  @Override
  public Recording record(Scene scene, int rows, Chance random) {
    List<Row> all = new ArrayList<>();
    int ofLadders = (int) (rows * ladders);
    for (int k = 0; all.size() < ofLadders; k++) {
      add(all, "ladder" + k, ladder(goal(scene, random), random), scene, ofLadders);
    }
    List<Pose> spots = new ArrayList<>();
    // Some will stand too near to another obstacle.
    for (int k = 0; k < 2 * rows / readings; k++) {
      spots.add(spot(scene, random));
    }
    add(all, "spots", spots, scene, rows);
    return new Recording(all);
  }

  private void add(List<Row> all, String run, List<Pose> places, Scene scene, int most) {
    double tS = 0;
    for (Pose place : places) {
      for (int k = 0; k < readings && all.size() < most && isFree(scene, place); k++) {
        all.add(Rows.row(run, "s0", tS, place));
        tS += periodS;
      }
      tS += moveS;
    }
  }

  private static boolean isFree(Scene scene, Pose pose) {
    return scene.obstacles().stream()
        .allMatch(
            o ->
                StrictMath.hypot(pose.xM() - o.place().xM(), pose.zM() - o.place().zM())
                    > o.radiusM() + 0.9 * NEAREST_M);
  }

  private static Obstacle goal(Scene scene, Chance random) {
    return scene.obstacles().get(random.nextInt(scene.obstacles().size()));
  }

  /** Away from an obstacle at one bearing, step by step, until behind the threshold. */
  private List<Pose> ladder(Obstacle goal, Chance random) {
    double bearing = Math.toRadians(5 * random.nextInt(72));
    double from = goal.radiusM() + NEAREST_M;
    double to = Math.max(from + 4 * stepM, goal.shadow().atM(bearing) * reach);
    List<Pose> places = new ArrayList<>();
    for (double r = from; r < to; r += stepM) {
      places.add(Bench.facing(goal, bearing, r));
    }
    return places;
  }

  private Pose spot(Scene scene, Chance random) {
    Obstacle goal = goal(scene, random);
    double bearing = random.nextDouble(0, 2 * Math.PI);
    double most = Math.max(0.3, goal.shadow().atM(bearing) * reach);
    double r = goal.radiusM() + NEAREST_M + most * random.nextDouble();
    double turn = scene.sensor().halfAngleRad() * random.nextDouble(-1.2, 1.2);
    return Bench.facing(goal, bearing, r).turned(turn);
  }
}
