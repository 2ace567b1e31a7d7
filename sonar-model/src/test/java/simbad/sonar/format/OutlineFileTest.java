package simbad.sonar.format;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.sonar.shape.Outline;

class OutlineFileTest {
  private static OutlineDocument parse(String rows) throws DataFormatException {
    return OutlineFile.parse(Path.of("post.csv"), rows.replace("/", "\n") + "\n");
  }

  private static Outline only(String rows) throws DataFormatException {
    return parse(rows).parts().get(0);
  }

  /**
   * x to the right, z down the page: from right-front to right-back and on is counter-clockwise.
   */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "x_m,z_m/1,1/1,-1/-1,-1/-1,1",
        "x_m,z_m/-1,1/-1,-1/1,-1/1,1",
        "x_m,z_m/1,1/1,-1/-1,-1/-1,1/1,1",
        "z_cm,x_cm/100,100/-100,100/-100,-100/100,-100"
      })
  void eitherSense_becomesCounterClockwise(String rows) throws DataFormatException {
    Outline square = only(rows);
    assertEquals(4, square.size());
    assertEquals(4, square.signedAreaM2(), 1e-12);
  }

  @Test
  void units_areTurnedIntoMetres() throws DataFormatException {
    assertEquals(0.0127, only("x_mm,z_mm/12.7,0/0,12.7/0,0").reachM(0, 0), 1e-12);
  }

  @Test
  void parts_areTheBodies_headerIsKept() throws DataFormatException {
    OutlineDocument legs =
        parse("# object: two legs/part,x_m,z_m/a,0,0/a,0.1,0/a,0,0.1/b,0.5,0/b,0.6,0/b,0.5,0.1");
    assertEquals(2, legs.parts().size());
    assertEquals("two legs", legs.header("object").orElseThrow());
    assertEquals(0.6, legs.reachM(), 1e-12);
  }

  /** A scan with a point to every micrometre: said at once, not after minutes of comparing. */
  @Test
  void tooManyCorners_areRefused() {
    String rows = "x_m,z_m" + "/0,0/0,1".repeat(2501);
    DataFormatException fault = assertThrows(DataFormatException.class, () -> parse(rows));
    assertEquals("post.csv: 5002 rows, expected at most 5000 corners", fault.getMessage());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "x_m,z_m | no rows",
        "x_m,z_m/0,0/0,1 | post.csv:2: corners: 2 different corners, expected at least 3",
        "x_m,z_m/0,0/0,0/0,1/0,0 | 2 different corners",
        "x_m,z_m/0,0/1,1/1,0/0,1 | crosses or touches itself: its edges from corner 1 and from corner 3",
        "x_m,z_m/0,0/1,0/1,1/0.5,0 | crosses or touches itself",
        "x_m,z_m/0,0/1,0/0.5,0 | all corners lie on one line",
        "x_mm,z_mm/0,0/5000,0/0,1 | post.csv:3: x_mm: '5000' is not a length within 1.0 m of the axis",
        "x,z/0,0/1,0/0,1 | x_m: column is missing",
        "x_mm,z_m/0,0/1,0/0,1 | z_mm: column is missing",
        "part,x_m,z_m/a,0,0/a,1,0/a,0,1/b,0.1,0.1/b,0.2,0.1/b,0.1,0.2 | post.csv:5: part: 'b' overlaps another part",
      })
  void badOutlines_areNamed(String rows, String complaint) {
    DataFormatException fault = assertThrows(DataFormatException.class, () -> parse(rows.strip()));
    assertTrue(String.valueOf(fault.getMessage()).contains(complaint), fault.getMessage());
  }
}
