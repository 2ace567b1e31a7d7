package simbad.gap.unexplained;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.gap.calibrate.Calibration;
import simbad.gap.calibrate.ModelError;
import simbad.gap.calibrate.SetupLeave;
import simbad.gap.calibrate.level.Leeway;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.LevelWorlds;
import simbad.gap.fixture.Worlds;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.ping.PingLog;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.Reading;
import simbad.sonar.sensing.ReadingRow;

/** What a reference leaves open of a level law, before logs of the same world. */
class LeewayTest {
  private static final Calibration CALIBRATION =
      Calibration.of(LevelWorlds.POST, new PingLog(LevelWorlds.log(1200, 31)));

  private static final Form GAIN =
      Forms.all(LevelWorlds.POST, List.of("s")).stream()
          .filter(form -> form.effect().equals(Effect.GAIN))
          .findFirst()
          .orElseThrow();
  private static final Hypothesis WEAK = LevelWorlds.truth().and(GAIN, -3);

  private static CalibratedLog given(List<ReadingRow> rows) {
    return CALIBRATION.given(LevelWorlds.POST, new PingLog(rows));
  }

  /** A step of readings that is off by some millimetres. */
  private static List<ReadingRow> longer(List<ReadingRow> rows, double metres) {
    List<ReadingRow> all = new ArrayList<>();
    for (ReadingRow row : rows) {
      Reading read =
          row.reading() instanceof Echo echo ? new Echo(echo.rangeM() + metres) : row.reading();
      all.add(new ReadingRow(row.run(), row.sensor(), row.timeS(), row.pose(), read));
    }
    return all;
  }

  private static double nats(int rows, double metres) {
    CalibratedLog given = given(longer(LevelWorlds.log(rows, 41), metres));
    return CALIBRATION.leewayNats(given, Hypothesis.NONE);
  }

  /** Each of some sixty values gains half a nat of chance. */
  @Test
  void readingsThatAreAsCalibratedGainLittle() {
    double least = nats(1000, 0);

    assertTrue(least >= 0 && least < 30, () -> "nats " + least);
  }

  /** A few millimetres are the set-up's, and more rows do not take that back. */
  @Test
  void aSmallShiftGainsNearlyAllThatAnOffsetWould() {
    List<ReadingRow> rows = longer(LevelWorlds.log(1000, 41), 0.003);
    CalibratedLog given = given(rows);
    double[] slope = SetupScores.perMetre(Hypothesis.NONE, given::logLikelihood);
    double score = 0;
    double information = 0;
    for (double one : slope) {
      score += one;
      information += one * one;
    }
    double free = score * score / information / 2;
    double moved = CALIBRATION.leewayNats(given, Hypothesis.NONE);

    assertTrue(moved > 0.6 * free, moved + " of " + free);
  }

  /** What a slice has in common by the set-up is no misfit; what it has beyond is one. */
  @Test
  void misfitsOfWhatIsLeftOpenAreSmaller() {
    CalibratedLog given = given(LevelWorlds.log(1500, 43));
    double plain = Misfit.of(given, Hypothesis.NONE).top(5);
    double open = Misfit.of(given, Hypothesis.NONE, CALIBRATION.leeway().orElseThrow()).top(5);
    CalibratedLog off = given(longer(LevelWorlds.log(1500, 43), 0.06));
    double far = Misfit.of(off, Hypothesis.NONE, CALIBRATION.leeway().orElseThrow()).top(5);

    assertTrue(open <= plain && open < 4, open + " of " + plain);
    assertTrue(far > 6, () -> "6 cm off: " + far);
  }

  /** What reads long near by is no scatter: the set-up may have read long there. */
  @Test
  void whatTheSetUpMayReadLongIsNoScatter() {
    List<ReadingRow> all = LevelWorlds.log(1500, 43);
    List<ReadingRow> near = longer(all, 0.02);
    near.replaceAll(row -> isNear(row) ? row : all.get(near.indexOf(row)));
    CalibratedLog given = given(near);
    double plain = scatter(Misfit.of(given, Hypothesis.NONE));
    double open = scatter(Misfit.of(given, Hypothesis.NONE, CALIBRATION.leeway().orElseThrow()));

    assertTrue(open < 0.7 * plain, open + " of " + plain);
  }

