package simbad.benchmarks;

import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import simbad.kernel.belt.BeltLayout;
import simbad.sonar.frame.Point;
import simbad.sonar.sensing.TransducerPoses;

/** What the measuring itself costs: the part of every other figure that is not the simulator's. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class BaselineBenchmark {
  private final Circle circle = new Circle(new Point(0, 0), BeltLayout.ring(0, 1, 12));

  /** JMH's loop with nothing in it. */
  @Benchmark
  public void nothing() {
    // Nothing.
  }

  /** What each belt benchmark does besides the ping. */
  @Benchmark
  public TransducerPoses nextPoses() {
    return circle.step();
  }
}
