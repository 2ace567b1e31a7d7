package simbad.bench.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Clock;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import simbad.bench.capture.Approach;
import simbad.bench.capture.Entry;
import simbad.bench.capture.Journal;
import simbad.bench.capture.JournalEntries;
import simbad.bench.capture.Recorder;
import simbad.bench.capture.SweepState;
import simbad.bench.capture.TriedDistance;
import simbad.bench.link.MemoryLink;
import simbad.bench.protocol.FirmwareMode;
import simbad.bench.protocol.FrameLine;
import simbad.bench.protocol.PingStatus;

/** Many pings through all of it: link, ranger, recorder, journal. */
@Timeout(3600)
class EnduranceTest {
  private static final SteadyRanger.Terms TERMS =
      new SteadyRanger.Terms(
          Duration.ofSeconds(3),
          Duration.ofSeconds(20),
          Duration.ofSeconds(20),
          Duration.ZERO,
          FirmwareMode.FRAME);

  /** One ping every 68 ms for 24 hours. */
  private static final int DAY = 24 * 3600 * 1000 / 68;

  @TempDir Path folder = Path.of("");

  private Recorder recorder(Path where) throws IOException {
    Journal journal =
        Journal.create(
            where.resolve("journal.txt"), new Entry.Begun(Map.of("format", "bench-journal/1")));
    return new Recorder(journal, new SweepState(), Clock.systemUTC(), OptionalDouble.of(20));
  }

  private static TriedDistance probe(int ping) {
    return new TriedDistance(0.02 * (1 + ping / 10 % 150), Approach.OUT);
  }

  /** As fast as link and disk go, each on the disk before the next is asked for. */
  private void checkPings(int count) throws Exception {
    MemoryLink.Pair line = MemoryLink.pair();
    long begunNs = System.nanoTime();
    try (FakeRanger fake = new FakeRanger(line.there(), Map.of());
        SteadyRanger ranger = new SteadyRanger(line::here, TERMS, text -> {});
        Recorder recorder = recorder(folder)) {
      for (int i = 0; i < count; i++) {
        recorder.record(i / 1500 % 72, probe(i), ranger.ping());
      }
      recorder.sync();
      assertEquals(count, recorder.state().pings(), "on the disk");
      fake.mute(true);
    }
    double perS = count / ((System.nanoTime() - begunNs) / 1e9);
    System.out.printf("%d pings recorded, %.0f in a second%n", count, perS);
    List<Entry> entries = JournalEntries.of(folder.resolve("journal.txt"));
    assertEquals(1 + count, entries.size());
    int last = -1;
    for (Entry entry : entries.subList(1, 1 + count)) {
      Entry.Taken taken = (Entry.Taken) entry;
      assertEquals(last < 0 ? taken.sequence() : (last + 1) % 65536, taken.sequence());
      assertEquals(1000 + taken.sequence() % 20_000, taken.echoUs().orElseThrow());
      last = taken.sequence();
    }
  }

  @Test
  void thousandPings_areAllRecordedInTheirOrder() throws Exception {
    checkPings(1000);
  }

  @Test
  @Tag("full")
  void hundredThousandPings_areAllRecordedInTheirOrder() throws Exception {
    checkPings(100_000);
  }

  private static long usedBytes() throws InterruptedException {
    for (int i = 0; i < 3; i++) {
      System.gc();
      Thread.sleep(50);
    }
    return Runtime.getRuntime().totalMemory() - Runtime.getRuntime().freeMemory();
  }

  /** On a disk in memory: what is looked at is the program's own memory, not the disk's pace. */
  @Test
  @Tag("full")
  void dayLongCapture_doesNotGrow() throws Exception {
    Path memory = Path.of("/dev/shm");
    Path where = Files.createTempDirectory(Files.isDirectory(memory) ? memory : folder, "day");
    try (Recorder recorder = recorder(where)) {
      long early = 0;
      for (int i = 0; i < DAY; i++) {
        FrameLine.Ping ping =
            new FrameLine.Ping(i % 65536, PingStatus.ECHO, OptionalInt.of(1000 + i % 20_000), 68);
        recorder.record(i / (DAY / 72 + 1), probe(i % 1500), ping);
        if (i == DAY / 10) {
          early = usedBytes();
        }
      }
      long grown = usedBytes() - early;
      System.out.printf("a day of %d pings, grown by %d bytes%n", DAY, grown);
      assertTrue(grown < 5_000_000, "grown by " + grown + " bytes");
    } finally {
      Files.delete(where.resolve("journal.txt"));
      Files.delete(where);
    }
  }
}
