package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * All that writes files, on a disk that is full: a file system of its own that other bytes fill.
 * Nothing may be left under a final name, and one line names what could not be written.
 */
@Timeout(600)
class FullDiskTest {
  /** Command lines, and the file in their complaint. */
  private static final List<String> LINES =
      List.of(
          "table plot angle --out disk/a.svg > disk/a.svg",
          "table plot angle --out disk/a.png > disk/a.png",
          "table compare angle round --out disk/a.svg > disk/a.svg",
          "table predict round --bearings 3 --out disk/a.csv > disk/a.csv",
          "table reconstruct round --out disk/a.csv > disk/a.csv",
          "table import PROJECT/data/obstacles/tee/table.csv --out disk/a.csv > disk/a.csv",
          "sensor plot PROJECT/data/sensors/srf04.json --out disk/a.svg > disk/a.svg",
          "dataset grid round --out disk/set > disk/set/scene.json",
          "dataset ladder PROJECT/data/logs/hcsr04-ladders/ladders.csv --set hankb"
              + " --sound-speed 335.28 --out disk/set > disk/set/scene.json",
          "predict set set/readings.csv --model nominal --out disk/p.csv > disk/p.csv",
          "diagnose set --out disk/d > disk/d/set/scene.json",
          "run round --sensor original --speed 0.1 --out disk/run > disk/run/round/table.csv",
          "fidelity round --sensor original --out disk/f > disk/f/round/table.csv",
          "docs --out disk/site > disk/site/",
          "batch PROJECT/data/batch/edge-follower-tuning.json --out disk/b > disk/b/spec.json",
          "blind-check --cases 2 --rows 100-200 --out disk/c > disk/c/order.json",
          "bench table capture --out disk/t.csv > disk/t.csv",
          "bench table capture --out disk/t.csv --plot disk/t.svg > disk/t.svg",
          "bench table disk/capture --out t.csv > disk/capture/readings.csv",
          "bench measure set/readings.csv --out disk/r.csv --port none > disk/r.csv");

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  /** Runs the lines in its folder; each leaves its status, its complaint and the disk's files. */
  static final class Inside {
    private Inside() {}

    public static void main(String... lines) throws IOException {
      for (int i = 0; i < lines.length; i++) {
        Shell shell = Shell.simbad(lines[i].split(" "));
        Files.writeString(Path.of("left-" + i), String.join("\n", files(Path.of("disk"))));
        Files.writeString(Path.of("said-" + i), shell.status() + "\n" + shell.err());
      }
      System.exit(0);
    }
  }

  private static List<String> files(Path folder) throws IOException {
    try (Stream<Path> entries = Files.walk(folder)) {
      return entries.filter(Files::isRegularFile).map(Path::toString).sorted().toList();
    }
  }

  private void runInside() throws Exception {
    ReadOnly.assumeMounts();
    List<String> inside = new ArrayList<>(SimbadProcess.command());
    inside.set(inside.size() - 1, Inside.class.getName());
    String project = Path.of("..").toRealPath().toString();
    LINES.forEach(line -> inside.add(line.split(" > ", 2)[0].replace("PROJECT", project)));
    List<String> command =
        new ArrayList<>(
            List.of(
                "unshare",
                "-m",
                "sh",
                "-c",
                "mount -t tmpfs -o size=8m none disk && "
                    + "cp -r capture disk && "
                    + "{ cat /dev/zero >disk/filler 2>/dev/null; "
                    + "exec \"$@\"; }",
                "sh"));
    command.addAll(inside);
    ProcessBuilder process = new ProcessBuilder(command).directory(folder.toFile()).inheritIO();
    assertEquals(0, process.start().waitFor());
  }

  @TestFactory
  Stream<DynamicTest> fullDisk_isSaidAndLeavesNothingTorn() throws Exception {
    Files.createDirectory(folder.resolve("disk"));
    BenchData.write(folder.resolve("set"), BenchData.rows(60, 0));
    LongJournalTest.capture(folder.resolve("capture"), 2);
    runInside();
    List<DynamicTest> tests = new ArrayList<>();
    for (int i = 0; i < LINES.size(); i++) {
      String[] line = LINES.get(i).split(" > ", 2);
      List<String> said = Files.readAllLines(folder.resolve("said-" + i));
      List<String> left = Files.readAllLines(folder.resolve("left-" + i));
      tests.add(DynamicTest.dynamicTest(line[0], () -> check(line[1], said, left)));
    }
    return tests.stream();
  }

  private static void check(String file, List<String> said, List<String> left) {
    assertEquals(2, said.size(), said.toString());
    assertEquals("1", said.get(0), said.toString());
    assertTrue(
        said.get(1).matches(".*[ /]\\Q" + file + "\\E.*: No space left on device"), said.get(1));
    assertEquals(List.of("disk/capture/journal.txt", "disk/filler"), left);
  }
}
