package simbad.blindworld.effect;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static simbad.blindworld.effect.EffectGround.BOX;
import static simbad.blindworld.effect.EffectGround.POST;
import static simbad.blindworld.effect.EffectGround.down;
import static simbad.blindworld.effect.EffectGround.draw;
import static simbad.blindworld.effect.EffectGround.hearing;
import static simbad.blindworld.effect.EffectGround.number;
import static simbad.blindworld.effect.EffectGround.sight;

import java.util.List;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.blindworld.world.AnyPing;
import simbad.blindworld.world.Beam;
import simbad.blindworld.world.Body;
import simbad.blindworld.world.FixedChance;
import simbad.blindworld.world.Ping;
import simbad.blindworld.world.Pose;
import simbad.blindworld.world.Shadow;

/** What stands where and looks where, and how strong echoes are. */
class MapAndEnergyFormsTest {

  private static final double NEAR = 1e-9;
  private static final List<Body> BODIES = List.of(Body.of(POST), Body.of(BOX));

  private static List<Body> bodies(Effect effect) {
    return effect.change().bodies(BODIES);
  }

  private static double turnedDeg(Body before, Body after) {
    Pose pose = new Pose(1, 2, 0);
    Beam beam = new Beam(0, 0.3);
    double bearing = before.seenFrom(pose, beam, 0).bearingRad();
    return Math.toDegrees(bearing - after.seenFrom(pose, beam, 0).bearingRad());
  }

  /** Only what has a table is known to be turned. */
  @Test
  void turn_isOfTheOneWithATableOrOfAll() {
    Effect one = draw("obstacle-turn", "one", 2);
    assertEquals("box", one.parameters().get("obstacle"));
    assertEquals(18, number(one, "deg"), NEAR);
    assertSame(BODIES.get(0), bodies(one).get(0));
    assertEquals(18, turnedDeg(BODIES.get(1), bodies(one).get(1)), NEAR);
    Effect all = draw("obstacle-turn", "all", 1, down());
    assertEquals(-9, turnedDeg(BODIES.get(0), bodies(all).get(0)), NEAR);
    assertEquals(-9, turnedDeg(BODIES.get(1), bodies(all).get(1)), NEAR);
  }

  /** By chance of 0.25 the first one, and down the page. */
  @Test
  void offset_isOfOneOrOfAll() {
    Effect one = draw("obstacle-offset", "one", 2, new FixedChance(0.25));
    assertEquals("post", one.parameters().get("obstacle"));
    assertEquals(0, number(one, "dx"), NEAR);
    assertEquals(0.12, number(one, "dz"), NEAR);
    assertEquals(0.12, bodies(one).get(0).place().zM(), NEAR);
    assertSame(BODIES.get(1), bodies(one).get(1));
    Effect all = draw("obstacle-offset", "all", 1);
    assertEquals(-0.06, bodies(all).get(0).place().xM(), NEAR);
    assertEquals(-0.06, bodies(all).get(1).place().xM(), NEAR);
    assertEquals(50, bodies(all).get(1).place().zM(), NEAR);
  }

  /** The post is heard less by bearing, in 72 steps of 5 degrees; what has a table stays. */
  private static void assertShadow(Effect effect, DoubleUnaryOperator loss) {
    double depth = number(effect, "depth");
    Shadow shadow = bodies(effect).get(0).shadow();
    assertEquals(72, shadow.radiiM().size());
    for (int i = 0; i < 72; i++) {
      double expected = 3 * (1 - depth * loss.applyAsDouble(Math.toRadians(5 * i)));
      assertEquals(expected, shadow.radiiM().get(i), NEAR, 5 * i + " degrees");
    }
    assertSame(BODIES.get(1), bodies(effect).get(1));
  }

  /** Four lobes from half a turn on, to the power of 1.75. */
  @Test
  void lobes_areWaves() {
    Effect effect = draw("orientation-shadow", "lobes", 1);
    assertEquals(0.5, number(effect, "depth"), NEAR);
    assertShadow(effect, b -> Math.pow(0.5 + 0.5 * Math.cos(4 * b + Math.PI), 1.75));
    assertEquals(0.95, number(draw("orientation-shadow", "lobes", 9), "depth"), NEAR);
  }

