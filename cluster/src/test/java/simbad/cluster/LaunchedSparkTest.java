package simbad.cluster;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.spi.ToolProvider;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** The launcher, this program's jars and a real master with two workers, all together. */
@Tag("full")
class LaunchedSparkTest {
  private static final Path LAUNCHER = Path.of("..", "simbad");
  private static final Path SPARK_JARS =
      Path.of(System.getProperty("simbad.spark.home", "")).resolve("jars");

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path root;

  /**
   * A project that is built already, so that no Maven runs on the files of the one that runs this.
   */
  @BeforeEach
  void layOutABuild() throws IOException {
    Path launcher = root.resolve("experiments/target/launcher");
    Path build = Files.createDirectories(launcher.resolve("build-000000"));
    Path spark = Files.createDirectory(build.resolve("spark"));
    Files.createSymbolicLink(spark.resolve("jars"), SPARK_JARS.toAbsolutePath());
    Files.copy(Path.of("src", "main", "java-options"), spark.resolve("java-options"));
    int number = 0;
    for (String entry : System.getProperty("java.class.path").split(File.pathSeparator, -1)) {
      Path path = Path.of(entry).toAbsolutePath();
      boolean ofThisModule = path.endsWith(Path.of("cluster", "target", "classes"));
      Path jar = ofThisModule ? spark.resolve("cluster.jar") : build.resolve(number++ + ".jar");
      if (Files.isDirectory(path)) {
        pack(path, jar);
      } else if (Files.isRegularFile(path)
          && !Files.exists(SPARK_JARS.resolve(path.getFileName()))) {
        Files.copy(path, jar);
      }
    }
    Files.copy(LAUNCHER, root.resolve("simbad"));
    Files.writeString(launcher.resolve("stamp"), "unknown build-000000\n");
  }

  private static void pack(Path classes, Path jar) {
    int status =
        ToolProvider.findFirst("jar")
            .orElseThrow()
            .run(System.out, System.err, "-cf", "" + jar, "-C", "" + classes, ".");
    assertEquals(0, status);
  }

  /** Runs the launcher's batch into a folder of that name. */
  private Path batch(String name, String... where) throws IOException, InterruptedException {
    Path out = root.resolve(name);
    List<String> command =
        Stream.concat(
                Stream.of("bash", "simbad", "batch", "spec.json", "--out", "" + out),
                Stream.of(where))
            .toList();
    ProcessBuilder builder =
        new ProcessBuilder(command).directory(root.toFile()).redirectErrorStream(true);
    builder.environment().put("JAVA_HOME", System.getProperty("java.home"));
    builder.environment().put("SPARK_LOCAL_IP", "127.0.0.1");
    Process process = builder.start();
    process.getOutputStream().close();
    String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, process.waitFor(), output);
    return out;
  }

  @Test
  @Timeout(300)
  void batch_onARealCluster_hasTheSameRowsAsOnThisMachine() throws Exception {
    Files.writeString(
        root.resolve("spec.json"),
        """
        {
          "format": "simbad-batch/1",
          "obstacles": ["round"],
          "sensors": ["noisy"],
          "speeds_m_per_s": [0.1],
          "seeds": {"from": 1, "count": 24}
        }
        """);
    Path here = batch("here", "--jobs", "1");
    try (LocalCluster machines = new LocalCluster(root, 2)) {
      Path there = batch("there", "--spark", machines.url());
      assertEquals(25, Files.readAllLines(here.resolve("results.csv")).size());
      assertEquals(
          Files.readString(here.resolve("results.csv")),
          Files.readString(there.resolve("results.csv")));
      assertTrue(machines.hadExecutor(0) || machines.hadExecutor(1), "the cluster had the runs");
    }
  }
}
