package simbad.benchmarks;

import java.util.Random;
import java.util.concurrent.TimeUnit;
import javax.vecmath.Vector3d;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;
import simbad.gui.Simbatch;
import simbad.sim.BallAgent;
import simbad.sim.EnvironmentDescription;
import simbad.sim.Wall;

/** Steps under physics: balls without friction roll between four walls and hit each other. */
@State(Scope.Thread)
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.SECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@SuppressWarnings("NullAway.Init") // JMH sets the parameters and calls the setup first.
public class BallsBenchmark {
  private static final double SPACING_M = 0.9;

  /** Number of balls. */
  @Param({"10", "100"})
  int balls;

  private Simbatch simulation;

  /** Builds a square with the balls on a grid in it. */
  @Setup
  public void build() {
    EnvironmentDescription environment = new EnvironmentDescription();
    environment.setUsePhysics(true);
    int side = (int) Math.ceil(Math.sqrt(balls));
    double half = SPACING_M * (side + 1) / 2;
    for (int quarter = 0; quarter < 4; quarter++) {
      double angle = quarter * Math.PI / 2;
      Vector3d middle = new Vector3d(half * Math.cos(angle), 0, half * Math.sin(angle));
      Wall wall = new Wall(middle, (float) (2 * half), 1, environment);
      wall.rotate90(quarter + 1);
      environment.add(wall);
    }
    Random random = new Random(1);
    for (int i = 0; i < balls; i++) {
      double x = SPACING_M * (i % side - (side - 1) / 2.0);
      double z = SPACING_M * (Math.floorDiv(i, side) - (side - 1) / 2.0);
      environment.add(new Rolling(new Vector3d(x, 0, z), random));
    }
    simulation = new Simbatch(environment, false);
    simulation.reset();
  }

  /** Frees the world. */
  @TearDown
  public void dispose() {
    simulation.dispose();
  }

  /** Does one step of all balls. */
  @Benchmark
  public void step() {
    simulation.step();
  }

  private static final class Rolling extends BallAgent {
    private final Vector3d velocity;

    Rolling(Vector3d at, Random random) {
      super(at, "ball", 0.2f);
      staticFrictionCoefficient = 0;
      velocity = new Vector3d(random.nextDouble() - 0.5, 0, random.nextDouble() - 0.5);
    }

    @Override
    protected void initBehavior() {
      linearVelocity.set(velocity);
    }
  }
}
