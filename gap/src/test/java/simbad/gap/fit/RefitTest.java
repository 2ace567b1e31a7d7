package simbad.gap.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.gap.fixture.Worlds;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.frame.Placement;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.ReadingRow;

/** What is fitted again to some of the pings knows nothing of the others. */
class RefitTest {
  private static final int ROWS = 2000;

  private static Form table() {
    return Forms.all(Worlds.POST, List.of("s")).stream()
        .filter(form -> form.effect() == Effect.ORIENTATION_SHADOW)
        .findFirst()
        .orElseThrow();
  }

  /** Heard from half as far on one side. */
  private static Hypothesis lopsided() {
    double[] table = new double[Forms.TABLE_SIZE];
    Arrays.setAll(table, i -> i < table.length / 2 ? 0.75 : 1.5);
    return Hypothesis.NONE.and(table(), table);
  }

  private static CalibratedLog drawn(Hypothesis truth) {
    return Worlds.given(Worlds.read(Worlds.poses(ROWS, 0.3, 2.2, 21), truth, 22));
  }

  @Test
  void table_isReadOffThePingsThatCount() {
    CalibratedLog given = drawn(lopsided());
    Fold first = ping -> ping % 2 == 0;
    Hypothesis fitted = new Refit(given, first).of(lopsided(), 15);
    double[] table = fitted.values();
    double near = Arrays.stream(table, 4, 32).average().orElseThrow();
    double far = Arrays.stream(table, 40, 68).average().orElseThrow();
    assertEquals(0.75, near, 0.08);
    assertEquals(1.5, far, 0.08);
  }

  /** With no ping on one side nothing can be known of it, whatever the start says. */
  @Test
  void table_doesNotKeepWhatOtherPingsTold() {
    List<ReadingRow> rows = Worlds.read(Worlds.poses(ROWS, 0.3, 2.2, 23), lopsided(), 24);
    CalibratedLog given = Worlds.given(rows);
    LogClues clues = new LogClues(given, Hypothesis.NONE);
    Fold farSide = ping -> clues.geometry.bearingRad(ping) > Math.PI;
    Hypothesis fitted = new Refit(given, farSide).of(lopsided(), 15);
    double unseen = Arrays.stream(fitted.values(), 10, 26).average().orElseThrow();
    assertTrue(unseen > 1.2, "mean of the side that was not seen is " + unseen);
  }

  @Test
  void valuesBesideATable_areFittedAsWell() {
    Hypothesis noisy = Worlds.effect(Effect.RANGE_OFFSET, "constant", 0.06);
    Hypothesis truth = lopsided().and(noisy.forms().get(0), noisy.values());
    CalibratedLog given = drawn(truth);
    Hypothesis start = lopsided().and(noisy.forms().get(0), 0.02);
    Hypothesis fitted = new Refit(given, Fold.ALL).of(start, 20);
    assertEquals(0.06, fitted.valuesOf(fitted.effects().indexOf(Effect.RANGE_OFFSET))[0], 0.003);
    assertFalse(fitted.equals(start));
  }

  /** What another effect silences tells nothing of thresholds. */
  @Test
  void table_isReadOffBesideWhatSilencesNearEchoes() {
    Hypothesis deaf = Worlds.effect(Effect.DEAD_ZONE, "sharp", 0.9);
    Hypothesis truth = deaf.and(table(), lopsided().values());
    List<ReadingRow> rows = Worlds.read(Worlds.poses(ROWS, 0.3, 2.2, 25), truth, 26);
    LogClues clues = new LogClues(Worlds.given(rows), deaf);
    double[] table = TableSearch.tables(clues, 0);
    double far = Arrays.stream(table, 40, 68).average().orElseThrow();
    assertEquals(1.5, far, 0.08);
  }

  /** Two posts 12 cm apart: where one is silent the other may answer for it. */
  @Test
  void tables_ofObstaclesSideBySide_areToldApart() {
    Obstacle post = Worlds.POST.scene().obstacles().get(0);
    Obstacle beside =
        new Obstacle("beside", new Placement(0.12, 0, 0), post.outline(), post.detection());
    SensingSetup two =
        new SensingSetup(
            Worlds.POST.sensor(), new Scene(List.of(post, beside)), Worlds.POST.noEchoM());
    Form form = Forms.find(Effect.ORIENTATION_SHADOW, "tables#0,1", two, List.of("s")).get();
    double[] truth = new double[2 * Forms.TABLE_SIZE];
    Arrays.fill(truth, 0, Forms.TABLE_SIZE, 0.8);
    Arrays.fill(truth, Forms.TABLE_SIZE, truth.length, 1.4);
    Hypothesis shadows = Hypothesis.NONE.and(form, truth);
    List<ReadingRow> rows = Worlds.read(two, Worlds.poses(4000, 0.3, 2.2, 27), shadows, 28);
    CalibratedLog given = new CalibratedLog(two, List.of(), new PingLog(rows));
    double[] found = TableSearch.tables(new LogClues(given, Hypothesis.NONE), 0, 1);
    assertEquals(0.8, Arrays.stream(found, 0, Forms.TABLE_SIZE).average().orElseThrow(), 0.08);
    double other = Arrays.stream(found, Forms.TABLE_SIZE, truth.length).average().orElseThrow();
    assertEquals(1.4, other, 0.08);
    Fitter fitter = new Fitter(given, Fold.ALL);
    double read = fitter.logLikelihood(Hypothesis.NONE.and(form, found));
    assertTrue(read > fitter.logLikelihood(shadows) - 5, "read off " + read);
  }
}
