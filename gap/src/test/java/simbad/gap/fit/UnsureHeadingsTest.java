package simbad.gap.fit;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.gap.fixture.Worlds;
import simbad.sonar.frame.Pose;
import simbad.sonar.model.ReadingDistribution;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SetupDetails;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;

/** A servo looks past a post from 80 cm; the cone's border is at some 24 degrees. */
class UnsureHeadingsTest {
  private static final double SIGMA = Math.toRadians(1.5);
  private static final Hypothesis TURNED = Worlds.effect(Effect.BEAM_MISALIGNMENT, "all", 4);

  /** The roots of He5 and their weights, from their closed forms. */
  private static final double INNER = Math.sqrt(5 - Math.sqrt(10));

  private static final double OUTER = Math.sqrt(5 + Math.sqrt(10));

  private static SensingSetup known(double sigmaRad) {
    return Worlds.POST.with(new SetupDetails(0, sigmaRad, Map.of(), Optional.empty(), List.of()));
  }

  private static List<ReadingRow> scan(double turnRad, double secondX) {
    List<ReadingRow> poses = new ArrayList<>();
    for (int degrees = 50; degrees <= 130; degrees++) {
      Pose pose = Pose.of(degrees % 2 * secondX, 0.8, Math.toRadians(degrees) + turnRad);
      poses.add(new ReadingRow("r", "s", 0.1 * poses.size(), pose, NoEcho.NO_ECHO));
    }
    return poses;
  }

  /** Readings of a post in front, seen from headings that differ from those written. */
  private static double[] logLikelihood(
      double sigmaRad, Hypothesis hypothesis, double turnRad, double secondX) {
    return given(sigmaRad, turnRad, secondX).logLikelihood(hypothesis);
  }

  @Test
  void likelihood_isTheMeanOverHeadings() {
    double inner = (7 + 2 * Math.sqrt(10)) / 60;
    double outer = (7 - 2 * Math.sqrt(10)) / 60;
    double[] at = {-OUTER, -INNER, 0, INNER, OUTER};
    double[] weight = {outer, inner, 8.0 / 15, inner, outer};
    for (Hypothesis hypothesis : List.of(Hypothesis.NONE, TURNED)) {
      double[] mean = new double[81];
      for (int k = 0; k < at.length; k++) {
        double[] exact = logLikelihood(0, hypothesis, at[k] * SIGMA, 0);
        for (int i = 0; i < mean.length; i++) {
          mean[i] += weight[k] * Math.exp(exact[i]);
        }
      }
      double[] found = logLikelihood(SIGMA, hypothesis, 0, 0);
      // Where all of them see nearly the same, that of the heading as written stands for all.
      double[] straight = logLikelihood(0, hypothesis, 0, 0);
      int averaged = 0;
      for (int i = 0; i < mean.length; i++) {
        if (found[i] != straight[i]) {
          averaged++;
          assertEquals(mean[i], Math.exp(found[i]), 0.1 * mean[i]);
        }
      }
      assertTrue(averaged >= 6, hypothesis + ": " + averaged);
    }
  }

  /** Whether there is an echo at all, by itself, and what is forecast, are means as well. */
  @Test
  void echoesAndForecasts_areMeansOverHeadings() {
    double inner = (7 + 2 * Math.sqrt(10)) / 60;
    double outer = (7 - 2 * Math.sqrt(10)) / 60;
    double[] at = {-OUTER, -INNER, 0, INNER, OUTER};
    double[] weight = {outer, inner, 8.0 / 15, inner, outer};
    double[] echo = new double[81];
    double[] silent = new double[81];
    for (int k = 0; k < at.length; k++) {
      List<ReadingDistribution> exact = forecast(0, at[k] * SIGMA);
      for (int i = 0; i < 81; i++) {
        silent[i] += weight[k] * exact.get(i).noEchoProbability();
        echo[i] += weight[k] * (1 - exact.get(i).noEchoProbability());
      }
    }
    List<ReadingDistribution> straight = forecast(0, 0);
    List<ReadingDistribution> found = forecast(SIGMA, 0);
    CalibratedLog given = given(SIGMA, 0, 0);
    // Where it is heard counts for nothing here.
    double[] heard = given.divided(1, 1e12).logLikelihood(Hypothesis.NONE);
    int averaged = 0;
    for (int i = 0; i < 81; i++) {
      double own = found.get(i).noEchoProbability();
      boolean isMean = Math.abs(own - straight.get(i).noEchoProbability()) > 1e-9;
      averaged += isMean ? 1 : 0;
      assertEquals(isMean ? silent[i] : straight.get(i).noEchoProbability(), own, 1e-9);
      if (isMean && given.log().echo(i)) {
        assertEquals(Math.log(0.999 * echo[i] + 1e-3 * 0.7), heard[i], 1e-6);
      }
    }
    assertTrue(averaged >= 6, averaged + " of 81");
  }

  private static CalibratedLog given(double sigmaRad, double turnRad, double secondX) {
    List<ReadingRow> read = Worlds.read(scan(0, secondX), Hypothesis.NONE, 5);
    List<ReadingRow> poses = scan(turnRad, secondX);
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < read.size(); i++) {
      rows.add(read.get(i).at(poses.get(i).pose(), read.get(i).circumstances()));
    }
    return new CalibratedLog(known(sigmaRad), List.of(), new PingLog(rows));
  }

  private static List<ReadingDistribution> forecast(double sigmaRad, double turnRad) {
    CalibratedLog given = given(sigmaRad, turnRad, 0);
    return given.forecast(given.model(Hypothesis.NONE));
  }

  /** Two degrees beyond the border cost a little, twelve what they cost before. */
  @Test
  void headingsThatAreAsFarOffAsTheyMay_costLittle() {
    double exact = sum(logLikelihood(0, Worlds.effect(Effect.BEAM_MISALIGNMENT, "all", 2), 0, 0));
    double unsure =
        sum(logLikelihood(SIGMA, Worlds.effect(Effect.BEAM_MISALIGNMENT, "all", 2), 0, 0));
    double right = sum(logLikelihood(SIGMA, Hypothesis.NONE, 0, 0));
    assertTrue(exact < right - 10, exact + " beside " + right);
    assertTrue(unsure > right - 8, unsure + " beside " + right);
    Hypothesis far = Worlds.effect(Effect.BEAM_MISALIGNMENT, "all", 12);
    assertTrue(sum(logLikelihood(SIGMA, far, 0, 0)) < right - 50);
  }

  /** A drive is taken at its headings; so is any log whose headings are exact. */
  @Test
  void drive_isTakenAtItsHeadings() {
    assertArrayEquals(logLikelihood(0, TURNED, 0, 0.01), logLikelihood(SIGMA, TURNED, 0, 0.01));
  }

  private static double sum(double... values) {
    return IntStream.range(0, values.length).mapToDouble(i -> values[i]).sum();
  }
}
