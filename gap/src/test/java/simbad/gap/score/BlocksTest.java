package simbad.gap.score;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import simbad.sonar.fixture.Untimed;
import simbad.sonar.frame.Pose;
import simbad.sonar.ping.PingLog;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;

class BlocksTest {
  private static void add(List<ReadingRow> rows, String run, String sensor, double timeS) {
    rows.add(new ReadingRow(run, sensor, timeS, Pose.of(1, 0, 0), NoEcho.NO_ECHO));
  }

  private static PingLog log(int rowsOfOne, double startS) {
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < rowsOfOne; i++) {
      int step = i / 2;
      add(rows, "one", i % 2 == 0 ? "left" : "right", startS + 0.1 * step);
    }
    for (int i = 0; i < 30; i++) {
      add(rows, "two", "left", 0.1 * i);
    }
    return new PingLog(rows);
  }

  /** A hundred rows make four pieces of 25, thirty rows one; whenever the run begins. */
  @Test
  void runs_areCutIntoPiecesOfEqualTime_allSensorsTogether() {
    for (double startS : new double[] {0, 1000}) {
      PingLog log = log(100, startS);
      Blocks blocks = new Blocks(log);
      assertEquals(5, blocks.count());
      for (int ping = 0; ping < log.size(); ping++) {
        boolean one = log.runs().get(log.run(ping)).equals("one");
        // The last of 50 times, 4.9 s, ends the last piece.
        int piece = (int) Math.min(3, Math.floor((log.timeS(ping) - startS) / 4.9 * 4 + 1e-9));
        for (int other = 0; one && other < log.size(); other++) {
          boolean isOne = log.runs().get(log.run(other)).equals("one");
          int its = (int) Math.min(3, Math.floor((log.timeS(other) - startS) / 4.9 * 4 + 1e-9));
          assertEquals(isOne && its == piece, blocks.of(other) == blocks.of(ping), "ping " + other);
        }
      }
    }
  }

  @Test
  void run_hasTwelvePiecesAtMost() {
    assertEquals(13, new Blocks(log(2000, 0)).count());
    assertEquals(2, new Blocks(log(49, 0)).count());
  }

  /** Two blocks, and twice the 25 rows of one: of a single run nothing can be held out. */
  @Test
  void fiftyRowsOfTwoBlocks_canBeHeldOut() {
    assertFalse(new Blocks(log(19, 0)).canBeHeldOut());
    assertTrue(new Blocks(log(20, 0)).canBeHeldOut());
    List<ReadingRow> one = new ArrayList<>();
    for (int i = 0; i < 49; i++) {
      add(one, "one", "left", 0.1 * i);
    }
    assertFalse(new Blocks(new PingLog(one)).canBeHeldOut());
    add(one, "one", "left", 4.9);
    assertTrue(new Blocks(new PingLog(one)).canBeHeldOut());
    assertFalse(new Blocks(new PingLog(List.of())).canBeHeldOut());
  }

  @Test
  void parts_areAllOfIt_eachOnce() {
    PingLog log = log(400, 0);
    Blocks blocks = new Blocks(log);
    for (int ping = 0; ping < log.size(); ping++) {
      assertNotEquals(blocks.half(0).holds(ping), blocks.half(1).holds(ping));
      int held = 0;
      for (int part = 0; part < 3; part++) {
        held += blocks.part(part, 3).holds(ping) ? 1 : 0;
      }
      assertEquals(1, held);
    }
  }

  /** Ten places of ten rows each, without times: what is at one place is in one block. */
  @Test
  void placesWithoutTimes_stayTogether_whateverTheOrder() {
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < 100; i++) {
      int place = i / 10;
      Pose pose = Pose.of(0, 1 + place, 1);
      rows.add(new ReadingRow("r", "s", 0, pose, NoEcho.NO_ECHO, Untimed.ROW));
    }
    PingLog inOrder = new PingLog(rows);
    Collections.shuffle(rows, new Random(1));
    PingLog shuffled = new PingLog(rows);
    Map<Double, Set<Integer>> blocks = blocksOfPlaces(inOrder);
    assertEquals(10, new Blocks(inOrder).count());
    assertEquals(partition(blocks), partition(blocksOfPlaces(shuffled)));
    blocks.values().forEach(block -> assertEquals(1, block.size()));
  }

  private static Map<Double, Set<Integer>> blocksOfPlaces(PingLog log) {
    Blocks blocks = new Blocks(log);
    Map<Double, Set<Integer>> places = new TreeMap<>();
    for (int ping = 0; ping < log.size(); ping++) {
      assertEquals(ping, log.sequenceStart(ping), "it follows none");
      places.computeIfAbsent(log.zM(ping), z -> new HashSet<>()).add(blocks.of(ping));
    }
    return places;
  }

  /** Which places share their blocks. */
  private static Set<Set<Double>> partition(Map<Double, Set<Integer>> places) {
    Map<Set<Integer>, Set<Double>> together = new HashMap<>();
    places.forEach(
        (place, block) -> together.computeIfAbsent(block, b -> new HashSet<>()).add(place));
    return new HashSet<>(together.values());
  }
}
