package simbad.blindworld.effect;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static simbad.blindworld.effect.EffectGround.circumstances;
import static simbad.blindworld.effect.EffectGround.draw;
import static simbad.blindworld.effect.EffectGround.hearing;
import static simbad.blindworld.effect.EffectGround.number;
import static simbad.blindworld.effect.EffectGround.sight;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.blindworld.world.AnyPing;
import simbad.blindworld.world.FixedChance;
import simbad.blindworld.world.Hearing;
import simbad.blindworld.world.Ping;
import simbad.blindworld.world.Recording;
import simbad.blindworld.world.Row;

/** Other arrivals, and echoes that are lost, with chance that is told what to say. */
class ArrivalFormsTest {

  private static final double NONE = Double.POSITIVE_INFINITY;
  private static final double NEAR = 1e-9;
  private static final double HEARD = 1e-6;

  private static double echo(Effect effect, double distanceM, FixedChance chance) {
    return hearing(effect).echoM(distanceM, AnyPing.at(chance, 0, 0));
  }

  /** Arrivals go from 5 cm to 0.725 of the 4 m: a half of it is at 1.475 m. */
  @Test
  void crosstalk_isAnywhereByChance() {
    Effect any = draw("crosstalk", "any", 2);
    assertEquals(0.12, number(any, "p"), NEAR);
    assertEquals(2.9, number(any, "hi"), NEAR);
    assertEquals(1.475, echo(any, 1, new FixedChance(0.11, 0.5)), NEAR);
    assertEquals(1, echo(any, 1, new FixedChance(0.13, 0.5)));
    Effect nearer = draw("crosstalk", "nearer", 1);
    assertEquals(1, echo(nearer, 1, new FixedChance(0.06, 0.5)));
    assertEquals(1.475, echo(nearer, NONE, new FixedChance(0.06, 0.5)), NEAR);
    assertEquals(NONE, echo(nearer, NONE, new FixedChance(0.08, 0.5)));
    Effect silent = draw("crosstalk", "when silent", 1);
    assertEquals(2, echo(silent, 2, new FixedChance(0.07, 0.5)));
    assertEquals(1.475, echo(silent, NONE, new FixedChance(0.07, 0.5)), NEAR);
    assertEquals(NONE, echo(silent, NONE, new FixedChance(0.09, 0.5)));
  }

  /** It begins in 0.012 and ends in a quarter; of its pings eight in ten are heard. */
  @Test
  void crosstalk_clusters() {
    Effect effect = draw("crosstalk", "clustered", 1);
    assertEquals(0.012, number(effect, "begins"), NEAR);
    assertEquals(0.25, number(effect, "ends"), NEAR);
    Hearing hearing = hearing(effect);
    Ping ping = AnyPing.at(new FixedChance(0.04, 0.79, 0.5, 0.9, 0.81, 0.2, 0.9), 0, 0);
    assertEquals(1.475, hearing.echoM(NONE, ping), NEAR);
    assertEquals(NONE, hearing.echoM(NONE, ping), "on, not heard");
    assertEquals(NONE, hearing.echoM(NONE, ping), "off");
    assertEquals(NONE, hearing.echoM(NONE, ping));
  }

  /** 0.1235 m further each ping, round and round between 0.05 and 2.9 m. */
  @Test
  void crosstalk_walks() {
    Effect effect = draw("crosstalk", "beat", 1);
    assertEquals(0.1235, number(effect, "walk_m"), NEAR);
    Hearing hearing = hearing(effect);
    FixedChance chance = new FixedChance(0.09);
    assertEquals(0.05, hearing.echoM(1, AnyPing.at(chance, 0, 0)), NEAR);
    assertEquals(0.05 + 2 * 0.1235, hearing.echoM(1, AnyPing.at(chance, 0, 2)), NEAR);
    assertEquals(0.05 + 24 * 0.1235 - 2.85, hearing.echoM(1, AnyPing.at(chance, 0, 24)), NEAR);
    assertEquals(0.3, hearing.echoM(0.3, AnyPing.at(chance, 0, 10)), "the nearer one counts");
    assertEquals(1, hearing.echoM(1, AnyPing.at(new FixedChance(0.11), 0, 0)));
  }

