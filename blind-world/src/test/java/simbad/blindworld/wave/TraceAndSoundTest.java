package simbad.blindworld.wave;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.blindworld.world.FixedChance;

/** Complex numbers, echoes on the time axis, and the comparator that waits for them. */
class TraceAndSoundTest {

  private static final double NEAR = 1e-12;
  private static final double NONE = Double.POSITIVE_INFINITY;
  private static final Complex ONE = new Complex(1, 0);

  private static void assertComplex(double re, double im, Complex found) {
    assertEquals(re, found.re(), NEAR);
    assertEquals(im, found.im(), NEAR);
  }

  /** (3 + 4i) and (1 - 2i). */
  @Test
  void complexNumbers_areReckonedWith() {
    Complex a = new Complex(3, 4);
    Complex b = new Complex(1, -2);
    assertComplex(4, 2, a.plus(b));
    assertComplex(2, 6, a.minus(b));
    assertComplex(11, -2, a.times(b));
    assertComplex(6, 8, a.times(2));
    // (3 + 4i)(1 + 2i) / 5.
    assertComplex(-1, 2, a.over(b));
    assertEquals(5, a.size(), NEAR);
    assertComplex(0, 2, Complex.polar(2, Math.PI / 2));
    assertComplex(Math.E * Math.cos(1), Math.E * Math.sin(1), new Complex(1, 1).exp());
  }

  /** An arrival at 5.25 cycles is three quarters at 5 and one at 6. */
  @Test
  void arrival_isSharedOutBetweenCycles() {
    Trace trace = new Trace(4, 3);
    trace.add(5.25, 8, -4);
    assertEquals(6, trace.re(5), NEAR);
    assertEquals(2, trace.re(6), NEAR);
    assertEquals(-3, trace.im(5), NEAR);
    assertEquals(-1, trace.im(6), NEAR);
    assertEquals(0, trace.re(4));
    assertEquals(0, trace.re(7));
    assertEquals(0, trace.im(3));
    assertEquals(4, trace.first());
    assertEquals(3, trace.length());
    trace.add(6.5, 1, 0);
    assertEquals(2.5, trace.re(6), NEAR, "what lies outside is lost");
    assertTrue(trace.holds(4) && trace.holds(6));
    assertFalse(trace.holds(3) || trace.holds(7));
    assertEquals(Math.hypot(6, 3), trace.most(), NEAR);
    assertEquals(0, Trace.silent().length());
    assertEquals(0, Trace.silent().most());
  }

  @Test
  void traces_addWhereTheyReach() {
    Trace one = new Trace(4, 2);
    one.add(4, 1, 2);
    Trace other = new Trace(5, 3);
    other.add(5, 10, 20);
    other.add(6, 99, 99);
    one.add(other, 0.5);
    assertEquals(1, one.re(4), NEAR);
    assertEquals(5, one.re(5), NEAR);
    assertEquals(10, one.im(5), NEAR);
    assertEquals(2, one.length());
  }

  /** (1 + i) and (2i) two cycles later, each drawn as (1, 3i). */
  @Test
  void arrivals_areDrawnAsPulses() {
    Trace bare = new Trace(7, 3);
    bare.add(7, 1, 1);
    bare.add(9, 0, 2);
    Trace drawn = bare.drawn(new Complex[] {ONE, new Complex(0, 3)});
    assertEquals(7, drawn.first());
    assertEquals(5, drawn.length());
    double[] re = IntStream.range(7, 11).mapToDouble(drawn::re).toArray();
    double[] im = IntStream.range(7, 11).mapToDouble(drawn::im).toArray();
    assertArrayEquals(new double[] {1, -3, 0, -6}, re, NEAR);
    assertArrayEquals(new double[] {1, 3, 2, 0}, im, NEAR);
  }