  /** Two notches at 90 and 180 degrees of 0.15 + 0.35 / 4 rad, flat in their inner halves. */
  @Test
  void notches_areFlatInside() {
    FixedChance chance = new FixedChance(0.1, 0.25, 0.5, 0.25);
    double half = 0.15 + 0.35 / 4;
    assertShadow(
        draw("orientation-shadow", "notches", 1, chance),
        b -> {
          double beside = Math.min(Math.abs(b - Math.PI / 2), Math.abs(b - Math.PI));
          return beside <= half / 2 ? 1 : beside >= half ? 0 : 2 - 2 * beside / half;
        });
  }

  @Test
  void oneSide_isSilent() {
    assertShadow(
        draw("orientation-shadow", "one side", 1, new FixedChance(0.25)),
        b -> 1 / (1 + Math.exp(-4 * Math.cos(b - Math.PI / 2))));
  }

  private static Beam beam(Effect effect, String sensor) {
    return effect.change().beam(sensor, new Beam(0.05, 0.3));
  }

  /** By 4 degrees, and never narrower than by six tenths of the half-angle. */
  @Test
  void beams_areWiderOrAside() {
    Effect wider = draw("beam-width", "all", 1);
    assertEquals(0.3 + Math.toRadians(4), beam(wider, "s").halfAngleRad(), NEAR);
    assertEquals(0.05, beam(wider, "s").axisRad());
    Effect narrow = draw("beam-width", "all", 9, down());
    assertEquals(0.12, beam(narrow, "s").halfAngleRad(), NEAR);
    Effect one = draw("beam-width", "one", 1);
    assertEquals("t", one.parameters().get("sensor"));
    assertEquals(0.3, beam(one, "s").halfAngleRad());
    assertEquals(0.3 + Math.toRadians(4), beam(one, "t").halfAngleRad(), NEAR);
    Effect aside = draw("beam-misalignment", "all", 2, down());
    assertEquals(0.05 - Math.toRadians(10), beam(aside, "s").axisRad(), NEAR);
    assertEquals(0.3, beam(aside, "s").halfAngleRad());
    Effect other = draw("beam-misalignment", "one", 1, new FixedChance(0.25));
    assertEquals("s", other.parameters().get("sensor"));
    assertEquals(0.05 + Math.toRadians(7), beam(other, "s").axisRad(), NEAR);
    assertEquals(0.05, beam(other, "t").axisRad());
  }

  private static double threshold(Effect effect, double thresholdM, Ping ping) {
    return hearing(effect).thresholdM(thresholdM, sight(0, 1, 0), ping);
  }

  private static double threshold(Effect effect, double thresholdM) {
    return threshold(effect, thresholdM, AnyPing.FIRST);
  }

  /** 40 dB are ten times the distance. */
  @Test
  void gain_scalesThresholds() {
    assertEquals(2 * Math.exp(0.28), threshold(draw("gain", "factor", 2), 2), NEAR);
    assertEquals(2 * Math.exp(-0.14), threshold(draw("gain", "factor", 1, down()), 2), NEAR);
    Effect decibels = draw("gain", "decibels", 40 / 2.4);
    assertEquals(40, number(decibels, "db"), NEAR);
    assertEquals(20, threshold(decibels, 2), NEAR);
    Effect flutter = draw("gain", "fluttering", 1, down());
    assertEquals(0.16 * 0.12, number(flutter, "flutter"), NEAR);
    Ping ping = AnyPing.at(new FixedChance(0.5).gaussian(2), 0, 0);
    assertEquals(2 * Math.exp(-0.16) * (1 + 2 * 0.0192), threshold(flutter, 2, ping), NEAR);
  }

