package simbad.experiments.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.shape.ThresholdTable;

class PositionLogTest {
  /** Kranz (2014), figure 4.16. */
  private static final String THESIS =
      """
      Jan 06, 2013 7:19:54 PM examples.AngleRobot$MyRobot performBehavior
      INFO: 0.0,-2.5
      Jan 06, 2013 7:19:54 PM examples.AngleRobot$MyRobot performBehavior
      INFO: 0.025000000372529037,-2.5
      Jan 06, 2013 7:19:54 PM examples.AngleRobot$MyRobot performBehavior
      INFO: 0.04999929762332253,-2.4998125017522197
      Jan 06, 2013 7:19:54 PM examples.AngleRobot$MyRobot performBehavior
      INFO: 0.07499648554845981,-2.4994375158033866
      """;

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  private PositionLog read(String text) throws IOException, DataFormatException {
    return PositionLog.read(Files.writeString(folder.resolve("robot.log"), text));
  }

  @Test
  void thesisLog_isRead() throws Exception {
    PositionLog log = read(THESIS);
    assertEquals(4, log.trace().size());
    assertEquals(4, log.otherLines());
    assertEquals(0.07499648554845981, log.trace().xM(3));
    assertEquals(-2.4994375158033866, log.trace().zM(3));
    assertEquals(0, log.trace().firstOnEdge());
  }

  /** A circle of 2.5 m against a table of 2 m: half a metre off everywhere. */
  @Test
  void circle_hasTheErrorOfItsRadius() throws Exception {
    StringBuilder text = new StringBuilder("start\n");
    for (int i = 0; i <= 7210; i++) {
      double angle = Math.toRadians(i / 20.0);
      text.append("INFO: ").append(2.5 * Math.sin(angle)).append(',');
      text.append(2.5 * Math.cos(angle)).append("\r\n");
    }
    PositionLog log = read(text.toString());
    TraceErrors errors = log.errors(ThresholdTable.uniform(72, 2));
    assertEquals(1, log.otherLines());
    assertEquals(0.5, errors.meanM().orElseThrow(), 1e-6);
    assertEquals(0.5, errors.maxM().orElseThrow(), 1e-6);
    assertEquals(0, errors.unreachedBearings());
  }

  @ParameterizedTest
  @CsvSource({
    "'FINE: 1,2', 1",
    "'INFORMATION: 1e0 , -2.5E-1', 1",
    "' WARNING:1.,2', 1",
    "'INFO: at 1,2', 0",
    "'INFO: 1,2,3', 0",
    "'INFO: 1;2', 0",
    "'Jan 06, 2013', 0",
    "'info: 1,2', 0",
    "'', 0"
  })
  void lines_arePositionsOrOtherText(String line, int positions) throws Exception {
    PositionLog log = read("INFO: 0,1\nINFO: 0,2\n" + line + "\n");
    assertEquals(2 + positions, log.trace().size());
    assertEquals(1 - positions, log.otherLines());
  }

  @ParameterizedTest
  @CsvSource({
    "'INFO: NaN,1', ':3: x: found NaN'",
    "'INFO: 1,Infinity', ':3: z: found Infinity'",
    "'INFO: 1,-Infinity', ':3: z: found -Infinity'",
    "'INFO: 1e9,1', ':3: x: found 1e9'",
    "'INFO: 1e999,1', ':3: x: found 1e999'"
  })
  void impossiblePositions_areRefused(String line, String names) {
    checkRefused("INFO: 0,1\nINFO: 0,2\n" + line + "\n", names);
  }

  @ParameterizedTest
  @CsvSource({
    "''",
    "'no position at all'",
    "'INFO: 0,1'",
    "'<record><message>0,1</message></record>'"
  })
  void logsWithoutAWay_areRefused(String text) {
    checkRefused(text, "expected at least 2 such as INFO: 0.025,-2.5");
  }

  private void checkRefused(String text, String names) {
    String message =
        String.valueOf(assertThrows(DataFormatException.class, () -> read(text)).getMessage());
    assertTrue(message.startsWith(folder.resolve("robot.log").toString()), message);
    assertTrue(message.contains(names), message);
  }

  @Test
  void missingLog_isRefused() {
    assertThrows(DataFormatException.class, () -> PositionLog.read(folder.resolve("none.log")));
  }
}
