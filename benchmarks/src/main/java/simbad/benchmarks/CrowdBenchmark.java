package simbad.benchmarks;

import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Setup;

/** Steps of a simulation of many robots with 12 sonars each among 100 boxes. */
@SuppressWarnings("NullAway.Init") // JMH sets the parameters before anything else.
public class CrowdBenchmark extends StepsBenchmark {
  private static final int BOXES = 100;

  /** Number of robots. */
  @Param({"10", "50"})
  int robots;

  /** How often each robot senses. */
  @Param Sensing sensing;

  /** Builds the world. */
  @Setup
  public void build() {
    measure(new Arena(BOXES, robots, Arena.SONARS, sensing));
  }
}
