package simbad.cluster;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

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
   * A project that is built already, so that no Maven runs on the files of the one that runs this:
   * the jars of the phase package, as the launcher lays them out.
   */
  @BeforeEach
  void layOutABuild() throws IOException {
    Path launcher = root.resolve("cli/target/launcher");
    Path build = Files.createDirectories(launcher.resolve("build-000000"));
    Path spark = Files.createDirectory(build.resolve("spark"));
    Files.createSymbolicLink(spark.resolve("jars"), SPARK_JARS.toAbsolutePath());
    Files.copy(Path.of("src", "main", "java-options"), spark.resolve("java-options"));
    pack(Path.of("target", "classes"), spark.resolve("cluster.jar"));
    Path packaged = Path.of("..", "cli", "target");
    Files.copy(packaged.resolve("cli.jar"), build.resolve("cli.jar"));
    try (Stream<Path> libraries = Files.list(packaged.resolve("lib"))) {
      for (Path jar : libraries.toList()) {
        Files.copy(jar, build.resolve(jar.getFileName()));
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

  /** Has the launcher do a command into a folder of that name. */
  private Path launched(String line, String name, String... where)
      throws IOException, InterruptedException {
    Path out = root.resolve(name);
    List<String> command =
        Stream.of(
                Stream.of("bash", "simbad"),
                Stream.of(line.split(" ")),
                Stream.of("--out", "" + out),
                Stream.of(where))
            .flatMap(words -> words)
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
    Path here = launched("batch spec.json", "here", "--jobs", "1");
    try (LocalCluster machines = new LocalCluster(root, 2)) {
      Path there = launched("batch spec.json", "there", "--spark", machines.url());
      assertEquals(25, Files.readAllLines(here.resolve("results.csv")).size());
      assertEquals(
          Files.readString(here.resolve("results.csv")),
          Files.readString(there.resolve("results.csv")));
      assertTrue(machines.hadExecutor(0) || machines.hadExecutor(1), "the cluster had the runs");
    }
  }

  /** The processes that diagnose are started by the workers, of the jars that were sent to them. */
  @Test
  @Timeout(600)
  void blindCheck_onARealCluster_hasTheSameAnswersAsOnThisMachine() throws Exception {
    String line = "blind-check --cases 4 --seed 5 --rows 240-300 --mix none:1,single:1";
    Path here = launched(line, "here", "--jobs", "1");
    try (LocalCluster machines = new LocalCluster(root, 2)) {
      Path there = launched(line, "there", "--spark", machines.url());
      assertTrue(machines.hadExecutor(0) || machines.hadExecutor(1), "the cluster had the cases");
      List<String> names = files(here);
      assertEquals(names, files(there));
      List<String> answers = names.stream().filter(name -> name.startsWith("answers/")).toList();
      assertEquals(4, answers.stream().filter(name -> name.endsWith("predictions.csv")).count());
      for (String name : List.of("scores.csv", "cases.csv", "confusion.csv", "scores.txt")) {
        assertEquals(-1, Files.mismatch(here.resolve(name), there.resolve(name)), name);
      }
      for (String name : answers) {
        if (!name.endsWith(".html")) {
          assertEquals(-1, Files.mismatch(here.resolve(name), there.resolve(name)), name);
        }
      }
    }
  }

  private static List<String> files(Path folder) throws IOException {
    try (Stream<Path> paths = Files.walk(folder)) {
      return paths
          .filter(Files::isRegularFile)
          .map(path -> folder.relativize(path).toString())
          .sorted()
          .toList();
    }
  }
}
