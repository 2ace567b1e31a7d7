package simbad.bench.capture;

import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simbad.bench.protocol.PingStatus;
import simbad.sonar.format.DataFormatException;

/**
 * Journals with junk in some fields and checksums that fit: each comes to a table or is refused by
 * a {@link DataFormatException} that names the file, in finite time. The seeds are fixed.
 */
class JournalFuzzTest {
  private static final int FILES = 1500;
  private static final int BEARINGS = 3;

  private static final String[] JUNK = {
    "",
    " ",
    "NaN",
    "Infinity",
    "-1",
    "0",
    "-0.0",
    "1e5",
    "1e300",
    "1e-320",
    "99999999999",
    "0x10",
    "1d",
    "100",
    "65535",
    "99999",
    "-273",
    "80",
    "echo",
    "stuck",
    "too-near",
    "in",
    "search",
    "x=y",
    "=",
    "9".repeat(400),
    "\u00e4",
    "\r",
    "\u0000",
    "\u2028",
    "obstacle=",
    "bearings=3600",
    "pings=10000",
    "misses=1",
    "step_m=1",
    "near_m=99",
    "far_m=100",
    "temperature_c=80",
    "mode=thesis"
  };

  @TempDir private Path folder = Path.of("");

  /** A capture of three bearings, done. */
  private static List<Entry> capture() {
    SweepPlan plan = SweepPlan.ofBearings(BEARINGS).with(2, 1, 0.02);
    List<Entry> entries = new ArrayList<>();
    entries.add(
        new CaptureSettings(plan, OptionalDouble.of(20), Map.of("obstacle", "angle")).entry());
    for (int bearing = 0; bearing < BEARINGS; bearing++) {
      for (int i = 0; i < 8; i++) {
        int level = i / 2;
        PingStatus status = i < 4 ? PingStatus.ECHO : PingStatus.NO_ECHO;
        entries.add(
            new Entry.Taken(
                1e9 + i,
                bearing,
                new TriedDistance(1 + 0.02 * level, Approach.OUT),
                i,
                status,
                OptionalInt.of(5800),
                OptionalDouble.of(20)));
      }
      entries.add(new Entry.Done(bearing));
    }
    return entries;
  }

  private static String damaged(Random random) {
    StringBuilder text = new StringBuilder();
    List<Entry> entries = capture();
    int first = random.nextInt(entries.size());
    int second = random.nextInt(3) == 0 ? random.nextInt(entries.size()) : first;
    for (int i = 0; i < entries.size(); i++) {
      JournalLine line = entries.get(i).line(i + 1);
      boolean isHit = i == first || i == second;
      text.append((isHit ? damaged(line, random) : line).text());
    }
    return text.toString();
  }

  private static JournalLine damaged(JournalLine line, Random random) {
    List<String> fields = new ArrayList<>(line.fields());
    int at = random.nextInt(fields.size());
    switch (random.nextInt(8)) {
      case 0 -> fields.remove(at);
      case 1 -> fields.add(at, JUNK[random.nextInt(JUNK.length)]);
      default -> fields.set(at, JUNK[random.nextInt(JUNK.length)]);
    }
    String kind = random.nextInt(20) == 0 ? "repeated" : line.kind();
    return new JournalLine(line.number(), kind, fields);
  }

  /** As {@code simbad bench table} reads it. */
  private static void read(Path journal) throws DataFormatException {
    CapturedReadings readings = CapturedReadings.of(journal);
    CapturedTable.of(readings.text(), readings.state()).text();
    readings.forEach(row -> {});
  }

  private void checkAll() throws IOException {
    int refused = 0;
    for (int seed = 0; seed < FILES; seed++) {
      String text = damaged(new Random(seed));
      Path file = Files.writeString(folder.resolve(seed + ".txt"), text);
      try {
        read(file);
      } catch (DataFormatException e) {
        String message = String.valueOf(e.getMessage());
        assertTrue(message.startsWith(file + ":") && message.lines().count() == 1, message);
        refused++;
      } catch (RuntimeException e) {
        throw new AssertionError("seed " + seed + " throws " + e + " on:\n" + text, e);
      }
      Files.delete(file);
    }
    assertTrue(refused > FILES / 4 && refused < FILES, refused + " of " + FILES + " refused");
  }

  @Test
  void wellSummedUpJunk_isReadOrRefused() {
    assertTimeoutPreemptively(Duration.ofMinutes(2), this::checkAll);
  }
}
