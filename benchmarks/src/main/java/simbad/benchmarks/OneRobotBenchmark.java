package simbad.benchmarks;

import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Setup;

/** Steps of a simulation of one robot with sonars among boxes. */
@SuppressWarnings("NullAway.Init") // JMH sets the parameters before anything else.
public class OneRobotBenchmark extends StepsBenchmark {
  /** Number of boxes. */
  @Param({"1", "10", "100", "500"})
  int boxes;

  /** Number of sonars. */
  @Param({"9", "12", "24"})
  int sonars;

  /** How often the robot senses. */
  @Param Sensing sensing;

  /** Builds the world. */
  @Setup
  public void build() {
    measure(new Arena(boxes, 1, sonars, sensing));
  }
}
