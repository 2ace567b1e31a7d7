package simbad.gap;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.gap.audit.Audit;
import simbad.gap.audit.AuditCheck;
import simbad.gap.audit.AuditFinding;
import simbad.gap.diagnosis.DataSet;
import simbad.gap.diagnosis.Diagnosis;
import simbad.gap.diagnosis.Verdict;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.Worlds;
import simbad.sonar.frame.Pose;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SetupDetails;
import simbad.sonar.sensing.ReadingRow;

/**
 * A hand puts the sensor here and there before a post and reads it eight times. Many a place is
 * where the post just enters the cone, or is just heard: there all eight readings are other ones.
 */
class MisplacedTest {
  private static final int PLACES = 90;
  private static final int TIMES = 8;

  private static Pose moved(Pose pose, double deviationM, Random random) {
    return Pose.of(
        pose.position().xM() + deviationM * random.nextGaussian(),
        pose.position().zM() + deviationM * random.nextGaussian(),
        pose.heading().radians());
  }

  private static List<ReadingRow> read(double deviationM, Hypothesis truth) {
    Random random = new Random(5);
    List<ReadingRow> places = new ArrayList<>();
    List<ReadingRow> believed = new ArrayList<>();
    for (ReadingRow row : Worlds.poses(PLACES, 0.4, 1.8, 3)) {
      double aside = Math.toRadians(52) * (random.nextDouble() - 0.5);
      Pose pose =
          Pose.of(
              row.pose().position().xM(),
              row.pose().position().zM(),
              row.pose().heading().radians() + aside);
      Pose real = moved(pose, deviationM, random);
      for (int i = 0; i < TIMES; i++) {
        double timeS = 30 * places.size() + 0.1 * i;
        places.add(new ReadingRow("hand", "s", timeS, real, row.reading()));
        believed.add(new ReadingRow("hand", "s", timeS, pose, row.reading()));
      }
    }
    List<ReadingRow> read = Worlds.read(places, truth, 4);
    List<ReadingRow> written = new ArrayList<>();
    for (int i = 0; i < read.size(); i++) {
      written.add(believed.get(i).reading(read.get(i).reading()));
    }
    return written;
  }

  private static Diagnosis diagnosis(SensingSetup setup, List<ReadingRow> rows) {
    return new Diagnoser(1, Set.of())
        .diagnose(new DataSet("hand", setup, rows, List.of()), Audit.of(setup, rows));
  }

  private static List<AuditFinding> edges(Diagnosis diagnosis) {
    return diagnosis.audit().stream()
        .filter(finding -> finding.check() == AuditCheck.EDGE)
        .toList();
  }

  /**
   * It was "unexplained": no scatter of ranges makes eight readings of a post that is not there.
   */
  @Test
  void placesThatAreOff_areNamed() {
    List<ReadingRow> rows = read(0.025, Hypothesis.NONE);
    Diagnosis diagnosis = diagnosis(Worlds.POST, rows);
    assertEquals(Verdict.EXPLAINED, diagnosis.verdict(), diagnosis.reason());
    assertEquals(List.of(Effect.PLACEMENT_ERROR), diagnosis.explanation());
    assertEquals(
        0.025, diagnosis.effects().get(0).parameters().get(0).value(), 0.008, "standard deviation");
    AuditFinding left = edges(diagnosis).get(0);
    assertTrue(left.rows().size() > 80 && left.rows().size() < rows.size() / 2, left.what());
    assertTrue(
        left.what().startsWith(left.rows().size() + " readings where a placement"), left.what());
    assertEquals(0, left.rows().size() % TIMES, "placements as a whole");
  }

  @Test
  void placesThatAreExact_areNone() {
    Diagnosis diagnosis = diagnosis(Worlds.POST, read(0, Hypothesis.NONE));
    assertEquals(Verdict.NONE, diagnosis.verdict(), diagnosis.reason());
    assertEquals(List.of(), edges(diagnosis));
  }

  /** What is at work besides is named as well. */
  @Test
  void offsetBesideThem_isNamed() {
    Diagnosis diagnosis =
        diagnosis(Worlds.POST, read(0.02, Worlds.effect(Effect.RANGE_OFFSET, "constant", 0.08)));
    assertEquals(Verdict.EXPLAINED, diagnosis.verdict(), diagnosis.reason());
    assertEquals(
        Set.of(Effect.PLACEMENT_ERROR, Effect.RANGE_OFFSET), Set.copyOf(diagnosis.explanation()));
  }

  /** Where the scene says how far they are off, these rows are left out from the start. */
  @Test
  void placesThatAreStated_areLeftOutAtOnce() {
    SensingSetup said =
        Worlds.POST.with(new SetupDetails(0.025, 0, Map.of(), Optional.empty(), List.of()));
    Diagnosis diagnosis = diagnosis(said, read(0.025, Hypothesis.NONE));
    assertEquals(1, edges(diagnosis).size());
    assertTrue(diagnosis.verdict() != Verdict.UNEXPLAINED, diagnosis.reason());
  }
}