  private static boolean isNear(ReadingRow row) {
    return row.reading() instanceof Echo echo && echo.rangeM() < 0.8;
  }

  private static double scatter(Misfit misfit) {
    return misfit.slices().stream()
        .filter(slice -> slice.kind() == Misfit.Kind.SCATTER)
        .mapToDouble(slice -> Math.abs(slice.z()))
        .max()
        .orElse(0);
  }

  /** A reading that is nearly certain gains no more than it lacks, however steep it is. */
  @Test
  void nothingGainsMoreThanCertainty() {
    CalibratedLog given = given(LevelWorlds.log(400, 45));
    Leeway leeway = CALIBRATION.leeway().orElseThrow();
    Leeway.Pulls pulls =
        Openness.pulls(given.geometry(given.model(Hypothesis.NONE)), Hypothesis.NONE, leeway);
    double[] steep = new double[400];
    double[] lacks = new double[400];
    Arrays.fill(steep, 3000);
    Arrays.fill(lacks, 0.02);
    double bounded = leeway.rangeNats(pulls, steep, lacks);
    Arrays.fill(lacks, 4);

    assertTrue(bounded > 0.1 && bounded <= 400 * 0.02, () -> bounded + " nats");
    assertTrue(leeway.rangeNats(pulls, steep, lacks) > 4 * bounded);
  }

  /** Of a right law nothing is left from place to place but chance. */
  @Test
  void placesOfARightLawAreOffByLittle() {
    ModelError error = CALIBRATION.modelError().orElseThrow();

    assertTrue(error.excessDb() < 1, () -> error.excessDb() + " dB");
    assertTrue(error.rangeM() < 0.004, () -> error.rangeM() + " m");
  }

  @Test
  void thresholdsHaveNoLeeway() {
    CalibratedLog given = given(LevelWorlds.log(200, 44));

    assertEquals(0, Calibration.none().leewayNats(given, Hypothesis.NONE));
  }

  /** A post that answers 3 dB less is no matter of a set-up that is known to a decibel. */
  @Test
  void theSetUpDoesNotTakeUpAnEffect() {
    CalibratedLog given =
        given(Worlds.read(LevelWorlds.POST, LevelWorlds.poses(1000, 47), WEAK, 48));
    double still = logLikelihood(given, Hypothesis.NONE) + nats(given, Hypothesis.NONE);
    Hypothesis gain = Hypothesis.NONE.and(GAIN, -3);
    double right = logLikelihood(given, gain) + nats(given, gain);

    assertTrue(right > still + 20, right + " beside " + still);
  }

  /** Values that were fitted before a set-up that stood still move with it. */
  @Test
  void valuesMoveWithTheSetUp() {
    CalibratedLog given =
        given(Worlds.read(LevelWorlds.POST, LevelWorlds.poses(600, 49), WEAK, 50));
    SetupLeave leave = new SetupLeave(given, CALIBRATION);
    Hypothesis tooWeak = Hypothesis.NONE.and(GAIN, -4);
    double moved = leave.natsWithValues(tooWeak);
    double near =
        logLikelihood(given, Hypothesis.NONE.and(GAIN, -3)) - logLikelihood(given, tooWeak);

    assertTrue(moved > leave.nats(tooWeak) && moved > 0.8 * near, moved + " of " + near);
  }

  private static double nats(CalibratedLog given, Hypothesis set) {
    return new SetupLeave(given, CALIBRATION).nats(set);
  }

  private static double logLikelihood(CalibratedLog given, Hypothesis set) {
    return Arrays.stream(given.logLikelihood(set)).sum();
  }
}