  /** A longer way in 14 or 15 of a hundred, or 20; what is longer than 4 m is lost. */
  @Test
  void multipath_isALongerWay() {
    FixedChance often = new FixedChance(0.13).gaussian(2);
    FixedChance seldom = new FixedChance(0.21);
    Effect longer = draw("multipath", "additive", 1);
    assertEquals(1 + 0.325 + 2 * 0.03, echo(longer, 1, often), NEAR);
    assertEquals(1, echo(longer, 1, new FixedChance(0.13).gaussian(-99)), "never shorter");
    assertEquals(1, echo(longer, 1, new FixedChance(0.15)));
    assertEquals(NONE, echo(longer, 3.8, often));
    assertEquals(NONE, echo(longer, NONE, often));
    Effect factor = draw("multipath", "factor", 1);
    assertEquals(1.64, echo(factor, 1, often), NEAR);
    assertEquals(1, echo(factor, 1, new FixedChance(0.13).gaussian(-99)));
    assertEquals(1, echo(factor, 1, seldom));
    Effect mixture = draw("multipath", "mixture", 1);
    assertEquals(2.26, echo(mixture, 2, new FixedChance(0.14)), NEAR);
    assertEquals(3.4, echo(mixture, 2, new FixedChance(0.14).coins(false)), NEAR);
    assertEquals(2, echo(mixture, 2, new FixedChance(0.16)));
    Effect tail = draw("multipath", "tail", 1);
    assertEquals(1 + 0.275 * Math.log(2), echo(tail, 1, new FixedChance(0.19, 0.5)), NEAR);
    assertEquals(1, echo(tail, 1, seldom));
  }

  /** From 15 cm up a rim of 0.775 of 0.3 rad meets the floor at 0.15 / sin, within 3.6 m. */
  @Test
  void floor_answersInsteadOfWhatIsFurther() {
    FixedChance often = new FixedChance(0.44).gaussian(-2);
    Effect mount = draw("floor-echo", "from the mount", 1);
    double slant = 0.15 / Math.sin(0.2325);
    assertEquals(slant, number(mount, "m"), NEAR);
    assertEquals(0.5, number(mount, "p"), NEAR);
    assertEquals(slant - 0.024, echo(mount, 2, often), NEAR);
    assertEquals(0.5, echo(mount, 0.5, often));
    assertEquals(2, echo(mount, 2, new FixedChance(0.51)));
    Effect fixed = draw("floor-echo", "fixed", 1);
    assertEquals(1.5, number(fixed, "m"), NEAR);
    assertEquals(1.5 - 2 * 0.0215, echo(fixed, NONE, often), NEAR);
    assertEquals(NONE, echo(fixed, NONE, new FixedChance(0.46)));
    Effect joints = draw("floor-echo", "two joints", 1);
    assertEquals(1.3 - 0.02, echo(joints, NONE, often), NEAR);
    FixedChance other = new FixedChance(0.44).gaussian(-2).coins(false);
    assertEquals(1.36 - 0.02, echo(joints, NONE, other), NEAR);
    for (String form : List.of("from the mount", "fixed", "two joints")) {
      assertEquals(1, number(draw("floor-echo", form, 9), "p"));
    }
  }

  /** The same pings, twenty a second. */
  private static Effect previous(String form) {
    List<Row> rows = new ArrayList<>();
    for (Row row : EffectGround.ROWS.rows()) {
      rows.add(new Row(row.run(), row.sensor(), 0.05 * row.tS(), row.pose()));
    }
    return Vocabulary.draw(
        "previous-ping",
        form,
        new Circumstances(EffectGround.SCENE, new Recording(rows), true, new FixedChance(0.5), 1));
  }

  private static double after(Effect effect, double lastM, double distanceM, double chance) {
    Ping ping = AnyPing.after(new FixedChance(chance), lastM, true);
    return hearing(effect).echoM(distanceM, ping);
  }

  /** The middle of what is heard is 1.5 m: the gap is 3 - 0.55 of 1.5 m. */
  @Test
  void previousPing_comesALittleLater() {
    Effect bounce = previous("second bounce");
    double gap = 3 - 0.55 * 1.5;
    assertEquals(gap, number(bounce, "gap_m"), HEARD);
    assertEquals(3 - gap, after(bounce, 1.5, 2, 0.44), HEARD);
    assertEquals(0.7, after(bounce, 1.5, 0.7, 0.44), "not before the nearest");
    assertEquals(2, after(bounce, 1.1, 2, 0.44), "2.2 - 2.175 m is too near");
    assertEquals(2, after(bounce, 1.5, 2, 0.46), "not by chance");
    assertEquals(2, after(bounce, NONE, 2, 0.44), "nothing was heard before");
    Effect share = previous("share");
    assertEquals(0.55 * 1.5, after(share, 1.5, 2, 0.39), NEAR);
    assertEquals(2, after(share, 1.5, 2, 0.41));
    Effect sum = previous("constant sum");
    assertEquals(2 * 1.2 - 1.1 - 0.275, after(sum, 1.1, 1.2, 0.44), NEAR);
    assertEquals(NONE, after(sum, 1.1, NONE, 0.44));
  }

