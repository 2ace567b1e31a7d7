package simbad.sim;

import javax.vecmath.Vector3d;

/** Fills environments. */
public class WorldFactory extends Factory {
  private static final float LENGTH_M = 18;
  private static final float WIDTH_M = 12;
  private static final float GOAL_M = 3;
  private static final float HEIGHT_M = 0.6f;
  private static final float THICKNESS_M = 0.3f;
  private static final float BALL_RADIUS_M = 0.25f;

  /** Creates a factory; its methods are static. */
  public WorldFactory() {}

  /**
   * Makes a soccer field: 18 m along x by 12 m, walls round it with a goal of 3 m in the middle of
   * each short side, and a ball on the centre spot.
   */
  public static void setRoboSoccerEnvironment(EnvironmentDescription environment) {
    environment.setWorldSize(LENGTH_M + 2);
    for (int side = -1; side <= 1; side += 2) {
      environment.add(
          new Wall(
              new Vector3d(0, 0, side * WIDTH_M / 2),
              LENGTH_M,
              THICKNESS_M,
              HEIGHT_M,
              environment));
      addGoalSide(environment, side, -1);
      addGoalSide(environment, side, 1);
    }
    environment.add(new BallAgent(new Vector3d(), "ball", BALL_RADIUS_M));
  }

  private static void addGoalSide(EnvironmentDescription environment, int end, int side) {
    float length = (WIDTH_M - GOAL_M) / 2;
    Vector3d middle = new Vector3d(end * LENGTH_M / 2, 0, side * (GOAL_M + length) / 2);
    Wall wall = new Wall(middle, length, THICKNESS_M, HEIGHT_M, environment);
    wall.rotate90(1);
    environment.add(wall);
  }
}
