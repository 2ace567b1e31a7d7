package simbad.blindworld.effect;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static simbad.blindworld.effect.EffectGround.circumstances;
import static simbad.blindworld.effect.EffectGround.draw;
import static simbad.blindworld.effect.EffectGround.hearing;
import static simbad.blindworld.effect.EffectGround.number;
import static simbad.blindworld.effect.EffectGround.sight;

import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.blindworld.world.AnyPing;
import simbad.blindworld.world.FixedChance;
import simbad.blindworld.world.Hearing;
import simbad.blindworld.world.Ping;
import simbad.blindworld.world.Scene;

/** The names of the vocabulary's second version, in closed form. */
class FurtherFormsTest {

  private static final double NONE = Double.POSITIVE_INFINITY;
  private static final double NEAR = 1e-9;

  private static double rangeM(Effect effect, double rangeM, double tS) {
    return hearing(effect).rangeM(rangeM, AnyPing.at(new FixedChance(0.5), tS, 0));
  }

  private static double reportedM(Effect effect, double readingM, double share) {
    return hearing(effect).reportedM(readingM, AnyPing.at(new FixedChance(share), 0, 0));
  }

  /** The longest run has 4 s; chance says a quarter of it. */
  @Test
  void drift_goesWithTheTime() {
    Effect settling = draw("range-drift", "settling", 1);
    assertEquals(1, number(settling, "time_s"), NEAR);
    assertEquals(2, rangeM(settling, 2, 0), NEAR);
    assertEquals(2 + 0.06 * (1 - Math.exp(-3)), rangeM(settling, 2, 3), NEAR);
    Effect steady = draw("range-drift", "steady", 2);
    assertEquals(1 + 0.16 * 3 / 4, rangeM(steady, 1, 3), NEAR);
    Effect warming = draw("range-drift", "warming", 1, EffectGround.down());
    assertEquals(2 * (1 - 0.05 * (1 - Math.exp(-2))), rangeM(warming, 2, 2), NEAR);
  }

  @Test
  void code_standsForSilence() {
    Effect nought = draw("no-echo-code", "nought", 1);
    assertEquals(0, reportedM(nought, NONE, 0.999));
    assertEquals(1.5, reportedM(nought, 1.5, 0));
    Effect end = draw("no-echo-code", "end", 0.25);
    assertEquals(4, reportedM(end, NONE, 0.24));
    assertEquals(NONE, reportedM(end, NONE, 0.26));
    assertEquals(1, number(draw("no-echo-code", "end", 9), "share"));
  }

  /** Echoes come from 1.0, 1.1, ... 1.9 m: three quarters of them from below 1.7 m. */
  @Test
  void wrap_beginsAgainFromNought() {
    for (String form : List.of("counter", "printed")) {
      Effect effect = draw("wrap", form, 1);
      assertEquals(1.7, number(effect, "m"), NEAR);
      boolean isPrinted = form.equals("printed");
      for (double lengthM : new double[] {0.4, 1.69, 1.75, 3.5}) {
        double wrapped = lengthM < 1.7 ? lengthM : lengthM < 3.4 ? lengthM - 1.7 : lengthM - 3.4;
        assertEquals(
            wrapped, isPrinted ? reportedM(effect, lengthM, 0) : rangeM(effect, lengthM, 0), NEAR);
      }
      assertEquals(NONE, reportedM(effect, NONE, 0));
    }
    assertEquals(1.2, number(draw("wrap", "counter", 9), "m"), NEAR);
  }

  /**
   * At half of its threshold of 3 m an echo is a quarter as late, where the envelope rises
   * straight.
   */
  @Test
  void weakEchoes_readLonger() {
    Effect straight = draw("range-walk", "straight rise", 1);
    Hearing hearing = hearing(straight);
    Ping ping = AnyPing.at(new FixedChance(0.5), 0, 0);
    assertEquals(3, hearing.thresholdM(3, sight(0, 1.5, 0), ping));
    hearing.thresholdM(3, sight(0, 2.9, 0), ping);
    assertEquals(1.5, hearing.echoM(1.5, ping));
    assertEquals(1.5 + 0.06 / 4, hearing.rangeM(1.5, ping), NEAR);
    hearing.echoM(2.9, ping);
    assertEquals(2.9 + 0.06 * Math.pow(2.9 / 3, 2), hearing.rangeM(2.9, ping), NEAR);
    assertEquals(0.7, hearing.echoM(0.7, ping), "of nothing that was seen");
    assertEquals(0.7, hearing.rangeM(0.7, ping));
    // Beyond the threshold, and where nothing is ever heard, as late as just at it.
    hearing.thresholdM(3, sight(0, 3.2, 0), ping);
    hearing.echoM(3.2, ping);
    assertEquals(3.26, hearing.rangeM(3.2, ping), NEAR);
    hearing.thresholdM(0, sight(0, 0.9, 0), ping);
    hearing.echoM(0.9, ping);
    assertEquals(0.96, hearing.rangeM(0.9, ping), NEAR);
    // -log10(1 - 0.9) = 1 at the threshold.
    Hearing swelling = hearing(draw("range-walk", "swelling", 2));
    swelling.thresholdM(3, sight(0, 3, 0), ping);
    swelling.echoM(3, ping);
    assertEquals(3.12, swelling.rangeM(3, ping), NEAR);
  }

  @Test
  void walk_needsATable() {
    Scene post = new Scene(5, EffectGround.SENSOR, List.of(EffectGround.POST));
    Circumstances uniform =
        new Circumstances(post, EffectGround.ROWS, true, new FixedChance(0.5), 1);
    assertFalse(Vocabulary.applies("range-walk", uniform));
    assertTrue(Vocabulary.applies("range-walk", circumstances(new FixedChance(0.5), 1)));
  }

  /** 0.2 m lower, and out of a beam of 0.3 rad nearer than 0.2 / tan 0.3 = 0.647 m. */
  @Test
  void highTarget_isOnASlant() {
    Effect slanting = draw("vertical-beam", "slanting", 1);
    assertEquals(Math.sqrt(1.04), rangeM(slanting, 1, 0), NEAR);
    Ping ping = AnyPing.at(new FixedChance(0.5), 0, 0);
    assertEquals(3, hearing(slanting).thresholdM(3, sight(0, 0.1, 0), ping));
    Hearing over = hearing(draw("vertical-beam", "over the beam", 1));
    assertEquals(0, over.thresholdM(3, sight(0, 0.646, 0), ping));
    assertEquals(3, over.thresholdM(3, sight(0, 0.648, 0), ping));
    assertEquals(Math.sqrt(0.29), over.rangeM(0.5, ping), NEAR);
  }

  @Test
  void names_areThoseThatAreAskedFor() {
    assertEquals(
        List.of(
            "no-echo-code",
            "placement-error",
            "range-drift",
            "range-walk",
            "vertical-beam",
            "wrap"),
        Vocabulary.further());
    for (String name : Vocabulary.further()) {
      assertTrue(Vocabulary.contains(name), name);
      assertFalse(Vocabulary.names().contains(name), name);
    }
  }
}