  private static Gear gear(double armS, double timeoutS, double noise, double start) {
    Burst.Resonance wide = new Burst.Resonance(40_000, 3);
    return new Gear(
        new Burst(40_000, 8, wide, wide, 0),
        new Gear.Pistons(0.007, 0.007, 0, 0),
        new Gear.Receiver(1, start, 1e-4, armS, timeoutS, noise),
        0);
  }

  /** A cycle is 25 microseconds; listened to from 0.11 ms to 0.5 ms are the cycles 5 to 20. */
  @Test
  void detector_listensForAWhile() {
    Detector detector = new Detector(gear(1.1e-4, 5.1e-4, 0.1, 3));
    assertEquals(5, detector.armed());
    assertEquals(20, detector.end());
    // From 3 down to 1, by exp(-t / 0.1 ms): four cycles are 0.1 ms.
    assertEquals(3, detector.threshold(0), NEAR);
    assertEquals(1 + 2 / Math.E, detector.threshold(4), NEAR);
    assertEquals(5, new Detector(gear(1.1e-4, 1e-5, 0.1, 3)).end());
  }

  /**
   * 4.5 standard deviations of 0.1 under the threshold of 1, and nothing of less than a fiftieth.
   */
  @Test
  void faintEchoes_areNotReckonedWith() {
    Detector detector = new Detector(gear(0, 5e-4, 0.1, 1));
    assertTrue(detector.mayHear(0.551, 3));
    assertFalse(detector.mayHear(0.549, 3));
    Detector noisy = new Detector(gear(0, 5e-4, 9, 1));
    assertTrue(noisy.mayHear(0.021, 3));
    assertFalse(noisy.mayHear(0.019, 3));
  }

  /**
   * Over 20 cycles noise of a third of the threshold is over it by (1 - exp(-pi / 3)) exp(-9 / 2)
   * in each: of an exposure of half of that more than 4 such cycles it is the fifth one after the
   * first, and a quarter of a cycle later.
   */
  @Test
  void noise_isTakenForAnEchoByItsHazard() {
    Detector detector = new Detector(gear(1e-4, 6e-4, 1 / 3.0, 1));
    double each = (1 - Math.exp(-Math.PI / 3)) * Math.exp(-4.5);
    double share = 1 - Math.exp(-4.5 * each);
    assertEquals((4 + 4 + 0.25) / 40_000, detector.falseAlarmS(new FixedChance(share, 0.25)), NEAR);
    double all = 1 - Math.exp(-22 * each);
    assertEquals(NONE, detector.falseAlarmS(new FixedChance(all, 0.25)));
    Detector quiet = new Detector(gear(1e-4, 6e-4, 0.1, 1));
    FixedChance chance = new FixedChance(0.5);
    assertEquals(NONE, quiet.falseAlarmS(chance));
    assertEquals(0, chance.asked());
  }

  private static Sound sound(Detector detector, double headroom, double[]... echoes) {
    List<Trace> traces =
        java.util.Arrays.stream(echoes)
            .map(
                echo -> {
                  Trace trace = new Trace(8, echo.length);
                  for (int i = 0; i < echo.length; i++) {
                    trace.add(8 + i, echo[i], 0);
                  }
                  return trace;
                })
            .toList();
    return new Sound(traces, detector, headroom);
  }

  private static double firstS(double noise, FixedChance chance, double... echo) {
    Detector detector = new Detector(gear(1e-4, 1e-3, noise, 1));
    return detector.firstS(sound(detector, 1, echo), new Complex[] {ONE}, chance);
  }

  /** At the first cycle whose envelope is over the threshold, of 1. */
  @Test
  void echo_isDetectedWhereItCrosses() {
    assertEquals(10 / 40_000.0, firstS(1e-9, new FixedChance(0), 0.2, 0.9, 1.1, 3), NEAR);
    assertEquals(9 / 40_000.0, firstS(1e-9, new FixedChance(0), 0.2, 1, 0, 3), NEAR);
    assertEquals(NONE, firstS(1e-9, new FixedChance(0), 0.2, 0.9));
    // Noise of 0.2 more in phase lifts the second one, and turns nothing.
    FixedChance lift = new FixedChance(0).gaussian(1, 0);
    assertEquals(9 / 40_000.0, firstS(0.2, lift, 0.1, 0.9, 3), NEAR);
  }

