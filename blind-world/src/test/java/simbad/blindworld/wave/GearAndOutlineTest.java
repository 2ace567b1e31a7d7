package simbad.blindworld.wave;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.blindworld.world.Point;
import simbad.blindworld.world.Pose;

/** What a sonar is made of, and the outlines and listeners of an echo. */
class GearAndOutlineTest {

  private static final double NEAR = 1e-12;
  private static final Air AIR = new Air(20, 0, 101.325);

  private static Burst burst() {
    return new Burst(
        40_000, 8, new Burst.Resonance(40_000, 20), new Burst.Resonance(41_000, 10), 1e-4);
  }

  private static Gear gear() {
    return new Gear(
        burst(),
        new Gear.Pistons(0.006, 0.008, 0.1, 0.2),
        new Gear.Receiver(1, 3, 0.002, 0.0005, 0.02, 0.1),
        20);
  }

  @Test
  void burst_isChangedInOneThing() {
    Burst burst = burst();
    assertEquals(new Burst(40_000, 5, burst.sender(), burst.receiver(), 1e-4), burst.withCycles(5));
    assertEquals(
        new Burst(39_000, 8, burst.sender(), burst.receiver(), 1e-4), burst.withFrequency(39_000));
    assertEquals(3e-4, burst.delayed(2e-4).delayS(), NEAR);
    assertEquals(Math.PI * 2000, burst.sender().decayPerS(), 1e-9);
    assertEquals(-Math.PI * 4100, burst.receiver().pole(40_000).re(), 1e-9);
    assertEquals(2 * Math.PI * 1000, burst.receiver().pole(40_000).im(), 1e-9);
  }

  @Test
  void gear_isChangedInOneThing() {
    Gear gear = gear();
    Burst other = burst().withCycles(3);
    assertEquals(new Gear(other, gear.pistons(), gear.receiver(), 20), gear.with(other));
    Gear.Pistons pistons = gear.pistons().scaled(2);
    assertEquals(new Gear.Pistons(0.012, 0.016, 0.1, 0.2), pistons);
    assertEquals(new Gear(burst(), pistons, gear.receiver(), 20), gear.with(pistons));
    assertEquals(0.4, gear.pistons().turned(0.3).axisRad(), NEAR);
    assertEquals(0.2, gear.pistons().turned(0.3).receiverAxisRad(), NEAR);
    assertEquals(0.5, gear.pistons().receiverTurned(0.3).receiverAxisRad(), NEAR);
    assertEquals(0.1, gear.pistons().receiverTurned(0.3).axisRad(), NEAR);
    Gear.Receiver receiver = gear.receiver();
    assertEquals(1 + 2 / Math.E, receiver.thresholdAt(0.002), NEAR);
    assertEquals(new Gear.Receiver(1, 3, 0.002, 0.7, 0.02, 0.1), receiver.armedAt(0.7));
    assertEquals(new Gear.Receiver(1, 3, 0.002, 0.0005, 0.7, 0.1), receiver.withTimeout(0.7));
    assertEquals(0.3, receiver.noisier(3).noise(), NEAR);
    assertEquals(receiver.armedAt(0.7), gear.with(receiver.armedAt(0.7)).receiver());
    assertEquals(17, gear.louder(-3).levelDb());
    assertEquals(new Air(25, 0, 101.325), AIR.warmer(5));
    assertEquals(new Air(20, 40, 101.325), AIR.withHumidity(40));
  }