  /** Sound goes 171.6 m there and back in a second, and 16 m in 0.0932 s. */
  @ParameterizedTest
  @CsvSource({"1, false", "0.094, false", "0.093, true", "0.05, true"})
  void previousPing_needsFastPings(double periodS, boolean applies) {
    List<Row> rows = new ArrayList<>();
    for (Row row : EffectGround.ROWS.rows()) {
      rows.add(new Row(row.run(), row.sensor(), periodS * row.tS(), row.pose()));
    }
    Circumstances c =
        new Circumstances(EffectGround.SCENE, new Recording(rows), true, new FixedChance(0.5), 1);
    assertEquals(applies, Vocabulary.applies("previous-ping", c));
  }

  private static boolean[] lost(Effect effect, FixedChance chance, int pings) {
    Hearing hearing = hearing(effect);
    boolean[] lost = new boolean[pings];
    for (int i = 0; i < pings; i++) {
      lost[i] = hearing.echoM(1, AnyPing.at(chance, i, i)) == NONE;
    }
    return lost;
  }

  @Test
  void dropout_isSingleOrInBursts() {
    Effect single = draw("dropout", "single", 1);
    assertArrayEquals(
        new boolean[] {true, false, true}, lost(single, new FixedChance(0.19, 0.21, 0.1), 3));
    assertEquals(0.9, number(draw("dropout", "single", 9), "p"), NEAR);
    // Bursts of 8.5 pings, of which a fifth is lost: one begins in 0.25 / 8.5 = 0.0294.
    Effect bursts = draw("dropout", "bursts", 1);
    assertEquals(8.5, number(bursts, "mean_length"), NEAR);
    assertArrayEquals(
        new boolean[] {true, true, false, false, true},
        lost(bursts, new FixedChance(0.19, 0.12, 0.117, 0.03, 0.029), 5));
    assertEquals(0.7, number(draw("dropout", "bursts", 9), "share"), NEAR);
  }

  /** A level that wanders: 1 at first, then 23/24 of it with fresh chance; a logistic of it. */
  @Test
  void dropout_swells() {
    Effect effect = draw("dropout", "swelling", 1);
    double keeps = 23.0 / 24;
    assertEquals(0.4, number(effect, "most"), NEAR);
    assertEquals(keeps, number(effect, "keeps"), NEAR);
    double first = 0.4 / (1 + Math.exp(-2));
    double level = keeps - Math.sqrt(1 - keeps * keeps);
    double second = 0.4 / (1 + Math.exp(-2 * level));
    for (double off : new double[] {-1e-6, 1e-6}) {
      FixedChance chance = new FixedChance(first + off, second + off).gaussian(1, -1);
      assertArrayEquals(new boolean[] {off < 0, off < 0}, lost(effect, chance, 2));
    }
    assertEquals(0.95, number(draw("dropout", "swelling", 9), "most"), NEAR);
  }

  /** Windows of 8 s, for every transducer of a run the same, and others in another repeat. */
  @Test
  void dropout_isOfAllTransducersTogether() {
    Effect effect = draw("dropout", "all transducers", 2);
    assertEquals(8, number(effect, "length_s"), NEAR);
    assertEquals(0.4, number(effect, "share"), NEAR);
    int silent = 0;
    boolean differs = false;
    for (int window = 0; window < 500; window++) {
      boolean[] found = new boolean[4];
      double[] times = {8 * window + 0.1, 8 * window + 7.9, 8 * window + 3, 8 * window + 3};
      for (int i = 0; i < 4; i++) {
        Hearing hearing =
            effect
                .change()
                .hearing(EffectGround.ROWS, EffectGround.ROWS.tracks().get(i % 2), i == 3 ? 8 : 7);
        double heard = hearing.echoM(1, AnyPing.at(new FixedChance(0.5), times[i], 0));
        found[i] = heard == NONE;
      }
      assertEquals(found[0], found[1]);
      assertEquals(found[0], found[2]);
      differs |= found[0] != found[3];
      silent += found[0] ? 1 : 0;
    }
    assertTrue(differs);
    // Five standard errors of 500 windows are 0.11.
    assertEquals(0.4, silent / 500.0, 0.11);
    assertEquals(0.7, number(draw("dropout", "all transducers", 9), "share"), NEAR);
  }

