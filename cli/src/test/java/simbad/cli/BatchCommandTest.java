package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simbad.experiments.batch.MoodyControllerMaker;
import simbad.experiments.batch.Specs;

/** Batches from the command line, in this process and in processes that are ended half-way. */
class BatchCommandTest {
  /** 24 runs of some hundred steps; the last 12 wait when the environment says so. */
  private static final String SPEC =
      """
      {
        "format": "simbad-batch/1",
        "obstacles": ["small.csv"],
        "sensors": ["noisy"],
        "controllers": [{"name": "edge-follower"}, {"name": "moody", "parameters": {"mood": 3}}],
        "speeds_m_per_s": [0.2],
        "seeds": {"from": 1, "count": 12},
        "traces": true
      }
      """;

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  @SuppressWarnings("NullAway.Init")
  private Path spec;

  @BeforeEach
  void writeSpec() throws IOException {
    Files.writeString(folder.resolve("small.csv"), Specs.TABLE);
    spec = Files.writeString(folder.resolve("spec.json"), SPEC);
  }

  private Shell batch(Path someSpec, String out, String... further) {
    List<String> arguments =
        new ArrayList<>(
            List.of("batch", someSpec.toString(), "--out", folder.resolve(out).toString()));
    arguments.addAll(List.of(further));
    return Shell.simbad(arguments.toArray(String[]::new));
  }

  private Map<String, byte[]> files(String out) throws IOException {
    Path root = folder.resolve(out);
    Map<String, byte[]> files = new TreeMap<>();
    try (Stream<Path> entries = Files.walk(root)) {
      for (Path file : entries.filter(Files::isRegularFile).toList()) {
        files.put(root.relativize(file).toString(), Files.readAllBytes(file));
      }
    }
    return files;
  }

  private void checkSame(String one, String other) throws IOException {
    Map<String, byte[]> expected = files(one);
    Map<String, byte[]> found = files(other);
    assertEquals(expected.keySet(), found.keySet());
    expected.forEach((name, bytes) -> assertArrayEquals(bytes, found.get(name), name));
  }

  private static void checkRefused(Shell shell, int status, String part) {
    assertEquals(status, shell.status(), shell.err());
    assertEquals(1, shell.complaints().size(), shell.err());
    assertTrue(shell.err().contains(part), shell.err());
  }

  private Process start(String out, String before) throws IOException {
    List<String> command = new ArrayList<>(List.of("bash", "-c", before + "exec \"$@\"", "bash"));
    command.addAll(
        SimbadProcess.java(
            "-XX:-UsePerfData",
            "-Djava.awt.headless=true",
            Main.class.getName(),
            "batch",
            spec.toString(),
            "--out",
            folder.resolve(out).toString()));
    return new ProcessBuilder(command).redirectErrorStream(true).start();
  }

  /** Starts a process that stops before its 13th run. */
  private Process startAndWaitForTwelveRows(String out) throws Exception {
    Process process = start(out, "export " + MoodyControllerMaker.WAITS + "=1; ");
    Path results = folder.resolve(out).resolve("results.csv");
    while (!Files.exists(results) || Files.readAllLines(results).size() < 13) {
      assertTrue(process.isAlive(), () -> outputOf(process));
      Thread.sleep(20);
    }
    return process;
  }

  private static String outputOf(Process process) {
    try {
      return new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      return e.toString();
    }
  }

  @Test
  void anyNumberOfJobs_givesTheSameBytes() throws IOException {
    Shell one = batch(spec, "one", "--jobs", "1");
    assertEquals(0, one.status(), one.err());
    assertTrue(one.out().contains("24 runs in"), one.out());
    assertEquals(0, batch(spec, "three", "--jobs", "3").status());
    checkSame("one", "three");
    assertEquals(24 + 5, files("one").size(), "traces, results, report, batch, spec, table");
    Shell again = batch(spec, "one");
    assertEquals(0, again.status(), again.err());
    checkSame("one", "three");
  }

  @Test
  void killedBatch_goesOnWithoutItsTable() throws Exception {
    assertEquals(0, batch(spec, "whole").status());
    Process process = startAndWaitForTwelveRows("killed");
    process.destroyForcibly().waitFor();
    Path results = folder.resolve("killed/results.csv");
    assertEquals(13, Files.readAllLines(results).size());
    Files.writeString(results, "12,,small,noi", StandardOpenOption.APPEND);
    Files.delete(folder.resolve("small.csv"));
    Shell shell = batch(spec, "killed");
    assertEquals(0, shell.status(), shell.err());
    assertTrue(shell.out().contains("12 of 24 runs are there already"), shell.out());
    checkSame("whole", "killed");
  }

  @Test
  void interruptedBatch_saysWhatIsThere() throws Exception {
    Process process = startAndWaitForTwelveRows("stopped");
    checkRefused(batch(spec, "stopped"), 1, "another process is working on this batch");
    // Unlike the process's own method, this leaves its output open.
    process.toHandle().destroy();
    String output = outputOf(process);
    assertEquals(143, process.waitFor());
    assertTrue(output.contains("12 of 24 runs are in " + folder.resolve("stopped")), output);
  }

