package simbad.gap.calibrate.level;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.gap.fixture.LevelWorlds;
import simbad.sonar.catalogue.LevelForms;
import simbad.sonar.scene.SonarSpec;

/** Chances of echoes, and the rate of misses that trials of known strength show. */
class MissesTest {
  private static final double EXACT = 1e-9;
  private static final double RATE = 0.02;
  private static final SonarSpec SENSOR = LevelWorlds.POST.sensor();
  private static final List<Believed> TARGETS =
      List.of(new Believed(LevelWorlds.POST.scene().obstacles().get(0), SENSOR));
  private static final Layout LAYOUT = new Layout(TARGETS);

  private static Predictor predictor(double levelDb) {
    Predictor predictor =
        new Predictor(LAYOUT, SENSOR.levelLaw(), TARGETS, LevelForms.wavenumberPerM(SENSOR));
    double[] values = new double[LAYOUT.size()];
    values[0] = 1.5;
    values[LAYOUT.aperture()] = Math.log(LevelForms.APERTURE_M);
    values[Layout.LEVEL] = levelDb;
    predictor.set(values);
    return predictor;
  }

  /** The rate after some trials of one level, each with a share that effects leave. */
  private static double rate(double believed, double levelDb, int read, int silent, double share) {
    Predictor predictor = predictor(levelDb);
    List<Predictor.Row> rows = new ArrayList<>();
    for (int i = 0; i < read + silent; i++) {
      rows.add(predictor.row(new Trials.Trial(i, 0, 1, 1.2, 1.1, 0, i < read, 0, share, 0)));
    }
    Misses misses = new Misses(believed);
    misses.update(predictor, rows);
    return misses.rate();
  }

  /** Strangers are heard twice in a thousand whatever the level is, and as many miss the rule. */
  @Test
  void betweenStrangersAndMissesAChanceIsNormal() {
    Misses misses = new Misses(RATE);

    assertEquals(0.002, misses.chance(-40, 1), EXACT);
    assertEquals(0.002 + 0.98 * 0.996, misses.chance(40, 1), EXACT);
    assertEquals(0.002 + 0.98 * 0.996 / 2, misses.chance(0, 1), EXACT);
    assertEquals(0.002 + 0.3 * 0.98 * 0.996 / 2, misses.chance(0, 0.3), EXACT);
    // The normal distribution at one deviation.
    assertEquals(0.002 + 0.98 * 0.996 * 0.841344746, misses.chance(1, 1), 1e-8);
  }

  @Test
  void theSlopeIsThatOfTheChance() {
    Misses misses = new Misses(0.1);
    double step = 1e-5;
    for (double at : new double[] {-2, -0.5, 0, 1.3}) {
      double rise = (misses.chance(at + step, 0.7) - misses.chance(at - step, 0.7)) / (2 * step);
      assertEquals(rise, misses.slope(at, 0.7), 1e-8);
    }
  }

  /** The belief is worth 50 trials: 1 miss in 50, and 50 more that were read. */
  @Test
  void whatIsReadMakesMissesRarer() {
    assertEquals(RATE, rate(RATE, 200, 0, 0, 1), EXACT);
    assertEquals(1.0 / 100, rate(RATE, 200, 50, 0, 1), EXACT);
  }

  /** Strong and silent: a miss but for strangers, 0.02 of 0.022. */
  @Test
  void strongSilenceIsAMiss() {
    double share = 10 / 11.0;

    assertEquals((1 + 6 * share) / (50 + 6 * share), rate(RATE, 200, 0, 6, 1), EXACT);
  }

  /** What is too weak, or what an effect takes away, has missed nothing. */
  @Test
  void silenceThatIsExplainedIsNoMiss() {
    assertEquals(RATE, rate(RATE, -200, 0, 6, 1), EXACT);
    assertEquals(RATE, rate(RATE, 200, 0, 6, 0), EXACT);
  }

  /** Half heard: silent by 1 - 0.98 / 2, of which a miss is 0.02 / 2. */
  @Test
  void halfTheStrengthIsHalfAMiss() {
    double silent = 0.51;
    double missed = 0.01 / silent * silent / (silent + 0.002);

    assertEquals((1 + missed) / (50 + missed), rate(RATE, 200, 0, 1, 0.5), EXACT);
  }

  /** A sensor that never misses cannot have been silent. */
  @Test
  void aRateOfNothingStaysNothing() {
    assertEquals(0, rate(0, 200, 3, 3, 1), 0);
  }

  /** Rates follow one another: what was found is what counts in the next round. */
  @Test
  void theChanceFollowsTheRate() {
    Predictor predictor = predictor(200);
    Misses misses = new Misses(RATE);
    List<Predictor.Row> read = new ArrayList<>();
    for (int i = 0; i < 50; i++) {
      read.add(predictor.row(new Trials.Trial(i, 0, 1, 1.2, 1.1, 0, true, 0, 1, 0)));
    }
    misses.update(predictor, read);

    assertEquals(0.002 + 0.99 * 0.996, misses.chance(40, 1), EXACT);
  }
}
