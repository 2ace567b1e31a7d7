package simbad.cluster;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ServiceLoader;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import simbad.experiments.batch.BatchJob;
import simbad.experiments.batch.ResultLog;
import simbad.experiments.workers.Cluster;
import simbad.experiments.workers.LocalWorkers;
import simbad.experiments.workers.Workers;

/** A batch on a master and two workers, one of which is killed in the middle. */
class SparkClusterTest {
  private static final int RUNS = 120;

  private static final String SPEC =
      """
      {
        "format": "simbad-batch/1",
        "obstacles": ["small.csv", "round"],
        "sensors": ["noisy"],
        "speeds_m_per_s": [0.1],
        "seeds": {"from": 1, "count": %d},
        "traces": true
      }
      """
          .formatted(RUNS / 2);

  private static final String TABLE =
      """
      bearing_deg,threshold_m
      0,0.3
      45,0.2
      90,0.25
      135,0.3
      180,0.2
      225,0.3
      270,0.2
      315,0.25
      """;

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  private BatchJob job() throws Exception {
    Files.writeString(folder.resolve("small.csv"), TABLE);
    return BatchJob.read(folder.resolve("spec.json"), SPEC);
  }

  /** Told after each row how many there are. */
  private interface Watch {
    void rows(long count);
  }

  private Path results(String name, BatchJob job, Workers workers, Watch watch) throws Exception {
    Path out = Files.createDirectory(folder.resolve(name));
    try (ResultLog log = ResultLog.open(out, job)) {
      workers.run(
          job,
          0,
          job.size(),
          outcome -> {
            log.append(outcome);
            watch.rows(log.done());
          });
    }
    return out;
  }

  private static void checkSame(Path one, Path other) throws IOException {
    assertEquals(
        Files.readString(one.resolve("results.csv")),
        Files.readString(other.resolve("results.csv")));
    for (int run = 0; run < RUNS; run++) {
      String trace = "traces/%03d.csv".formatted(run);
      assertEquals(-1, Files.mismatch(one.resolve(trace), other.resolve(trace)), trace);
    }
  }

  /** Processes that do not answer must not stop the build for ever. */
  @Test
  @Timeout(300)
  void killedWorker_losesAndDoublesNoRun() throws Exception {
    BatchJob job = job();
    Path local;
    try (Workers threads = new LocalWorkers(2)) {
      local = results("local", job, threads, count -> {});
    }
    assertEquals(RUNS + 1, Files.readAllLines(local.resolve("results.csv")).size());
    try (LocalCluster machines = new LocalCluster(folder, 2);
        Workers spark = new SparkCluster().connect(machines.url())) {
      Path there =
          results(
              "spark",
              job,
              spark,
              count -> {
                if (count == 5) {
                  machines.kill(0);
                }
              });
      checkSame(local, there);
      assertFalse(machines.isAlive(0));
      assertTrue(machines.hadExecutor(0) && machines.hadExecutor(1), "both had runs");
    }
  }

  @Test
  void spark_isFoundAsAService() {
    assertTrue(ServiceLoader.load(Cluster.class).findFirst().orElseThrow() instanceof SparkCluster);
  }

  @Test
  void masterThatIsNone_isSaid() {
    IOException fault =
        assertThrows(IOException.class, () -> new SparkCluster().connect("nowhere"));
    assertTrue(String.valueOf(fault.getMessage()).startsWith("--spark nowhere: "), "" + fault);
  }

  private static void checkRefused(String master, String why) {
    IOException fault =
        assertThrows(IOException.class, () -> new SparkCluster().connect(master), master);
    String said = String.valueOf(fault.getMessage());
    assertTrue(said.startsWith("--spark " + master + ": ") && said.contains(why), said);
    assertTrue(said.endsWith("expected a running Spark master, spark://HOST:PORT"), said);
    assertEquals(1, said.lines().count(), said);
  }

  @Test
  void masterThatDoesNotAnswer_isSaidWithItsHost() throws IOException {
    checkRefused("spark://nowhere.invalid:1", "host nowhere.invalid is not known");
    int free;
    try (ServerSocket socket = new ServerSocket(0)) {
      free = socket.getLocalPort();
    }
    checkRefused(
        "spark://127.0.0.1:" + free, "host 127.0.0.1 does not answer on port " + free + " (");
    checkRefused(
        "spark://nowhere.invalid:1,127.0.0.1:" + free,
        "host nowhere.invalid is not known; host 127.0.0.1 does not answer");
  }

  @Test
  void masterWithoutPort_isSaid() {
    checkRefused("spark://nowhere", "'nowhere' is not HOST:PORT");
    checkRefused("spark://nowhere:0", "'nowhere:0' is not HOST:PORT");
    checkRefused("spark://nowhere:70000", "'nowhere:70000' is not HOST:PORT");
  }
}
