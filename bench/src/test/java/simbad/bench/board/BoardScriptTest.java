package simbad.bench.board;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.SensorFile;
import simbad.sonar.frame.Point;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.shape.Outline;
import simbad.sonar.shape.ThresholdTable;

class BoardScriptTest {
  static final SonarSpec SPEC = spec();

  /** A square post of 2 cm that is heard up to 2 m all round, save at bearing 90 degrees: 1 m. */
  static final BenchTarget POST =
      new BenchTarget(
          Outline.of(
              List.of(
                  new Point(0.01, 0.01),
                  new Point(0.01, -0.01),
                  new Point(-0.01, -0.01),
                  new Point(-0.01, 0.01))),
          ThresholdTable.of(2, 1, 2, 2));

  private static final String HEADER =
      "time_s,obstacle,distance_m,offset_m,clockwise_deg,temperature_c,event\n";

  private static SonarSpec spec() {
    try {
      return SensorFile.read(Path.of("..", "data", "sensors", "srf04.json"));
    } catch (DataFormatException e) {
      throw new IllegalStateException(e);
    }
  }

  static BoardScript parse(String rows) throws DataFormatException {
    return BoardScript.parse(
        Path.of("s.csv"),
        HEADER + rows,
        name -> {
          if (name.equals("post")) {
            return POST;
          }
          throw DataFormatException.inArgument("OBSTACLE '" + name + "'", "is none");
        });
  }

  @Test
  void read_theScriptOfTheGuide() throws Exception {
    BoardScript script =
        BoardScript.read(Path.of("..", "docs", "guide", "board-session.csv"), name -> POST);
    assertEquals(0, script.rows().get(0).timeS());
    assertTrue(script.rows().size() >= 5);
  }

  @Test
  void parse_rowsInOrder() throws Exception {
    BoardScript script =
        parse("0,none,0,0,0,20,none\n# a remark\n1.5,post,1.2,-0.1,90,-10,stuck-high\n");
    BoardScript.Row row = script.rows().get(1);
    assertEquals(2, script.rows().size());
    assertTrue(script.rows().get(0).bench().target().isEmpty());
    assertEquals(1.5, row.timeS());
    assertEquals(-10, row.temperatureC());
    assertEquals(BoardEvent.STUCK_HIGH, row.event());
    assertEquals(Math.PI / 2, row.bench().clockwiseRad(), 1e-12);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "1,post,1,0,0,20,none | s.csv:2: time_s: 1.0 is out of order",
        "0,post,1,0,0,20,none;0,post,1,0,0,20,none | s.csv:3: time_s: 0.0 is out of order",
        "0,pots,1,0,0,20,none | s.csv:2: obstacle: OBSTACLE 'pots': is none",
        "0,post,-1,0,0,20,none | s.csv:2: distance_m: '-1' is not a distance in [0, 100] m",
        "0,post,1,x,0,20,none | s.csv:2: offset_m: 'x' is not a finite number",
        "0,post,1,0,NaN,20,none | s.csv:2: clockwise_deg: 'NaN' is not a finite number",
        "0,post,1,0,0,200,none | s.csv:2: temperature_c: '200' is not a temperature",
        "0,post,1,0,0,20,fire | s.csv:2: event: 'fire' is none of these: none, no-echo,",
        "0,post,1,0,0,20 | s.csv:2: event: 6 fields in the row, expected 7",
        "'' | s.csv: has no rows"
      })
  void parse_badInput_namesLineAndField(String rows, String message) {
    DataFormatException fault =
        assertThrows(DataFormatException.class, () -> parse(rows.replace(';', '\n')));
    assertTrue(String.valueOf(fault.getMessage()).startsWith(message), fault.getMessage());
  }

  @Test
  void rows_outOfOrder_areRefused() {
    BoardScript.Row row =
        new BoardScript.Row(0, new BenchScene(Optional.empty(), 0, 0, 0), 20, BoardEvent.NONE);
    assertThrows(IllegalArgumentException.class, () -> new BoardScript(List.of()));
    assertThrows(IllegalArgumentException.class, () -> new BoardScript(List.of(row, row)));
  }
}
