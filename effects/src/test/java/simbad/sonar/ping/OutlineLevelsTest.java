package simbad.sonar.ping;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.sonar.frame.Point;
import simbad.sonar.shape.Outline;

class OutlineLevelsTest {
  private static final double WAVENUMBER_PER_M = 2 * Math.PI * 40_000 / 343;
  private static final double WAVE_M = 343.0 / 40_000;

  private static OutlineLevels levels(List<Point> corners) {
    return new OutlineLevels(Outline.of(corners), WAVENUMBER_PER_M);
  }

  private static List<Point> board(double wideM, double thickM) {
    double x = wideM / 2;
    double z = thickM / 2;
    return List.of(new Point(-x, -z), new Point(-x, z), new Point(x, z), new Point(x, -z));
  }

  private static List<Point> round(double radiusM) {
    List<Point> corners = new ArrayList<>();
    for (int i = 0; i < 144; i++) {
      double angle = Math.toRadians(2.5 * i);
      corners.add(new Point(radiusM * Math.sin(angle), radiusM * Math.cos(angle)));
    }
    return corners;
  }

  /** Half a Fresnel zone answers: the root of wave times radius over 2 (Bowman 1969, ch. 2). */
  @ParameterizedTest
  @ValueSource(doubles = {0.02, 0.03, 0.05})
  void roundPost_answersAsItsRadiusSays(double radiusM) {
    OutlineLevels post = levels(round(radiusM));
    for (double degrees : new double[] {0, 17, 100, 359}) {
      assertEquals(
          10 * Math.log10(WAVE_M * radiusM / 2),
          post.levelDb(Math.toRadians(degrees), 4.53),
          0.7,
          degrees + " degrees");
    }
  }

  /** A flat side far away answers with all its width. */
  @ParameterizedTest
  @CsvSource({"0, 0.05", "90, 0.03", "180, 0.05", "270, 0.03"})
  void flatSide_answersWithItsWidth(double degrees, double wideM) {
    double level = levels(board(0.05, 0.03)).levelDb(Math.toRadians(degrees), 4.53);
    assertEquals(20 * Math.log10(wideM), level, 0.3);
  }

  /** Where the sides' echoes cancel an edge is left. */
  @Test
  void corner_isMuchWeakerThanASide_butAnswers() {
    OutlineLevels square = levels(board(0.05, 0.05));
    double side = square.levelDb(0, 2);
    double corner = square.levelDb(Math.toRadians(45), 2);
    assertTrue(corner < side - 25, () -> "corner " + corner + " dB");
    assertTrue(corner > 20 * Math.log10(WAVE_M / (4 * Math.PI)) - 1e-9);
  }

  /** What says nothing of a quarter alone is computed all round: a corner in a side's middle. */
  @Test
  void quarterSaysAll_ofWhatIsMirrored() {
    List<Point> corners = new ArrayList<>(board(0.06, 0.04));
    OutlineLevels quarter = levels(corners);
    corners.add(new Point(0, -0.02));
    OutlineLevels whole = levels(corners);
    for (int degrees = 0; degrees <= 360; degrees += 7) {
      double bearing = Math.toRadians(degrees);
      assertEquals(whole.levelDb(bearing, 0.7), quarter.levelDb(bearing, 0.7), 0.05);
    }
  }

  /** Found sooner, but the same as with the place of the echo. */
  @ParameterizedTest
  @CsvSource({"0, 0.2", "31, 0.4", "45, 1.6", "200, 3.2"})
  void levelAlone_isThatOfTheEcho(double degrees, double distanceM) {
    OutlineEcho echo = new OutlineEcho(Outline.of(board(0.06, 0.04)), WAVENUMBER_PER_M);
    double bearing = Math.toRadians(degrees);
    // A sum over five waves, and their mean.
    double sum = echo.echo(bearing, distanceM).levelDb();
    assertEquals(sum - 10 * Math.log10(5), echo.levelDb(bearing, distanceM), 1e-6);
  }

  @Test
  void equal_whereOutlineAndWaveAre() {
    OutlineLevels one = levels(board(0.06, 0.04));
    assertEquals(levels(board(0.06, 0.04)), one);
    assertEquals(levels(board(0.06, 0.04)).hashCode(), one.hashCode());
    assertNotEquals(levels(board(0.06, 0.05)), one);
    assertNotEquals(new OutlineLevels(Outline.of(board(0.06, 0.04)), 700), one);
    assertNotEquals(one, new Object());
    assertEquals("levels of an outline of 4 corners", one.toString());
  }
}
