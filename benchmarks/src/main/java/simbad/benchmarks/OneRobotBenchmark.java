package simbad.benchmarks;

import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Setup;

/** Steps of a simulation of one robot with sonars among obstacles. */
@SuppressWarnings("NullAway.Init") // JMH sets the parameters before anything else.
public class OneRobotBenchmark extends StepsBenchmark {
  /** What they hear. */
  @Param Belt belt;

  /** Number of obstacles. */
  @Param({"1", "10", "100", "500", "5000"})
  int obstacles;

  /** Number of sonars. */
  @Param({"12", "9", "24"})
  int sonars;

  /** How often the robot senses. */
  @Param Sensing sensing;

  /** Builds the world. */
  @Setup
  public void build() {
    measure(new Arena(belt, obstacles, 1, sonars, sensing));
  }
}