  /** 20 dB are ten times the pressure; sound goes 343.2 m/s, and a burst begins 4 cycles late. */
  @Test
  void medium_isWhatCanBeSaidBefore() {
    Medium medium = new Medium(gear(), AIR);
    assertSame(medium.gear(), medium.gear());
    assertEquals(343.2, medium.soundSpeedMPerS(), 1e-9);
    assertEquals(2 * Math.PI * 40_000 / 343.2, medium.perM(), 1e-9);
    assertEquals(10, medium.leftAfter(0), NEAR);
    double lost = AIR.absorptionDbPerM(40_000) * 3;
    assertEquals(10 * Math.pow(10, -lost / 20), medium.leftAfter(3), 1e-9);
    assertEquals(40 + 4, medium.cyclesAfter(0.3432), 1e-9);
    assertEquals(2 * Math.PI * 4, medium.delayPhaseRad(), 1e-9);
    double sine = 0.4;
    assertEquals(new Piston(0.006, medium.perM()).at(sine), medium.sent(sine), NEAR);
    assertEquals(new Piston(0.008, medium.perM()).at(sine), medium.received(sine), NEAR);
    assertTrue(medium.sent(sine) > medium.received(sine));
    double most = 0;
    for (Complex value : burst().pulse()) {
      most = Math.max(most, value.size());
    }
    assertEquals(most, medium.pulsePeak(), NEAR);
    assertSame(medium.over(new Upright(-1, 1)), medium.over(new Upright(-1, 1)));
  }

  /** Sampled at whole cycles from the begin on, until less than two thousandths are left. */
  @Test
  void pulse_endsWhereItIsOver() {
    Burst burst = burst();
    Complex[] pulse = burst.pulse();
    double most = 0;
    for (int n = 0; n < pulse.length; n++) {
      assertEquals(burst.envelope(n / 40_000.0).size(), pulse[n].size(), NEAR);
      most = Math.max(most, pulse[n].size());
    }
    assertEquals(0, pulse[0].size());
    assertTrue(pulse[pulse.length - 1].size() > 2e-3 * most);
    assertTrue(burst.envelope(pulse.length / 40_000.0).size() <= 2e-3 * most);
    assertTrue(pulse.length > 8 && pulse.length < 160, pulse.length + " cycles");
  }

  /** Between its steps, 1/1024 of the sine, a directivity is straight. */
  @Test
  void piston_isStraightBetweenItsSteps() {
    Piston piston = new Piston(0.008, 700);
    double one = Piston.directivity(5.6 * 100 / 1024);
    double other = Piston.directivity(5.6 * 101 / 1024);
    assertEquals(one, piston.at(100 / 1024.0), NEAR);
    assertEquals(one + 0.25 * (other - one), piston.at(-100.25 / 1024), NEAR);
    assertEquals(Piston.directivity(5.6), piston.at(3), NEAR);
  }

  /** A short target is the sum over its height: before a broad piston, its length times a phase. */
  @Test
  void verticalSum_ofAShortTarget_isItsLength() {
    Gear broad = gear().with(new Gear.Pistons(1e-5, 1e-5, 0, 0));
    Medium medium = new Medium(broad, AIR);
    for (double distanceM : new double[] {0.5, 1, 4}) {
      Complex sum = medium.over(new Upright(0.02, 0.03)).at(distanceM);
      // The phase k z^2 / d turns by 2 x from its lower to its upper end.
      double x = medium.perM() * (0.03 * 0.03 - 0.02 * 0.02) / distanceM / 2;
      assertEquals(0.01 * Math.sin(x) / x, sum.size(), 3e-5);
      double phase = -medium.perM() * 0.025 * 0.025 / distanceM;
      assertEquals(phase, Math.atan2(sum.im(), sum.re()), 0.02);
    }
    // Nearer than 2 cm and further than 8 m are not told apart; above 1.2 distances is nothing.
    VerticalSum sum = medium.over(new Upright(-0.1, 0.1));
    assertEquals(sum.at(0.02), sum.at(0.001));
    assertEquals(sum.at(8), sum.at(99));
    assertEquals(0, medium.over(new Upright(0.5, 1)).at(0.4).size());
  }

  private static Outline.Face face(double aX, double aZ, double bX, double bZ) {
    return new Outline.Face(new Point(aX, aZ), new Point(bX, bZ));
  }

