package simbad.demo;

import javax.vecmath.Vector3d;
import simbad.sim.EnvironmentDescription;
import simbad.sim.Wall;

/** An environment that shows something. Programs extend it, too. */
public class Demo extends EnvironmentDescription {
  private static final float WALL_HEIGHT_M = 1;

  /** Creates an empty environment. */
  public Demo() {}

  /** Puts walls on the four sides of a square round the origin, and a floor under them. */
  final void addSquareOfWalls(float sideM) {
    setWorldSize(sideM + 1);
    addWall(sideM / 2, 0, sideM, 1);
    addWall(-sideM / 2, 0, sideM, 1);
    addWall(0, sideM / 2, sideM, 0);
    addWall(0, -sideM / 2, sideM, 0);
  }

  private void addWall(double xM, double zM, float lengthM, int quarters) {
    Wall wall = new Wall(new Vector3d(xM, 0, zM), lengthM, WALL_HEIGHT_M, this);
    wall.rotate90(quarters);
    add(wall);
  }
}
