package simbad.scattering;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.frame.Point;
import simbad.sonar.level.Air;
import simbad.sonar.shape.Outline;
import simbad.sonar.shape.ThresholdTable;

class BackscatterTest {
  /** Names of cross-sections: the thesis's three, and those in data/obstacles. */
  static Stream<String> sections() {
    return Stream.of(
        "square", "round", "angle", "half-round", "hexagon", "plate", "tee", "channel", "leg-pair");
  }

  /**
   * Halving every element moves the logarithm of no bearing's threshold by a hundredth, with the
   * calibration that is shipped: without its desensitisation, which makes some thresholds depend on
   * a hundredth of a decibel, by no more than a fifth of that.
   */
  @ParameterizedTest
  @MethodSource("sections")
  void thresholds_haveConverged(String name) throws DataFormatException {
    List<Outline> section = Cases.section(name);
    double elementM = Backscatter.elementM(section, Air.ROOM);
    Backscatter here = Backscatter.of(section, Air.ROOM, 72, elementM);
    Backscatter finer = Backscatter.of(section, Air.ROOM, 72, elementM / 2);
    Receiver shipped = FittedReceiver.SRF04.receiver();
    checkConverged(here, finer, shipped, 0.01);
    checkConverged(here, finer, new Receiver(shipped.levelDb(), 0, shipped.recoveryS()), 0.002);
  }

  private static void checkConverged(
      Backscatter here, Backscatter finer, Receiver receiver, double most) {
    SonarEquation equation = SonarEquation.of(receiver, Air.ROOM, Cases.SRF04);
    double[] coarse = equation.thresholdsM(here, 0);
    double[] fine = equation.thresholdsM(finer, 0);
    for (int i = 0; i < coarse.length; i++) {
      assertEquals(0, Math.log(fine[i] / coarse[i]), most, "at " + 5 * i + " degrees");
    }
  }

  /** What is symmetric in space is in the table: a square by quarter turns and mirrored. */
  @ParameterizedTest
  @ValueSource(ints = {0, 1, 5, 8})
  void square_hasItsSymmetries(int index) {
    Backscatter square = Cases.echo(Cases.square(0.0254));
    assertEquals(square.levelDb(index), square.levelDb(index + 18), 1e-6);
    assertEquals(square.levelDb(index), square.levelDb((72 - index) % 72), 1e-6);
  }

  @Test
  void senseOfTheOutline_doesNotMatter() {
    Outline angle = Cases.angle();
    List<Point> corners = new ArrayList<>(angle.corners());
    Collections.reverse(corners);
    Backscatter one = Cases.echo(angle);
    Backscatter other = Cases.echo(Outline.of(corners));
    for (int i = 0; i < 12; i++) {
      assertEquals(one.levelDb(i), other.levelDb(i), 1e-6);
    }
  }

  /** Its lobes are where the thesis measured them: over the outer faces, +x and -z. */
  @Test
  void angle_echoesMostFromItsFaces() {
    Backscatter angle = Cases.echo(Cases.angle());
    assertTrue(angle.levelDb(18) > angle.levelDb(22) + 10);
    assertTrue(angle.levelDb(36) > angle.levelDb(32) + 10);
    assertTrue(angle.levelDb(63) > angle.levelDb(27) + 10, "inner corner over outer edge");
  }

  @Test
  void smearing_ofAConstant_isTheConstant() {
    double[] raw = new double[72];
    Arrays.fill(raw, 0.3);
    for (double value : Backscatter.smeared(raw, 1, 0.1)) {
      assertEquals(0.3, value, 1e-15);
    }
  }

  @Test
  void largeOutlines_getElementsWithinATenthOfAWavelength() {
    double wavelengthM = 2 * Math.PI / Air.ROOM.wavenumberPerM(Backscatter.FREQUENCY_HZ);
    assertEquals(0.25e-3, Backscatter.elementM(List.of(Cases.square(0.025)), Air.ROOM), 1e-12);
    assertEquals(0.5e-3, Backscatter.elementM(List.of(Cases.square(0.1)), Air.ROOM), 1e-12);
    assertEquals(wavelengthM / 10, Backscatter.elementM(List.of(Cases.square(1)), Air.ROOM), 1e-12);
  }

  /** 72 bearings of a larger post stay within the table's limits. */
  @Test
  void prediction_ofALargerPost_isATable() {
    ThresholdPrediction prediction = Cases.predicted(Cases.circle(0.05, 48), FittedReceiver.SRF04);
    ThresholdTable table = prediction.table();
    for (int i = 0; i < table.size(); i++) {
      assertTrue(prediction.band().low().valueM(i) <= table.valueM(i));
      assertTrue(table.valueM(i) <= prediction.band().high().valueM(i));
      assertEquals(table.valueM(0), table.valueM(i), 0.05, "a circle");
    }
    assertTrue(table.valueM(0) > 2, "thicker than the one inch tube of about 2 m");
  }

  /**
   * Two posts far apart answer like one each: their mean power is twice that of one, as long as the
   * bearings between which their echoes interfere are averaged.
   */
  @Test
  void twoPosts_answerTogether() {
    Outline one = Cases.circle(0.005, 24);
    List<Outline> pair = List.of(shifted(one, -0.03), shifted(one, 0.03));
    Backscatter both = Backscatter.of(pair, Air.ROOM, 72);
    double power = 0;
    for (int i = 0; i < both.size(); i++) {
      power += Math.pow(10, both.levelDb(i) / 10) / both.size();
    }
    double single = Math.pow(10, Cases.echo(one).levelDb(0) / 10);
    assertEquals(2, power / single, 0.3);
  }

  private static Outline shifted(Outline outline, double xM) {
    return Outline.of(outline.corners().stream().map(c -> new Point(c.xM() + xM, c.zM())).toList());
  }
}
