package simbad.sonar.ping;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Point;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.UniformDetection;
import simbad.sonar.shape.Outline;

class NearFieldTest {
  private static final double WAVENUMBER_PER_M = 2 * Math.PI * 40_000 / 343;

  private static NearField field(double thresholdM, Point... corners) {
    return new NearField(
        new Obstacle(
            "one",
            Placement.IDENTITY,
            Outline.of(List.of(corners)),
            new UniformDetection(thresholdM)),
        WAVENUMBER_PER_M);
  }

  private static Point[] board(double wideM, double thickM) {
    double x = wideM / 2;
    double z = thickM / 2;
    return new Point[] {
      new Point(-x, -z), new Point(-x, z), new Point(x, z), new Point(x, -z),
    };
  }

  private static Point[] round(double radiusM) {
    List<Point> corners = new ArrayList<>();
    for (int i = 0; i < 72; i++) {
      double angle = Math.toRadians(5 * i);
      corners.add(new Point(radiusM * Math.sin(angle), radiusM * Math.cos(angle)));
    }
    return corners.toArray(Point[]::new);
  }

  /** A flat strip far away: sin x / x of its width over the wave (Morse and Ingard 1968). */
  @Test
  void fromFarAway_aStripHasTheLobeOfItsWidth() {
    double wideM = 0.03;
    NearField strip = field(4.5, board(wideM, 0.0005));
    double face = strip.believedDb(0);
    for (double degrees : new double[] {1, 2, 3, 4, 5}) {
      double bearing = Math.toRadians(degrees);
      double x = WAVENUMBER_PER_M * wideM * Math.sin(bearing);
      double lobe = 20 * Math.log10(Math.sin(x) / x * Math.cos(bearing));
      assertEquals(lobe, strip.believedDb(bearing) - face, 0.4, degrees + " degrees");
    }
  }

  /** A mirror answers from the foot of the perpendicular, wherever its middle is. */
  @Test
  void beforeALongBoard_theEchoComesFromTheFoot() {
    NearField board = field(2, board(2, 0.02));
    for (int degrees : new int[] {10, -10, 20, -20}) {
      double bearing = Math.toRadians(Math.floorMod(degrees, 360));
      // Seen from r sin b, r cos b the foot is as far from the centre's direction as b is from 0,
      // less what the pieces beyond the board's end are missing for.
      assertEquals(Math.toRadians(-degrees), board.offCentreRad(bearing, 0.8), 0.03);
    }
  }

  /** Of any side of a round post, and in whichever sense its corners go round. */
  @Test
  void beforeARoundPost_itComesFromTheMiddle() {
    Point[] corners = round(0.04);
    Point[] back = new Point[corners.length];
    for (int i = 0; i < back.length; i++) {
      back[i] = corners[back.length - 1 - i];
    }
    NearField post = field(1, corners);
    NearField same = field(1, back);
    for (double bearing = 0; bearing < 6.2; bearing += 0.31) {
      for (double distance : PolarGrid.distancesM()) {
        assertEquals(0, post.offCentreRad(bearing, distance), Math.toRadians(0.3));
        assertEquals(post.addedDb(bearing, distance), same.addedDb(bearing, distance), 1e-9);
      }
    }
  }

  /**
   * As if from a mirror's image, the echo of a wide board falls as fast as the wave spreads from
   * one point in the plane: half as fast, in decibels, as a strength of one distance says. So it
   * gains 10 lg of the distance's ratio.
   */
  @Test
  void aWideBoard_answersMoreTheFurtherItIs() {
    NearField board = field(0.8, board(3, 0.02));
    assertEquals(10 * Math.log10(1.13 / 0.8), board.addedDb(0, 1.13), 0.3);
    assertEquals(10 * Math.log10(0.56 / 0.8), board.addedDb(0, 0.56), 0.3);
    assertEquals(3, board.addedDb(0, 4), 0);
    assertEquals(-3, board.addedDb(0, 0.2), 0);
  }

  /** Beyond the distance of Fraunhofer, 2 D^2 / wavelength = 0.15 m, a strip is a strip. */
  @Test
  void aNarrowBoard_isTheSameFarAndNear() {
    NearField board = field(2, board(0.025, 0.02));
    for (double distance : new double[] {0.56, 0.8, 1.6, 3.2}) {
      assertEquals(0, board.addedDb(0, distance), 0.25);
    }
  }

  @Test
  void aMirroredScene_answersMirrored() {
    NearField one = field(1, board(0.3, 0.1));
    for (int degrees = 0; degrees < 180; degrees += 7) {
      double bearing = Math.toRadians(degrees);
      double mirrored = 2 * Math.PI - bearing;
      for (double distance : new double[] {0.15, 0.3, 0.9, 2}) {
        assertEquals(one.addedDb(bearing, distance), one.addedDb(mirrored, distance), 1e-6);
        assertEquals(
            one.offCentreRad(bearing, distance), -one.offCentreRad(mirrored, distance), 1e-6);
      }
    }
  }

  @Test
  void nearerAndFurtherThanItIsKnown_itStays() {
    NearField one = field(1, board(0.3, 0.1));
    assertEquals(one.addedDb(1, 0.1), one.addedDb(1, 0.01), 0);
    assertEquals(one.offCentreRad(1, 4.53), one.offCentreRad(1, 40), 0);
  }
}
