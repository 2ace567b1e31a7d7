package simbad.benchmarks;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Collection;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.openjdk.jmh.results.RunResult;
import org.openjdk.jmh.runner.BenchmarkList;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.format.OutputFormat;
import org.openjdk.jmh.runner.format.OutputFormatFactory;
import org.openjdk.jmh.runner.options.Options;
import org.openjdk.jmh.runner.options.OptionsBuilder;
import org.openjdk.jmh.runner.options.TimeValue;
import org.openjdk.jmh.runner.options.VerboseMode;

/** Every benchmark runs and gives a figure; which one is not a test's business. */
class BenchmarksTest {
  private static final int MILLISECONDS = 5;

  private static Set<String> names() {
    OutputFormat silent = OutputFormatFactory.createFormatInstance(System.out, VerboseMode.SILENT);
    return BenchmarkList.defaultList().getAll(silent, List.of()).stream()
        .map(entry -> entry.getUsername())
        .collect(Collectors.toCollection(TreeSet::new));
  }

  /**
   * One short iteration in this virtual machine. The faster robot makes short runs; of the sizes of
   * a world one is enough.
   */
  private static Options oneIteration(String name) {
    return new OptionsBuilder()
        .include("^" + Pattern.quote(name) + "$")
        .param("speedMPerS", "1")
        .param("obstacles", "100")
        .param("sonars", "12")
        .param("robots", "10")
        .param("rows", "120")
        .forks(0)
        .warmupIterations(0)
        .measurementIterations(1)
        .measurementTime(TimeValue.milliseconds(MILLISECONDS))
        .shouldFailOnError(true)
        .verbosity(VerboseMode.SILENT)
        .build();
  }

  @Test
  void benchmarks_areAllThere() {
    assertEquals(11, names().size(), names()::toString);
  }

  @TestFactory
  Stream<DynamicTest> benchmark_runsOnce_givesAFigure() {
    return names().stream()
        .map(name -> DynamicTest.dynamicTest(name, () -> checkGivesAFigure(name)));
  }

  @Test
  void processorTime_isReportedBesideTheClocks() throws RunnerException {
    Options options =
        new OptionsBuilder()
            .parent(oneIteration(BaselineBenchmark.class.getName() + ".nothing"))
            .measurementTime(TimeValue.milliseconds(200))
            .addProfiler(ProcessorTimeProfiler.class)
            .build();
    RunResult result = new Runner(options).runSingle();
    double perS =
        Objects.requireNonNull(result.getSecondaryResults().get("perProcessorS")).getScore();
    assertTrue(perS > 0 && perS < Double.POSITIVE_INFINITY, result::toString);
  }

  private static void checkGivesAFigure(String name) throws RunnerException {
    Collection<RunResult> results = new Runner(oneIteration(name)).run();
    assertFalse(results.isEmpty());
    for (RunResult result : results) {
      double score = result.getPrimaryResult().getScore();
      assertTrue(score > 0 && score < Double.POSITIVE_INFINITY, result::toString);
    }
  }
}