  /** A limit on the size of files stands for a full disk: the row does not fit. */
  @Test
  void rowThatDoesNotFit_endsTheBatchInOneLine() throws Exception {
    spec =
        Files.writeString(
            folder.resolve("spec.json"),
            SPEC.replace("\"traces\": true", "\"traces\": false").replace(": 12}", ": 40}"));
    assertEquals(0, batch(spec, "whole").status());
    Process process = start("full", "ulimit -f 4; ");
    String output = outputOf(process);
    assertEquals(1, process.waitFor(), output);
    assertEquals(1, output.lines().count(), output);
    assertTrue(output.matches("(?s)simbad batch: .*full: run \\d+: File too large.*"), output);
    String kept = Files.readString(folder.resolve("full/results.csv"));
    assertTrue(kept.endsWith("\n") && kept.lines().count() > 5, kept);
    assertEquals(0, batch(spec, "full").status());
    checkSame("whole", "full");
  }

  @Test
  void failedRuns_areCountedAndTheirRowsKept() throws IOException {
    Files.writeString(spec, SPEC.replace("\"mood\": 3", "\"mood\": [0, 1, 2]"));
    Shell shell = batch(spec, "out");
    checkRefused(shell, 1, "24 of 48 runs failed; their rows say why");
    assertEquals(49, Files.readAllLines(folder.resolve("out/results.csv")).size());
    String page = Files.readString(folder.resolve("out/report.html"));
    assertTrue(
        page.contains("<strong>48 runs</strong>: 24 failed, 12 did not complete the round"), page);
    assertTrue(page.contains("<h2>Runs that went wrong: 36</h2>"), page);
    checkRefused(batch(spec, "out"), 1, "24 of 48 runs failed");
  }

  @Test
  void folderOfAnotherBatch_isRefused() throws IOException {
    assertEquals(0, batch(spec, "out").status());
    Path other = Files.writeString(folder.resolve("other.json"), SPEC + "\n");
    checkRefused(batch(other, "out"), 2, "out/spec.json: is not the same spec as " + other);
    Path origin = folder.resolve("out/batch.json");
    String text = Files.readString(origin);
    Files.writeString(origin, text.replaceAll("\"version\": \"[^\"]*\"", "\"version\": \"0.0.1\""));
    checkRefused(batch(spec, "out"), 2, "batch.json:3: version: begun by 0.0.1, this is ");
    Files.writeString(origin, text);
    Files.writeString(folder.resolve("out/inputs/obstacles/1/small.csv"), Specs.TABLE + "\n");
    checkRefused(batch(spec, "out"), 2, "batch.json:4: sha256: spec or inputs were changed");
    checkRefused(batch(spec, "."), 2, "exists already");
  }

  @Test
  void rowsOfAnotherBatch_areRefused() throws IOException {
    assertEquals(0, batch(spec, "out").status());
    Path results = folder.resolve("out/results.csv");
    String text = Files.readString(results);
    Files.writeString(results, text.replace("\n5,", "\n6,"));
    checkRefused(batch(spec, "out"), 2, "results.csv:7: run: found '6', expected the row of run 5");
    Files.writeString(results, text.replaceFirst("\n3,,", "\n3,"));
    checkRefused(batch(spec, "out"), 2, "results.csv:5: run: found '3', expected 31 fields");
    Files.writeString(results, text + "24,,\n");
    checkRefused(batch(spec, "out"), 2, "results.csv:26: run: found '24', expected no more rows");
    Files.writeString(results, "a,b\n");
    checkRefused(batch(spec, "out"), 2, "results.csv:1: run: found 'a', expected the columns");
  }

  @Test
  void badInput_leavesNothing() throws IOException {
    checkRefused(batch(spec, "out", "--jobs", "0"), 2, "--jobs: 0 is not at least 1");
    checkRefused(
        batch(spec, "out", "--jobs", "1", "--spark", "local[1]"), 2, "--jobs=N, --spark=MASTER");
    checkRefused(batch(folder.resolve("gone.json"), "out"), 2, "gone.json: no such file");
    Files.writeString(folder.resolve("small.csv"), Specs.TABLE + "a,b\n");
    checkRefused(batch(spec, "out"), 2, "small.csv:10: threshold_m: 'b' is not a distance");
    assertFalse(Files.exists(folder.resolve("out")));
  }

  @Test
  void outThatCannotBe_isSaidInOneLine() throws IOException {
    Files.writeString(folder.resolve("file"), "");
    Shell shell = batch(spec, "file/out");
    assertTrue(shell.status() > 0);
    assertEquals(1, shell.complaints().size(), shell.err());
  }

  @Test
  void spark_isNotAmongTheseJars() {
    checkRefused(batch(spec, "out", "--spark", "local[1]"), 2, "./simbad adds it");
  }
}
