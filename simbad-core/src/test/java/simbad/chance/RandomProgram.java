package simbad.chance;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;
import simbad.gui.Simbatch;
import simbad.sim.Agent;
import simbad.sim.BallAgent;
import simbad.sim.Box;
import simbad.sim.CherryAgent;
import simbad.sim.Compatibility;
import simbad.sim.EnvironmentDescription;
import simbad.sim.Plan;
import simbad.sim.RangeSensorBelt;
import simbad.sim.RobotFactory;
import simbad.sim.SimpleAgent;

/**
 * A program for Simbad as people write them: a world, robots with sensors and a behaviour, balls,
 * cherries, now and then a reset. It can be run any number of times.
 *
 * @param things what the world contains; bodies that move do not overlap at the start
 * @param physics whether it is on
 * @param resetEvery steps between two resets
 * @param steps how many
 */
record RandomProgram(List<Thing> things, boolean physics, int resetEvery, int steps) {
  /** What a thing is. */
  enum Kind {
    BOX,
    TRAVERSABLE_BOX,
    WANDERER,
    AVOIDER,
    PLANNER,
    BALL,
    CHERRY
  }

  /**
   * A thing.
   *
   * @param x metres
   * @param y metres above the floor
   * @param z metres
   * @param seed of what else it is: sides, sensors, speeds
   */
  record Thing(Kind kind, double x, double y, double z, long seed) {
    boolean moves() {
      return kind != Kind.BOX && kind != Kind.TRAVERSABLE_BOX;
    }
  }

  /**
   * What came of a run.
   *
   * @param poses x, y, z, heading and collision of all agents after each step
   * @param touched the switches that anything depended on
   */
  record Outcome(List<double[]> poses, Set<Compatibility> touched) {}

  /** What looks at a run after each step. */
  interface Watcher {
    void look(int step, List<SimpleAgent> agents);
  }

  RandomProgram {
    things = List.copyOf(things);
  }

  /** Makes a program by chance. */
  static RandomProgram of(long seed) {
    Random random = new Random(seed);
    boolean physics = random.nextInt(3) == 0;
    int count = 1 + random.nextInt(9);
    List<Thing> things = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      Kind kind = Kind.values()[random.nextInt(Kind.values().length)];
      double y = random.nextInt(6) == 0 ? random.nextDouble() : 0;
      Thing thing =
          new Thing(
              kind, 6 * random.nextDouble() - 3, y, 6 * random.nextDouble() - 3, random.nextLong());
      if (things.stream().noneMatch(other -> near(thing, other))) {
        things.add(thing);
      }
    }
    return new RandomProgram(things, physics, 40 + random.nextInt(100), 150);
  }

  private static boolean near(Thing one, Thing other) {
    return Math.hypot(one.x - other.x, one.z - other.z) < 1.2;
  }

  /** Returns the program without one of its things. */
  RandomProgram without(int thing) {
    List<Thing> fewer = new ArrayList<>(things);
    fewer.remove(thing);
    return new RandomProgram(fewer, physics, resetEvery, steps);
  }

  /** Returns the program with another number of steps. */
  RandomProgram lasting(int newSteps) {
    return new RandomProgram(things, physics, resetEvery, newSteps);
  }

  boolean hasMotors() {
    return things.stream().anyMatch(t -> t.moves() && t.kind != Kind.BALL && t.kind != Kind.CHERRY);
  }

  /** Runs it with some switches. */
  Outcome run(Set<Compatibility> switches, Watcher watcher) {
    EnvironmentDescription environment = new EnvironmentDescription();
    environment.compatibility = EnumSet.noneOf(Compatibility.class);
    environment.compatibility.addAll(switches);
    environment.usePhysics = physics;
    things.forEach(thing -> add(thing, environment));
    Simbatch simulation = new Simbatch(environment, false);
    simulation.reset();
    List<double[]> poses = new ArrayList<>();
    for (int step = 1; step <= steps; step++) {
      if (step % resetEvery == 0) {
        simulation.reset();
      }
      simulation.step();
      List<SimpleAgent> agents = simulation.getSimulator().getAgentList();
      poses.add(poses(agents));
      watcher.look(step, agents);
    }
    simulation.dispose();
    return new Outcome(poses, environment.touched());
  }

  private static double[] poses(List<SimpleAgent> agents) {
    double[] row = new double[5 * agents.size()];
    Point3d at = new Point3d();
    for (int i = 0; i < agents.size(); i++) {
      agents.get(i).getCoords(at);
      row[5 * i] = at.x;
      row[5 * i + 1] = at.y;
      row[5 * i + 2] = at.z;
      row[5 * i + 3] = agents.get(i).getHeadingRad();
      row[5 * i + 4] = agents.get(i).collisionDetected() ? 1 : 0;
    }
    return row;
  }

  private static void add(Thing thing, EnvironmentDescription environment) {
    Random random = new Random(thing.seed);
    Vector3d at = new Vector3d(thing.x, thing.y, thing.z);
    switch (thing.kind) {
      case BOX, TRAVERSABLE_BOX -> {
        Vector3f sides =
            new Vector3f(
                0.1f + 0.4f * random.nextFloat(),
                0.1f + random.nextFloat(),
                0.1f + 0.4f * random.nextFloat());
        Box box = new Box(at, sides, environment);
        box.setCanBeTraversed(thing.kind == Kind.TRAVERSABLE_BOX);
        environment.add(box);
      }
      case BALL -> environment.add(new BallAgent(at, "ball", 0.1f + 0.3f * random.nextFloat()));
      case CHERRY -> {
        CherryAgent cherry = new CherryAgent(at, "cherry", 0.1f);
        cherry.setCanBeTraversed(true);
        environment.add(cherry);
      }
      default -> environment.add(new Robot(thing, at, random));
    }
  }

  /** Drives by its sensors, by a plan or by chance. */
  private static final class Robot extends Agent {
    private final Kind kind;
    private final RangeSensorBelt belt;
    private final Plan plan = new Plan(this);
    private final double speed;
    private final double turn;

    Robot(Thing thing, Vector3d at, Random random) {
      super(at, "robot");
      kind = thing.kind;
      belt = RobotFactory.addSonarBeltSensor(this, 1 + random.nextInt(12));
      belt.setUpdateOnEachFrame(random.nextBoolean());
      speed = random.nextDouble();
      turn = random.nextDouble() - 0.5;
      for (int i = random.nextInt(4); i >= 0; i--) {
        plan.forward(random.nextDouble(), 0.1 + random.nextDouble());
        plan.turn(random.nextDouble(), 0.1 + random.nextDouble());
      }
      if (random.nextBoolean()) {
        plan.loop();
      }
    }

    @Override
    protected void initBehavior() {
      plan.reset();
    }

    @Override
    protected void performBehavior() {
      switch (kind) {
        case PLANNER -> plan.doStep();
        case AVOIDER -> avoid();
        default -> drive(speed, turn);
      }
    }

    private void avoid() {
      boolean blocked = collisionDetected() || belt.getFrontQuadrantMeasurement() < 0.6;
      drive(blocked ? 0.1 : speed, blocked || anOtherAgentIsVeryNear() ? 1 : turn);
    }

    private void drive(double t, double r) {
      setTranslationalVelocity(t);
      setRotationalVelocity(r);
    }
  }
}
