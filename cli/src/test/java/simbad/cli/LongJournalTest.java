package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import simbad.bench.capture.Approach;
import simbad.bench.capture.CaptureSettings;
import simbad.bench.capture.Entry;
import simbad.bench.capture.Journal;
import simbad.bench.capture.SweepPlan;
import simbad.bench.capture.TriedDistance;
import simbad.bench.protocol.PingStatus;
import simbad.experiments.bench.CaptureFolder;
import simbad.obstacles.Catalogue;
import simbad.sonar.format.TableFile;
import simbad.sonar.shape.ThresholdTable;

/** Captures of so many readings that a program which held them all would need more memory. */
@Timeout(1800)
class LongJournalTest {
  private static final int BEARINGS = 72;
  private static final int DISTANCES = 20;
  private static final double STEP_M = 0.02;

  @TempDir Path folder = Path.of("");

  /** A capture of the angle that is done: ten distances out and in again round each threshold. */
  static CaptureFolder capture(Path where, int pings) throws IOException {
    CaptureFolder capture = new CaptureFolder(where);
    SweepPlan plan = SweepPlan.ofBearings(BEARINGS).with(pings, pings / 2, STEP_M);
    CaptureSettings settings =
        new CaptureSettings(plan, OptionalDouble.of(20), Map.of("obstacle", "angle", "seed", "1"));
    try (Journal journal = capture.begin(settings)) {
      for (int bearing = 0; bearing < BEARINGS; bearing++) {
        for (int i = 0; i < DISTANCES; i++) {
          journal.append(place(bearing, i, pings));
        }
        journal.append(List.of(new Entry.Done(bearing)));
      }
    }
    return capture;
  }

  private static List<Entry> place(int bearing, int index, int pings) {
    ThresholdTable table = Catalogue.angleTable().table();
    double thresholdM = table.thresholdM(Math.toRadians(bearing * 360.0 / BEARINGS));
    int steps = index < DISTANCES / 2 ? index - 5 : 14 - index;
    double distanceM = Math.max(STEP_M, Math.rint(50 * thresholdM + steps) / 50);
    boolean heard = distanceM <= thresholdM;
    Approach approach = index < DISTANCES / 2 ? Approach.OUT : Approach.IN;
    List<Entry> entries = new ArrayList<>();
    for (int ping = 0; ping < pings; ping++) {
      int number = (bearing * DISTANCES + index) * pings + ping;
      entries.add(
          new Entry.Taken(
              1.8e9 + number * 0.068,
              bearing,
              new TriedDistance(distanceM, approach),
              number % 65536,
              heard ? PingStatus.ECHO : PingStatus.NO_ECHO,
              OptionalInt.of(heard ? (int) (5800 * distanceM) : 36_000),
              OptionalDouble.of(20)));
    }
    return entries;
  }

  /** The program itself, with so much memory for all that it holds. */
  private static void check(String memory, String... words) throws Exception {
    List<String> command = new ArrayList<>(SimbadProcess.command(words));
    command.add(1, memory);
    Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
    process.getOutputStream().close();
    String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, process.waitFor(), said);
  }

  private void checkAll(int pings, String memory) throws Exception {
    CaptureFolder capture = capture(folder.resolve("long"), pings);
    Path table = folder.resolve("long.csv");
    check(memory, "bench", "table", capture.path().toString(), "--out", table.toString());
    assertEquals(BEARINGS, TableFile.read(table).table().size());
    Path rows = capture.path().resolve("readings.csv");
    checkRows(rows, pings);
    Files.delete(rows);
    check(memory, "bench", "resume", capture.path().toString());
    checkRows(rows, pings);
  }

  private static void checkRows(Path rows, int pings) throws IOException {
    try (Stream<String> lines = Files.lines(rows)) {
      assertEquals(1L + (long) BEARINGS * DISTANCES * pings, lines.count());
    }
  }

  /** 288,000 readings take 40 MB as they stand in the journal and twice that as objects. */
  @Test
  @Tag("full")
  void readings_areNeverAllInMemory() throws Exception {
    checkAll(200, "-Xmx32m");
    assertTrue(Files.size(folder.resolve("long/journal.txt")) > 15_000_000);
  }

  /** As many as a ping every 68 ms gives in a day: 1,270,080. */
  @Test
  @Tag("full")
  void dayOfReadings_isTakenUpInAsLittle() throws Exception {
    checkAll(882, "-Xmx32m");
  }
}
