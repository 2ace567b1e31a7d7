package simbad.sonar.ping;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import simbad.sonar.fixture.Untimed;
import simbad.sonar.frame.Pose;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.ReadingRow;

class PingLogTest {
  /** Each ping as the log has it: sums over pings are then the same to the last bit. */
  private static List<String> pings(List<ReadingRow> rows) {
    PingLog log = new PingLog(rows);
    return IntStream.range(0, log.size())
        .mapToObj(
            i ->
                String.join(
                    " ",
                    log.runs().get(log.run(i)),
                    log.sensors().get(log.sensor(i)),
                    log.timeS(i) + " " + log.zM(i) + " " + log.rangeM(i)))
        .toList();
  }

  private static void assertOrderOfRowsIsNothing(List<ReadingRow> rows) {
    List<String> inOrder = pings(rows);
    for (int seed = 0; seed < 10; seed++) {
      List<ReadingRow> shuffled = new ArrayList<>(rows);
      Collections.shuffle(shuffled, new Random(seed));
      assertEquals(inOrder, pings(shuffled));
    }
  }

  @Test
  void orderOfRows_isNothing_whereTimesSayIt() {
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < 60; i++) {
      String run = i % 2 == 0 ? "out" : "back";
      rows.add(new ReadingRow(run, "s" + i % 3, 0.1 * i, Pose.of(0, 1, 0), new Echo(0.01 * i)));
    }
    assertOrderOfRowsIsNothing(rows);
  }

  @Test
  void orderOfRows_isNothing_withoutTimes() {
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < 60; i++) {
      Pose pose = Pose.of(0, 1 + i % 4, 0);
      rows.add(new ReadingRow("r", "s", 0, pose, new Echo(0.01 * i), Untimed.ROW));
    }
    assertOrderOfRowsIsNothing(rows);
  }
}
