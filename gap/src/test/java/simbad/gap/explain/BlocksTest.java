package simbad.gap.explain;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.sonar.effect.PingLog;
import simbad.sonar.frame.Pose;
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
}
