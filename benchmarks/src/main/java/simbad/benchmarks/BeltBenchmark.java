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
import simbad.sonar.sensing.Readings;
import simbad.sonar.sensing.Sensor;

/** One reading of a belt of 12 transducers, without a simulation round it. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@SuppressWarnings("NullAway.Init") // JMH calls the setup before anything else.
public abstract class BeltBenchmark {
  private final Readings readings = new Readings(Arena.SONARS);
  private Circle circle;
  private Sensor sensor;

  /** What a subclass's setup ends with. */
  final void measure(Sensor newSensor, Circle newCircle) {
    sensor = newSensor;
    circle = newCircle;
    checkHears();
  }

  /** A belt that hears nothing is faster than one that does: such figures would mislead. */
  private void checkHears() {
    boolean heard = false;
    for (int place = 0; place < Circle.PLACES; place++) {
      Readings latest = ping();
      for (int i = 0; i < latest.size(); i++) {
        heard |= latest.isEcho(i);
      }
    }
    if (!heard) {
      throw new IllegalStateException("the belt hears nothing");
    }
  }

  /** Reads the belt once. */
  @Benchmark
  public Readings ping() {
    sensor.ping(circle.step(), 0, readings);
    return readings;
  }
}
