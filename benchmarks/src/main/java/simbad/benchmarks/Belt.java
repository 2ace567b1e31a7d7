package simbad.benchmarks;

import java.util.List;
import java.util.SplittableRandom;
import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleType;
import simbad.obstacles.SonarBelt;
import simbad.obstacles.SonarObstacle;
import simbad.sim.Box;
import simbad.sim.EnvironmentDescription;
import simbad.sim.RangeSensorBelt;
import simbad.sim.RobotFactory;
import simbad.sonar.frame.Point;
import simbad.sonar.model.DetectionRule;

/** What robots hear, and with what. */
public enum Belt {
  /** Boxes of 0.6 m and each other, by Simbad's thin rays of 1.5 m. */
  RAYS {
    @Override
    void place(EnvironmentDescription environment, int index, Point at) {
      float side = (float) Arena.BOX_M;
      environment.add(
          new Box(new Vector3d(at.xM(), 0, at.zM()), new Vector3f(side, side, side), environment));
    }

    @Override
    RangeSensorBelt fit(CirclingRobot robot, int sonars) {
      return RobotFactory.addSonarBeltSensor(robot, sonars);
    }
  },
  /** The catalogue's extrusions in turn, where their detection shadows let the SRF04 hear them. */
  SHADOWS {
    @Override
    void place(EnvironmentDescription environment, int index, Point at) {
      placeExtrusion(environment, index, at);
    }

    @Override
    RangeSensorBelt fit(CirclingRobot robot, int sonars) {
      return carried(robot, sonars, DetectionRule.SHADOW);
    }
  },
  /** The same where their echoes are strong enough for the SRF04. */
  LEVEL {
    @Override
    void place(EnvironmentDescription environment, int index, Point at) {
      placeExtrusion(environment, index, at);
    }

    @Override
    RangeSensorBelt fit(CirclingRobot robot, int sonars) {
      return carried(robot, sonars, DetectionRule.LEVEL);
    }
  };

  /** Flat sides look to the cells: over its corners the square is hardly heard. */
  static final double TURN_RAD = Math.PI / 4;

  private static final long SEED = 1;

  private static void placeExtrusion(EnvironmentDescription environment, int index, Point at) {
    List<ObstacleType> types = Catalogue.types();
    Vector3d position = new Vector3d(at.xM(), 0, at.zM());
    environment.add(new SonarObstacle(position, TURN_RAD, types.get(index % types.size())));
  }

  private static RangeSensorBelt carried(CirclingRobot robot, int sonars, DetectionRule rule) {
    SonarBelt belt = new SonarBelt(sonars, Catalogue.srf04(), rule, new SplittableRandom(SEED));
    robot.carry(belt);
    return belt;
  }

  /** Adds an obstacle to a world. */
  abstract void place(EnvironmentDescription environment, int index, Point at);

  /** Adds a belt to a robot. */
  abstract RangeSensorBelt fit(CirclingRobot robot, int sonars);
}