  /** The comparator fires at a crest: a phase of a quarter is a quarter of a cycle earlier. */
  @Test
  void crest_isByThePhase() {
    Detector detector = new Detector(gear(1e-4, 1e-3, 1e-9, 1));
    Sound sound = sound(detector, 1, new double[] {0, 0, 5});
    double first = detector.firstS(sound, new Complex[] {new Complex(0, 1)}, new FixedChance(0));
    assertEquals((10 - 0.25) / 40_000, first, NEAR);
  }

  /** What is high when ringing ends has to be low in between. */
  @Test
  void comparator_firesOnlyWhenItRises() {
    Detector detector = new Detector(gear(2e-4, 1e-3, 1e-9, 1));
    assertEquals(8, detector.armed());
    FixedChance none = new FixedChance(0);
    Complex[] one = {ONE};
    assertEquals(NONE, detector.firstS(sound(detector, 1, new double[] {2, 2, 2}), one, none));
    assertEquals(
        11 / 40_000.0,
        detector.firstS(sound(detector, 1, new double[] {2, 2, 0.9, 2}), one, none),
        NEAR);
    // What is left out between two cycles was low.
    assertEquals(
        10 / 40_000.0,
        detector.firstS(sound(detector, 1, new double[] {2, 0, 2}), one, none),
        NEAR);
  }

  /** Noise hangs together over neighbouring cycles: k of it is kept, k = exp(-pi / 3). */
  @Test
  void noise_hangsTogetherFromCycleToCycle() {
    double k = Math.exp(-Math.PI / 3);
    double second = 0.2 * (k + Math.sqrt(1 - k * k));
    for (double off : new double[] {-1e-6, 1e-6}) {
      FixedChance chance = new FixedChance(0).gaussian(1, 0, 1, 0);
      double first = firstS(0.2, chance, 0.5, 1 - second + off);
      assertEquals(off > 0 ? 9 / 40_000.0 : NONE, first, NEAR);
    }
  }

  /** What is loud enough on some ping is kept; the level is of all echoes together. */
  @Test
  void sound_keepsWhatMayBeHeard() {
    Detector detector = new Detector(gear(1e-4, 1e-3, 0.1, 1));
    Sound sound = sound(detector, 1, new double[] {0.3, 1, 0.2}, new double[] {0.3, -3, 0.3});
    assertEquals(2, sound.size());
    assertEquals(8, sound.cycle(0));
    assertEquals(9, sound.cycle(1));
    assertEquals(20 * Math.log10(2), sound.excessDb(), 1e-9);
    assertEquals(3, sound(detector, 2, new double[] {0.3, 1, 0.3}).size());
    Complex[] factors = {new Complex(0, 2), new Complex(1, 1)};
    // 1 times 2i and -3 times (1 + i).
    assertEquals(-3, sound.re(1, factors), NEAR);
    assertEquals(2 - 3, sound.im(1, factors), NEAR);
    assertEquals(-99, sound(detector, 1, new double[] {0}).excessDb());
    assertEquals(-99, new Sound(List.of(), detector, 1).excessDb());
  }

  /** Of echoes before the receiver listens and after it gives up nothing is kept. */
  @ParameterizedTest
  @CsvSource({"2e-4, 1e-3, 3", "2.25e-4, 1e-3, 2", "2e-4, 2.3e-4, 2", "4e-4, 1e-3, 0"})
  void sound_isWhatIsListenedTo(double armS, double timeoutS, int size) {
    Detector detector = new Detector(gear(armS, timeoutS, 0.1, 1));
    assertEquals(size, sound(detector, 1, new double[] {2, 2, 2}).size());
  }
}
