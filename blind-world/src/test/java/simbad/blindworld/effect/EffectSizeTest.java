package simbad.blindworld.effect;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import simbad.blindworld.world.Chance;
import simbad.blindworld.world.Pose;
import simbad.blindworld.world.Recording;
import simbad.blindworld.world.Scene;
import simbad.blindworld.world.Sensor;
import simbad.blindworld.world.TestWorlds;

/** What an effect of known parameters does to a scene of one post, worked out by hand. */
class EffectSizeTest {

  private static final double NONE = Double.POSITIVE_INFINITY;
  private static final Sensor SURE = TestWorlds.sureSensor(15);
  private static final Scene POST = new Scene(5, SURE, List.of(TestWorlds.post("p", 0, 0, 3)));

  private static Effect effect(String name, String form, Scene scene, Recording rows) {
    return Vocabulary.draw(name, form, new Circumstances(scene, rows, true, new Chance(1), 1));
  }

  private static double number(Effect effect, String parameter) {
    return effect.parameters().get(parameter) instanceof Number n ? n.doubleValue() : Double.NaN;
  }

  private static double[] read(Effect effect, Recording rows) {
    return TestWorlds.read(POST, rows, List.of(effect.change()));
  }

  @Test
  void soundSpeed_scalesRanges() {
    Recording rows = TestWorlds.approach(2, 1, 3);
    Effect effect = effect("sound-speed", "speed", POST, rows);
    double factor = 343 / number(effect, "c");
    double[] read = read(effect, rows);
    assertEquals(1.98 * factor, read[0], 1e-4);
    assertEquals(0.98 * factor, read[2], 1e-4);
    assertTrue(Math.abs(factor - 1) > 0.02);
  }

  @Test
  void rangeOffset_shiftsRanges() {
    Recording rows = TestWorlds.approach(2, 1, 3);
    Effect effect = effect("range-offset", "constant", POST, rows);
    double[] read = read(effect, rows);
    assertEquals(1.98 + number(effect, "m"), read[0], 1e-4);
    assertEquals(0.98 + number(effect, "m"), read[2], 1e-4);
  }

  @Test
  void gain_movesTheThreshold() {
    Recording rows = TestWorlds.approach(4, 2, 2001);
    Effect effect = effect("gain", "factor", POST, rows);
    double[] read = read(effect, rows);
    int first = IntStream.range(0, read.length).filter(i -> read[i] < NONE).findFirst().orElse(-1);
    assertEquals(Math.min(4, 3 * number(effect, "k")), 4 - 0.001 * first, 0.002);
  }

  @Test
  void dropout_losesItsShare() {
    Recording rows = TestWorlds.approach(1, 1, 20000);
    for (String form : List.of("single", "bursts", "all transducers")) {
      Effect effect = effect("dropout", form, POST, rows);
      double share = form.equals("single") ? number(effect, "p") : number(effect, "share");
      double lost = Arrays.stream(read(effect, rows)).filter(r -> r == NONE).count() / 20000.0;
      // Bursts last up to 14 pings: some 1,400 of them, so five standard errors are 0.055.
      assertEquals(share, lost, 0.055, form);
    }
  }

  @Test
  void latency_readsFromWhereItWas() {
    Recording rows = TestWorlds.approach(2.5, 0.5, 101);
    Effect effect = effect("latency", "seconds", POST, rows);
    double lagM = number(effect, "s") * 2.0 / 10;
    double[] read = read(effect, rows);
    assertEquals(2.5 - 0.02 * 60 + lagM - 0.02, read[60], 1e-3);
  }

  @Test
  void odometry_scalesTheWayFromTheStart() {
    Recording rows = TestWorlds.approach(2.5, 0.5, 101);
    Effect effect = effect("odometry-scale", "from the start", POST, rows);
    assertEquals(2.5 - 1 / number(effect, "k") - 0.02, read(effect, rows)[50], 1e-3);
  }