  /** A face from (0, -1) to (0, 2). */
  @ParameterizedTest
  @CsvSource({
    "-1, 0, 1, 0, true", "1, 0, -1, 0, true", "-1, 0, -2, 0, false", "-1, 3, 1, 3, false",
    "-1, -2, 1, -2, false", "-1, 4, 1, 2, false", "-1, 2.5, 1, 0, true", "1, 0, 2, 0, false",
  })
  void face_parts(double aX, double aZ, double bX, double bZ, boolean parted) {
    assertEquals(parted, face(0, -1, 0, 2).parts(aX, aZ, bX, bZ));
    assertEquals(parted, face(0, 2, 0, -1).parts(aX, aZ, bX, bZ));
    assertEquals(3, face(0, -1, 0, 2).lengthM(), NEAR);
  }

  private static final List<Point> SQUARE =
      List.of(
          new Point(-0.1, -0.1), new Point(0.1, -0.1), new Point(0.1, 0.1), new Point(-0.1, 0.1));

  private static List<Point> backwards(List<Point> corners) {
    List<Point> other = new ArrayList<>(corners);
    Collections.reverse(other);
    return other;
  }

  /** Elements of a millimetre, their normals outwards, either way round. */
  @Test
  void outline_hasItsNormalsOutwards() {
    for (List<Point> corners : List.of(SQUARE, backwards(SQUARE))) {
      Outline outline = Outline.of(corners);
      assertEquals(0.1 * Math.sqrt(2), outline.radiusM(), NEAR);
      assertEquals(4 * 182, outline.size(), "0.2 m in pieces of 1.1 mm");
      double length = 0;
      for (int e = 0; e < outline.size(); e++) {
        length += outline.lengthM[e];
        double out = outline.xM[e] * outline.normalX[e] + outline.zM[e] * outline.normalZ[e];
        assertEquals(0.1, out, NEAR, "a normal's foot is a side's middle");
        assertEquals(1, Math.hypot(outline.normalX[e], outline.normalZ[e]), NEAR);
        assertEquals(0.2 / 182, outline.lengthM[e], NEAR);
      }
      assertEquals(0.8, length, 1e-9);
      assertTrue(outline.faces.isEmpty());
      Outline.Face right =
          corners == SQUARE ? face(0.1, -0.1, 0.1, 0.1) : face(0.1, 0.1, 0.1, -0.1);
      assertTrue(outline.sees(right, 0.2, 0));
      assertFalse(outline.sees(right, 0.05, 0));
    }
    assertEquals(0.2 / 182 / 2, outlineX(0), NEAR);
  }

  /** The first element's middle is half of its length from the corner. */
  private static double outlineX(int element) {
    return Outline.of(SQUARE).xM[element] + 0.1;
  }

  @Test
  void coveredFace_sendsBackItsShare() {
    Outline outline = Outline.covered(SQUARE, List.of(1.0, 0.25, 1.0, 0.0));
    assertEquals(0.2 / 182, outline.lengthM[0], NEAR);
    assertEquals(0.05 / 182, outline.lengthM[182], NEAR);
    assertEquals(0, outline.lengthM[3 * 182 + 1]);
    assertThrows(
        IllegalArgumentException.class, () -> Outline.covered(SQUARE, List.of(1.0, 1.5, 1.0, 1.0)));
  }

  @Test
  void roundOutline_isEven() {
    Outline outline = Outline.round(0.1);
    assertEquals(572, outline.size(), "0.628 m in pieces of 1.1 mm");
    assertEquals(0.1, outline.radiusM(), NEAR);
    assertEquals(24, Outline.round(0.001).size());
    assertTrue(outline.faces.isEmpty());
    for (int e = 0; e < outline.size(); e++) {
      double out = outline.xM[e] * outline.normalX[e] + outline.zM[e] * outline.normalZ[e];
      assertEquals(0.1, out, 1e-5);
    }
  }

  /** An angle with an inner corner: what stands behind a leg is not free. */
  @Test
  void hollowOutline_hidesItself() {
    List<Point> angle =
        List.of(
            new Point(0, 0),
            new Point(0.1, 0),
            new Point(0.1, 0.01),
            new Point(0.01, 0.01),
            new Point(0.01, 0.1),
            new Point(0, 0.1));
    for (List<Point> corners : List.of(angle, backwards(angle))) {
      Outline outline = Outline.of(corners);
      assertEquals(6, outline.faces.size());
      int inner = element(outline, 0.05, 0.01);
      assertTrue(outline.isFree(inner, 0.2, 0.5));
      assertTrue(outline.isFree(inner, 0.05, 0.3));
      assertFalse(outline.isFree(inner, -0.5, 0.05), "the other leg is between");
      assertTrue(outline.isFree(inner, -0.5, 1.8), "above the other leg");
    }
  }