  /** The threshold of what is lost is nothing; chance 0.5 is asked only where it is not sure. */
  private static boolean isHeard(Effect effect, double distanceM, double chance) {
    Ping ping = AnyPing.at(new FixedChance(chance), 0, 0);
    return hearing(effect).thresholdM(3, sight(0, distanceM, 0), ping) == 3;
  }

  /** A quarter of what is heard is nearer than 1.2 m. */
  @Test
  void deadZone_losesWhatIsNear() {
    Effect sharp = draw("dead-zone", "sharp", 1);
    assertEquals(1.2, number(sharp, "m"), HEARD);
    assertFalse(isHeard(sharp, 1.19, 0.5));
    assertTrue(isHeard(sharp, 1.21, 0.5));
    assertEquals(NONE, hearing(sharp).echoM(1.19, AnyPing.FIRST));
    assertEquals(1.21, hearing(sharp).echoM(1.21, AnyPing.FIRST));
    assertEquals(NONE, hearing(sharp).echoM(NONE, AnyPing.FIRST));
    assertEquals(0.02, number(draw("dead-zone", "sharp", 0), "m"));
    assertEquals(1.7, number(draw("dead-zone", "sharp", 9), "m"), HEARD);
    // A logistic of 4 cm: half at 1.2 m, 1 / (1 + e) at 1.24 m, none from 1.52 m on.
    Effect soft = draw("dead-zone", "soft", 1);
    assertFalse(isHeard(soft, 1.24, 1 / (1 + Math.E) - 1e-4));
    assertTrue(isHeard(soft, 1.24, 1 / (1 + Math.E) + 1e-4));
    assertFalse(isHeard(soft, 1.5, 0));
    assertTrue(isHeard(soft, 1.53, 0));
    assertEquals(1.1, hearing(soft).echoM(1.1, AnyPing.FIRST));
    // A straight line from all at 0.72 m to none at 1.2 m.
    Effect ramp = draw("dead-zone", "ramp", 1);
    assertEquals(0.72, number(ramp, "inner_m"), HEARD);
    assertFalse(isHeard(ramp, 1.08, 0.2499));
    assertTrue(isHeard(ramp, 1.08, 0.2501));
    assertFalse(isHeard(ramp, 0.71, 1 - 1e-9));
    assertTrue(isHeard(ramp, 1.21, 0));
  }

  /** Of what is heard 0.78 are nearer than 1.7 m. */
  @Test
  void earlyTimeout_losesWhatIsFar() {
    Effect sharp = draw("early-timeout", "sharp", 1);
    assertEquals(1.7, number(sharp, "m"), HEARD);
    assertTrue(isHeard(sharp, 1.69, 0.5));
    assertFalse(isHeard(sharp, 1.71, 0.5));
    assertEquals(4, number(draw("early-timeout", "sharp", 0), "m"));
    assertEquals(1.3, number(draw("early-timeout", "sharp", 9), "m"), HEARD);
    Effect soft = draw("early-timeout", "soft", 1);
    assertFalse(isHeard(soft, 1.66, 1 / (1 + Math.E) - 1e-4));
    assertTrue(isHeard(soft, 1.66, 1 / (1 + Math.E) + 1e-4));
    assertFalse(isHeard(soft, 1.4, 0));
    assertTrue(isHeard(soft, 1.37, 0));
    // By 4 per cent, 6.8 cm, earlier or later.
    Effect jittered = draw("early-timeout", "jittered", 1);
    assertEquals(0.068, number(jittered, "jitter_m"), HEARD);
    assertEquals(1.73, echo(jittered, 1.73, new FixedChance(0.75)));
    assertEquals(NONE, echo(jittered, 1.74, new FixedChance(0.75)));
    assertEquals(1.66, echo(jittered, 1.66, new FixedChance(0.25)));
    assertEquals(NONE, echo(jittered, 1.67, new FixedChance(0.25)));
    assertEquals(0, circumstances(new FixedChance(0.5), 0).strength());
  }
}
