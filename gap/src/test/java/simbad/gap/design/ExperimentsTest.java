package simbad.gap.design;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.gap.diagnosis.NextExperiment;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.Worlds;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.sensing.ReadingRow;

class ExperimentsTest {
  /** One distance only, where 343/353 of 1 m and 2.8 cm less are the same to a step. */
  private static final List<ReadingRow> ONE_DISTANCE =
      Worlds.read(Worlds.poses(100, 1.05, 1.05, 3), Hypothesis.NONE, 4);

  private static final Hypothesis SPEED = Worlds.effect(Effect.SOUND_SPEED, "scale", 353);
  private static final Hypothesis OFFSET = Worlds.effect(Effect.RANGE_OFFSET, "constant", -0.028);

  private static double sum(double[] values) {
    return DoubleStream.of(values).sum();
  }

  private static double distanceM(ReadingRow row) {
    return Math.hypot(row.pose().position().xM(), row.pose().position().zM());
  }

  @Test
  void soundSpeedAndRangeOffset_comeApartOverDistances() {
    CalibratedLog given = Worlds.given(ONE_DISTANCE);
    NextExperiment next = Experiments.separate(given, SPEED, OFFSET).orElseThrow();
    assertEquals(List.of(Effect.SOUND_SPEED, Effect.RANGE_OFFSET), next.separates());
    assertTrue(next.poses().size() <= 150, () -> next.poses().size() + " poses");
    double nearest = next.poses().stream().mapToDouble(ExperimentsTest::distanceM).min().orElse(9);
    assertTrue(nearest < 0.5, () -> "nearest " + nearest);
    assertTrue(next.expectedLogOdds() > 20, next::toString);
  }

  /** The mean of the log odds over readings that each of the two draws is what was promised. */
  @Test
  void expectedLogOdds_areThoseOfReadingsThatAreDrawn() {
    NextExperiment next =
        Experiments.separate(Worlds.given(ONE_DISTANCE), SPEED, OFFSET).orElseThrow();
    double least = Math.min(odds(next, SPEED, OFFSET), odds(next, OFFSET, SPEED));
    assertEquals(1, least / next.expectedLogOdds(), 0.15);
  }

  private static double odds(NextExperiment next, Hypothesis truth, Hypothesis rival) {
    double[] odds = new double[20];
    for (int i = 0; i < odds.length; i++) {
      CalibratedLog drawn = Worlds.given(Worlds.read(next.poses(), truth, i));
      odds[i] = sum(drawn.logLikelihood(truth)) - sum(drawn.logLikelihood(rival));
    }
    return Arrays.stream(odds).average().orElseThrow();
  }

  @Test
  void poses_startAtTimeZero_andKeepTheUpdatePeriod() {
    List<ReadingRow> poses =
        Experiments.separate(Worlds.given(ONE_DISTANCE), SPEED, OFFSET).orElseThrow().poses();
    assertEquals(0, poses.get(0).timeS());
    for (int i = 1; i < poses.size(); i++) {
      ReadingRow before = poses.get(i - 1);
      boolean follows = before.run().equals(poses.get(i).run());
      double stepS = poses.get(i).timeS() - before.timeS();
      assertTrue(!follows || stepS >= 0.049, "row " + i + ": " + stepS);
    }
  }

  @Test
  void hypothesesThatPredictAlike_haveNoExperiment() {
    Hypothesis square = Worlds.effect(Effect.OBSTACLE_TURN, "all", 90);
    assertEquals(
        Optional.empty(),
        Experiments.separate(Worlds.given(ONE_DISTANCE), Hypothesis.NONE, square));
  }

  @Test
  void anEffectThatBothHave_isNotSeparated() {
    Hypothesis speed = SPEED.and(OFFSET.forms().get(0), 0.05);
    NextExperiment next =
        Experiments.separate(Worlds.given(ONE_DISTANCE), speed, OFFSET).orElseThrow();
    assertEquals(List.of(Effect.SOUND_SPEED), next.separates());
  }

  /** Only the transducer that is bent can tell whether it is. */
  @Test
  void whatOneTransducerDoes_isAskedOfIt() {
    List<ReadingRow> rows = new ArrayList<>();
    for (String sensor : List.of("left", "right")) {
      for (ReadingRow row : ONE_DISTANCE) {
        rows.add(new ReadingRow(row.run(), sensor, row.timeS(), row.pose(), row.reading()));
      }
    }
    Form bent =
        Forms.find(Effect.BEAM_MISALIGNMENT, "only:right", Worlds.POST, List.of("left", "right"))
            .orElseThrow();
    NextExperiment next =
        Experiments.separate(Worlds.given(rows), Hypothesis.NONE, Hypothesis.NONE.and(bent, 6))
            .orElseThrow();
    assertTrue(next.poses().stream().allMatch(row -> row.sensor().equals("right")));
  }
}
