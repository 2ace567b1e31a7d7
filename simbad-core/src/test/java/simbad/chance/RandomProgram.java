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
import simbad.sim.Arch;
import simbad.sim.BlockWorldObject;
import simbad.sim.Box;
import simbad.sim.CherryAgent;
import simbad.sim.Compatibility;
import simbad.sim.EnvironmentDescription;
import simbad.sim.KheperaRobot;
import simbad.sim.Line;
import simbad.sim.SimpleAgent;
import simbad.sim.Simulator;
import simbad.sim.Wall;

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
    WALL,
    ARCH,
    LINE,
    BALL,
    CHERRY,
    KHEPERA,
    WANDERER,
    AVOIDER,
    SEEKER,
    WHEELED,
    PLANNER;

    private static final List<Kind> ALL = List.of(values());
    private static final List<Kind> WITHOUT_MOTORS =
        ALL.stream().filter(kind -> !kind.drives()).toList();

    boolean drives() {
      return compareTo(KHEPERA) >= 0;
    }
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
    boolean drives() {
      return kind.drives();
    }

    /** How far it reaches from where it stands, metres, whichever way it is turned. */
    double reachM() {
      return switch (kind) {
        case BOX, TRAVERSABLE_BOX -> 0.36;
        case WALL -> 0.62;
        case ARCH -> 2.1;
        case LINE -> 0;
        case BALL -> radiusM();
        case CHERRY -> 0.1;
        case KHEPERA -> 0.03;
        default -> 0.3;
      };
    }

    /** Radius of a ball, metres. */
    float radiusM() {
      return 0.1f + 0.3f * new Random(~seed).nextFloat();
    }
  }

  /**
   * What came of a run.
   *
   * @param poses x, y, z, heading, collision and what is known of all agents after each step
   * @param touched the switches that anything depended on
   */
  record Outcome(List<double[]> poses, Set<Compatibility> touched) {}

  /** What looks at a run after each step. */
  interface Watcher {
    void look(int step, Simulator simulator);
  }

  RandomProgram {
    things = List.copyOf(things);
  }

  /** Makes a program by chance: one in five is a crowd, one in five has no motors. */
  static RandomProgram of(long seed) {
    Random random = new Random(seed);
    boolean physics = random.nextInt(2) == 0;
    int count = 1 + random.nextInt(random.nextInt(5) == 0 ? 40 : 9);
    List<Kind> kinds = random.nextInt(5) == 0 ? Kind.WITHOUT_MOTORS : Kind.ALL;
    List<Thing> things = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      Kind kind = kinds.get(random.nextInt(kinds.size()));
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
    double reachM = one.reachM() + other.reachM() + 0.02;
    return Math.hypot(one.x - other.x, one.z - other.z) < reachM;
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
    return things.stream().anyMatch(Thing::drives);
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
      poses.add(poses(simulation.getSimulator().getAgentList()));
      watcher.look(step, simulation.getSimulator());
    }
    simulation.dispose();
    return new Outcome(poses, environment.touched());
  }

  private static double[] poses(List<SimpleAgent> agents) {
    double[] row = new double[6 * agents.size()];
    Point3d at = new Point3d();
    for (int i = 0; i < agents.size(); i++) {
      SimpleAgent agent = agents.get(i);
      agent.getCoords(at);
      row[6 * i] = at.x;
      row[6 * i + 1] = at.y;
      row[6 * i + 2] = at.z;
      row[6 * i + 3] = agent.getHeadingRad();
      row[6 * i + 4] = agent.collisionDetected() ? 1 : 0;
      row[6 * i + 5] = agent instanceof RandomRobot robot ? robot.known() : 0;
    }
    return row;
  }

  private static void add(Thing thing, EnvironmentDescription environment) {
    Random random = new Random(thing.seed);
    Vector3d at = new Vector3d(thing.x, thing.y, thing.z);
    switch (thing.kind) {
      case BOX, TRAVERSABLE_BOX, WALL, ARCH, LINE -> addStatic(thing, at, random, environment);
      case BALL -> environment.add(new RandomBall(at, random, thing.radiusM()));
      case CHERRY -> {
        CherryAgent cherry = new CherryAgent(at, "cherry", 0.1f);
        cherry.setCanBeTraversed(true);
        environment.add(cherry);
      }
      case KHEPERA -> environment.add(new Khepera(at, random));
      default -> environment.add(new RandomRobot(thing.kind, at, random));
    }
  }

  private static void addStatic(
      Thing thing, Vector3d at, Random random, EnvironmentDescription environment) {
    BlockWorldObject block =
        switch (thing.kind) {
          case WALL -> new Wall(at, 1.2f * random.nextFloat(), random.nextFloat(), environment);
          case ARCH -> new Arch(at, environment);
          case LINE -> new Line(at, 3 * random.nextFloat(), environment);
          default -> new Box(at, sides(random), environment);
        };
    block.rotate90(random.nextInt(4));
    block.setCanBeTraversed(thing.kind == Kind.TRAVERSABLE_BOX || thing.kind == Kind.LINE);
    environment.add(block);
  }

  private static Vector3f sides(Random random) {
    return new Vector3f(
        0.1f + 0.4f * random.nextFloat(),
        0.1f + random.nextFloat(),
        0.1f + 0.4f * random.nextFloat());
  }

  /** Turns away from what its eyes see. */
  private static final class Khepera extends KheperaRobot {
    private final double speed;

    Khepera(Vector3d at, Random random) {
      super(at, "khepera");
      speed = 0.1 * random.nextDouble();
    }

    @Override
    public void performBehavior() {
      setWheelsVelocity(speed, getIRSensors().oneHasHit() ? -speed : 0.9 * speed);
    }
  }
}
