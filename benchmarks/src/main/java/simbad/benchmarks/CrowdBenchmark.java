package simbad.benchmarks;

import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Setup;

/** Steps of a simulation of many robots with 12 sonars each among 100 obstacles. */
@SuppressWarnings("NullAway.Init") // JMH sets the parameters before anything else.
public class CrowdBenchmark extends StepsBenchmark {
  /** What they hear. */
  @Param Belt belt;

  /** Number of obstacles. */
  @Param("100")
  int obstacles;

  /** Number of robots. */
  @Param({"1", "10", "50", "500"})
  int robots;

  /** How often each robot senses. */
  @Param Sensing sensing;

  /** Builds the world. */
  @Setup
  public void build() {
    measure(new Arena(belt, obstacles, robots, Arena.SONARS, sensing));
  }
}