  /** A way of 2 m and 1.5 dB/m each way, against 40 lg of the distance. */
  @Test
  void absorption_takesMoreOfWhatIsFar() {
    assertEquals(2 * Math.exp(-0.28), threshold(draw("absorption", "exponential", 1), 2), NEAR);
    assertEquals(2 / 1.32, threshold(draw("absorption", "rational", 1), 2), NEAR);
    Effect equation = draw("absorption", "sonar equation", 1);
    assertEquals(1.5, number(equation, "db_per_m"), NEAR);
    double r = threshold(equation, 2);
    assertEquals(0, 40 * Math.log10(r / 2) + 2 * 1.5 * r, 1e-6);
    assertEquals(-1, EnergyForms.attenuatedM(-1, 3));
    assertEquals(2, EnergyForms.attenuatedM(2, 0));
  }

  private static double tapered(String form, double share) {
    Effect effect = draw("beam-pattern", form, 1);
    double offAxis = -0.3 * share;
    return hearing(effect).thresholdM(2, sight(0, 1, offAxis), AnyPing.FIRST) / 2;
  }

  /** With e = exp(-0.6) at the rim, by the share of the half-angle. */
  @Test
  void tapers_haveTheirShapes() {
    double e = Math.exp(-0.6);
    assertEquals(Math.cos(0.5 * Math.acos(e)), tapered("cosine", 0.5), NEAR);
    assertEquals(Math.exp(-0.15), tapered("gaussian", 0.5), NEAR);
    assertEquals((1 + e) / 2, tapered("linear", 0.5), NEAR);
    assertEquals(1, tapered("flat top", 0.4), NEAR);
    assertEquals(1 - (1 - e) / 2, tapered("flat top", 0.7), NEAR);
    assertEquals(1 - (1 - e) / 16, tapered("fourth power", 0.5), NEAR);
    // Beyond the rim it falls on, until half of the half-angle further, and not below nothing.
    assertEquals(1 - (1 - e) * 1.25, tapered("linear", 1.25), NEAR);
    assertEquals(1 - (1 - e) * 1.5, tapered("linear", 9), NEAR);
    assertEquals(0, tapered("fourth power", 9), NEAR);
  }

  /** sin(w) / w is e at the rim: at the half of it, sin(w/2) / (w/2) with cos(w/2) e-th of that. */
  @Test
  void sinc_isTheLobeThatReachesTheRim() {
    double e = Math.exp(-0.6);
    double half = tapered("sinc", 0.5);
    // sin w = 2 sin(w/2) cos(w/2), so e = half * cos(w/2), and half = sin(w/2) / (w/2).
    double w = 2 * Math.acos(e / half);
    assertEquals(Math.sin(w / 2) / (w / 2), half, 1e-6);
    assertEquals(e, Math.sin(w) / w, 1e-6);
    assertEquals(1, tapered("sinc", 0), NEAR);
    Effect none = draw("beam-pattern", "sinc", 0);
    assertEquals(2, hearing(none).thresholdM(2, sight(0, 1, 0.3), AnyPing.FIRST), NEAR);
  }

  @ParameterizedTest
  @CsvSource({
    "both ways, true, 3.27", "both ways, false, 2.73", "pick-up only, true, 3",
    "pick-up only, false, 2.46", "metres, true, 3", "metres, false, 2.75",
  })
  void hysteresis_dependsOnThePingBefore(String form, boolean heard, double expectedM) {
    Ping ping = AnyPing.after(new FixedChance(0.5), 1, heard);
    assertEquals(expectedM, threshold(draw("hysteresis", form, 1), 3, ping), NEAR);
  }

  @Test
  void hysteresis_hasItsEnds() {
    Ping silent = AnyPing.after(new FixedChance(0.5), 1, false);
    assertEquals(0.6, threshold(draw("hysteresis", "pick-up only", 9), 3, silent), NEAR);
    assertEquals(0.09, threshold(draw("hysteresis", "metres", 1), 0.3, silent), NEAR);
    assertEquals(0, threshold(draw("hysteresis", "metres", 1), 0, silent), NEAR);
  }

  @ParameterizedTest
  @ValueSource(strings = {"obstacle-turn", "orientation-shadow", "beam-width"})
  void forms_applyWhereThereIsSomethingToChange(String name) {
    assertTrue(Vocabulary.applies(name, EffectGround.circumstances(new FixedChance(0.5), 1)));
  }
}
