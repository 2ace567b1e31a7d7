package simbad.benchmarks;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;
import simbad.experiments.report.RunOrigin;
import simbad.experiments.run.Experiment;
import simbad.experiments.run.RunResult;
import simbad.experiments.run.RunSettings;
import simbad.experiments.run.SensorKind;
import simbad.figures.report.RunReport;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleType;

/**
 * Whole runs, each from nothing. The first iterations include what the virtual machine still has to
 * compile, as it has for who starts the program.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.SingleShotTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(1)
@Warmup(iterations = 3)
@Measurement(iterations = 5)
@SuppressWarnings("NullAway.Init") // JMH calls the setup before anything else.
public class RunBenchmark {
  private static final long SEED = 1;

  /** Speed of the robot in metres per second: the number of steps is inverse to it. */
  @Param("0.01")
  double speedMPerS;

  private Path folder;

  /** Makes the folder for results. */
  @Setup(Level.Iteration)
  public void makeFolder() throws IOException {
    folder = Files.createTempDirectory("simbad-benchmark");
  }

  /** Deletes the results. */
  @TearDown(Level.Iteration)
  public void deleteFolder() throws IOException {
    try (Stream<Path> files = Files.walk(folder)) {
      for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
        Files.delete(file);
      }
    }
  }

  /**
   * One robot once round the angle with the shadow sensor, and the map of 39,366 pings that belongs
   * to it; one thread, no files.
   */
  @Benchmark
  public List<RunResult> angleWithShadow() {
    ObstacleType angle = Catalogue.find("angle").orElseThrow();
    return drive(settings(List.of(angle), List.of(SensorKind.SHADOW)));
  }

  /** What {@code simbad run} drives, all cores: three obstacles, two sensors; no files. */
  @Benchmark
  public List<RunResult> mainJobDrivesOnly() {
    return drive(mainJobSettings());
  }

  /** What {@code simbad run} does, all cores, with every file and picture. */
  @Benchmark
  public List<RunResult> mainJob() throws IOException {
    RunSettings settings = mainJobSettings();
    List<RunResult> results = drive(settings);
    RunReport.write(folder, new RunOrigin("benchmark", settings), results);
    return results;
  }

  private RunSettings mainJobSettings() {
    return settings(Catalogue.types(), List.of(SensorKind.ORIGINAL, SensorKind.SHADOW));
  }

  private RunSettings settings(List<ObstacleType> types, List<SensorKind> sensors) {
    return new RunSettings(types, sensors, Catalogue.srf04(), speedMPerS, Optional.empty(), SEED);
  }

  private static List<RunResult> drive(RunSettings settings) {
    return Experiment.run(settings, result -> {});
  }
}