  @Test
  void stale_repeatsTheLastReadingSoManyTimes() {
    // Heard up to 3 m: pings 0 to 10 are echoes, the rest is silence.
    Recording rows = TestWorlds.approach(2, 4, 21);
    Effect effect = effect("stale-reading", "count", POST, rows);
    double[] read = read(effect, rows);
    int count = (int) number(effect, "n");
    int last = IntStream.range(0, 21).filter(i -> read[i] < NONE).max().orElseThrow();
    assertEquals(read[9], read[last], 0.11);
    assertTrue(last == 9 + count || last == 10 + count, "last " + last + " of count " + count);
  }

  @Test
  void hysteresis_picksUpNearerThanItLoses() {
    Recording in = TestWorlds.approach(4, 1, 3001);
    Recording out = TestWorlds.approach(1, 4, 3001);
    Effect effect = effect("hysteresis", "both ways", POST, in);
    double k = number(effect, "k");
    double[] coming = read(effect, in);
    double[] going = read(effect, out);
    int first = IntStream.range(0, 3001).filter(i -> coming[i] < NONE).findFirst().orElseThrow();
    int last = IntStream.range(0, 3001).filter(i -> going[i] < NONE).max().orElseThrow();
    assertEquals(3 * (1 - k / 2), 4 - 0.001 * first, 0.005);
    assertEquals(3 * (1 + k / 2), 1 + 0.001 * last, 0.005);
  }

  @Test
  void attenuation_solvesTheSonarEquation() {
    for (double threshold : new double[] {0.2, 1, 3.2}) {
      for (double dbPerM : new double[] {0.3, 1.5, 6}) {
        double r = EnergyForms.attenuatedM(threshold, dbPerM);
        assertEquals(0, 40 * Math.log10(r / threshold) + 2 * dbPerM * r, 1e-6);
      }
    }
    assertEquals(0, EnergyForms.attenuatedM(0, 1));
  }

  /** A wall along z through the origin, facing -x: seen from -2 m its foot is 2 m away. */
  @Test
  void plane_answersFromItsFootWhenSeenSquarely() {
    Pose face = new Pose(0, 0, Math.PI);
    assertEquals(2, ObjectForms.planeM(face, 0.5, 0.2, new Pose(-2, 0.3, 0)), 1e-12);
    assertEquals(2, ObjectForms.planeM(face, 0.5, 0.2, new Pose(-2, 0.3, 0.19)), 1e-12);
    assertEquals(NONE, ObjectForms.planeM(face, 0.5, 0.2, new Pose(-2, 0.3, 0.21)));
    assertEquals(NONE, ObjectForms.planeM(face, 0.5, 0.2, new Pose(-2, 0.6, 0)));
    assertEquals(NONE, ObjectForms.planeM(face, 0.5, 0.2, new Pose(2, 0, Math.PI)));
  }

  @Test
  void beamTapers_reachTheSameEdge() {
    Recording rows =
        new Recording(
            List.of(
                new simbad.blindworld.world.Row("r", "s", 0, new Pose(-1, 0, 0)),
                new simbad.blindworld.world.Row("r", "s", 1, new Pose(-1, 0, 0))));
    for (String form : Vocabulary.forms("beam-pattern")) {
      Effect effect = effect("beam-pattern", form, POST, rows);
      var hearing = effect.change().hearing(rows, rows.tracks().get(0), 0);
      double edge = threshold(hearing, SURE.halfAngleRad());
      assertEquals(number(effect, "at_edge"), edge, 1e-6, form);
      assertEquals(1, threshold(hearing, 0), 1e-9, form);
      assertEquals(edge, threshold(hearing, -SURE.halfAngleRad()), 1e-12, form);
      assertTrue(threshold(hearing, SURE.halfAngleRad() / 2) >= edge, form);
    }
  }

  private static double threshold(simbad.blindworld.world.Hearing hearing, double offAxisRad) {
    // No taper looks at the ping: any will do.
    var sight = new simbad.blindworld.world.Sight(0, 1, 0, 1, offAxisRad, 1);
    return hearing.thresholdM(1, sight, simbad.blindworld.world.AnyPing.FIRST);
  }
}
