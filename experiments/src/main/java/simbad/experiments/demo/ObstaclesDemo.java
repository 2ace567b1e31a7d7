package simbad.experiments.demo;

import java.util.List;
import javax.vecmath.Vector3d;
import simbad.demo.Demo;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleType;
import simbad.obstacles.SonarObstacle;
import simbad.sim.World;

/** All obstacle types that come with the project, side by side, each turned and with its shadow. */
public final class ObstaclesDemo extends Demo {
  private static final int COLUMNS = 3;
  private static final double APART_M = 6;

  /** Creates the environment. */
  public ObstaclesDemo() {
    List<ObstacleType> types = Catalogue.shipped();
    setWorldSize((float) (APART_M * (COLUMNS + 1)));
    worldViewPoint = World.VIEW_FROM_TOP;
    for (int i = 0; i < types.size(); i++) {
      double x = (i % COLUMNS - (COLUMNS - 1) / 2.0) * APART_M;
      int row = i / COLUMNS;
      double z = (row - (COLUMNS - 1) / 2.0) * APART_M;
      double turnRad = i * Math.PI / types.size();
      add(new SonarObstacle(new Vector3d(x, 0, z), turnRad, types.get(i)));
    }
  }
}
