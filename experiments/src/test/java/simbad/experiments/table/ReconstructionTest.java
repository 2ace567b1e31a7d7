package simbad.experiments.table;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simbad.obstacles.Catalogue;
import simbad.sonar.format.Provenance;
import simbad.sonar.format.TableDocument;
import simbad.sonar.format.TableFile;
import simbad.sonar.shape.ThresholdTable;

class ReconstructionTest {
  private static final Path TABLES = Path.of("..", "data", "threshold-plots");
  private static final TableDocument SQUARE = Reconstruction.square(Catalogue.angleTable().table());

  private static void checkCommitted(String file, TableDocument computed) throws IOException {
    assertEquals(Files.readString(TABLES.resolve(file)), TableFile.text(computed));
    assertEquals(Optional.of(Provenance.RECONSTRUCTED), computed.provenance());
  }

  @Test
  void committedTables_areWhatIsComputed() throws IOException {
    checkCommitted("square-25mm.csv", SQUARE);
    checkCommitted("round-25mm.csv", Reconstruction.round());
  }

  /** Thesis, 4.1.3: a circle of about 2 m. */
  @Test
  void round_isACircleOfTwoMetres() {
    assertEquals(ThresholdTable.uniform(72, 2), Reconstruction.round().table());
  }

  /** Thesis, 4.1.2: about 2.5 m over each flat side, falling to about 0.2 m towards the corners. */
  @Test
  void square_hasFlatSidesAndCorners() {
    ThresholdTable table = SQUARE.table();
    for (int side = 0; side < 4; side++) {
      assertEquals(2.5, table.valueM(18 * side), "flat side");
      assertEquals(0.2, table.valueM(18 * side + 9), "corner");
    }
    assertEquals(2.5, table.greatestM());
  }

  /** A square looks the same turned by a quarter, and in a mirror. */
  @Test
  void square_hasTheSquaresSymmetry() {
    ThresholdTable table = SQUARE.table();
    for (int i = 0; i < 72; i++) {
      assertEquals(table.valueM(i), table.valueM((i + 18) % 72), "turned, row " + i);
      assertEquals(table.valueM(i), table.valueM((72 - i) % 72), "mirrored, row " + i);
    }
  }

  /** The measured table has steps of 2 cm; so has what is made of it. */
  @Test
  void square_isInSteps() {
    for (double value : SQUARE.table().valuesM()) {
      assertEquals(Math.rint(value * 50), value * 50, 1e-9);
      assertTrue(value >= 0.2);
    }
  }

  /**
   * An angle whose outer faces had 2 m at the normal and 0.5 m at 5 degrees to either side would
   * make a square of 2.5 and 2.5 / 2 * 0.5 = 0.625, in steps 0.62.
   */
  @Test
  void square_isScaledFromTheFaces() {
    double[] angle = new double[72];
    Arrays.fill(angle, 0.1);
    for (int face : new int[] {18, 36}) {
      angle[face] = 2;
      angle[face - 1] = 0.5;
      angle[face + 1] = 0.5;
    }
    ThresholdTable square = Reconstruction.square(ThresholdTable.of(angle)).table();
    assertEquals(2.5, square.valueM(0));
    assertEquals(0.62, square.valueM(1), 0.0101);
    // 2.5 / 2 * 0.1 = 0.125 is below the least of 0.2.
    assertEquals(0.2, square.valueM(2));
  }

  @Test
  void square_ofAnotherSweep_isRefused() {
    ThresholdTable coarse = ThresholdTable.uniform(36, 1);
    assertThrows(IllegalArgumentException.class, () -> Reconstruction.square(coarse));
  }
}
