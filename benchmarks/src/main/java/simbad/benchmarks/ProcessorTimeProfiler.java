package simbad.benchmarks;

import com.sun.management.OperatingSystemMXBean;
import java.lang.management.ManagementFactory;
import java.util.Collection;
import java.util.List;
import org.openjdk.jmh.infra.BenchmarkParams;
import org.openjdk.jmh.infra.IterationParams;
import org.openjdk.jmh.profile.InternalProfiler;
import org.openjdk.jmh.results.AggregationPolicy;
import org.openjdk.jmh.results.IterationResult;
import org.openjdk.jmh.results.Result;
import org.openjdk.jmh.results.ScalarResult;

/**
 * Reports operations per second of processor time: what an iteration would do had it a core for
 * itself. On a machine with other work the clock says how much of a core was left over; this does
 * not.
 *
 * <p>All threads of the virtual machine count, the compiler's and the collector's, too: the figure
 * is rather too low than too high. Use: {@code -prof simbad.benchmarks.ProcessorTimeProfiler}.
 */
public class ProcessorTimeProfiler implements InternalProfiler {
  private static final double NS_PER_S = 1e9;

  private final OperatingSystemMXBean system =
      ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class);
  private long beforeNs;

  /** Creates a profiler; JMH does. */
  public ProcessorTimeProfiler() {}

  @Override
  public String getDescription() {
    return "operations per second of processor time";
  }

  @Override
  public void beforeIteration(BenchmarkParams benchmark, IterationParams iteration) {
    beforeNs = system.getProcessCpuTime();
  }

  @Override
  public Collection<? extends Result<?>> afterIteration(
      BenchmarkParams benchmark, IterationParams iteration, IterationResult result) {
    double tookS = (system.getProcessCpuTime() - beforeNs) / NS_PER_S;
    double perS = result.getMetadata().getAllOps() / tookS;
    return List.of(new ScalarResult("perProcessorS", perS, "ops/s", AggregationPolicy.AVG));
  }
}