  private static int element(Outline outline, double xM, double zM) {
    int best = 0;
    for (int e = 1; e < outline.size(); e++) {
      double now = Math.hypot(outline.xM[e] - xM, outline.zM[e] - zM);
      best = now < Math.hypot(outline.xM[best] - xM, outline.zM[best] - zM) ? e : best;
    }
    return best;
  }

  /** A heading of 90 degrees looks up the page, against z. */
  @Test
  void listener_looksAlongItsAxis() {
    Listener listener = Listener.at(new Pose(1, 2, Math.PI / 3), Math.PI / 6);
    assertEquals(1, listener.xM());
    assertEquals(2, listener.zM());
    assertEquals(0, listener.axisX(), NEAR);
    assertEquals(-1, listener.axisZ(), NEAR);
    assertEquals(5, listener.distanceTo(4, -2), NEAR);
    assertEquals(0.01, listener.distanceTo(1, 2), NEAR, "never nearer than a centimetre");
    // 3 to the right and 4 ahead.
    assertEquals(0.6, listener.sineTo(4, -2), NEAR);
    assertEquals(0.6, listener.sineTo(-2, -2), NEAR);
    assertEquals(0, listener.sineTo(1, -2), NEAR);
    assertEquals(1, listener.sineTo(1, 3), "behind it");
    assertEquals(1, listener.sineTo(2, 2), "beside it");
  }

  /** In the mirror z = x the two change places. */
  @Test
  void mirror_turnsPlaceAndAxis() {
    Listener listener = new Listener(3, 1, 0.6, -0.8);
    Listener image = listener.mirrored(face(0, 0, 2, 2));
    assertEquals(1, image.xM(), NEAR);
    assertEquals(3, image.zM(), NEAR);
    assertEquals(-0.8, image.axisX(), NEAR);
    assertEquals(0.6, image.axisZ(), NEAR);
    Listener wall = listener.mirrored(face(5, 9, 5, -4));
    assertEquals(7, wall.xM(), NEAR);
    assertEquals(1, wall.zM(), NEAR);
    assertEquals(-0.6, wall.axisX(), NEAR);
    assertEquals(-0.8, wall.axisZ(), NEAR);
  }

  /** 100 cycles' way there and back, 4 cycles of delay, 6 dB over the threshold at that time. */
  @Test
  void fixedEcho_hasItsLevelAtItsTime() {
    Gear flat = gear().with(new Gear.Receiver(0.5, 3, 0.002, 0, 0.02, 0.1));
    Medium medium = new Medium(flat, AIR);
    FixedEcho echo = new FixedEcho(343.2 / 800, 6, 2);
    assertEquals(2, echo.restlessDb());
    Trace trace = echo.arrivals(new Pose(0, 0, 0), medium, 0);
    double threshold = 0.5 + 2.5 * Math.exp(-104 / 40_000.0 / 0.002);
    double size = threshold * Math.pow(10, 0.3) / medium.pulsePeak() * 10;
    double found = trace.re(103) + trace.re(104) + trace.re(105);
    assertEquals(size, found, 1e-6 * size);
  }

  /** A target keeps its outline and its height where it is moved, turned and made another one. */
  @Test
  void target_isChangedInOneThing() {
    Outline outline = Outline.of(SQUARE);
    Target target = new Target(outline, new Upright(-1, 1), new Point(1, 2), 0.5);
    assertSame(outline, target.moved(1, 1).outline());
    assertEquals(new Point(2, 1.5), target.moved(1, -0.5).place());
    assertEquals(new Point(1, 2), target.turned(3).place());
    Outline other = Outline.round(0.1);
    assertSame(other, target.with(other).outline());
    assertEquals(new Point(1, 2), target.with(other).place());
  }
}
