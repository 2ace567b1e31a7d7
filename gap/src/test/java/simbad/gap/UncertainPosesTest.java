package simbad.gap;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.gap.audit.Audit;
import simbad.gap.audit.AuditCheck;
import simbad.gap.audit.AuditFinding;
import simbad.gap.audit.UncertainPoses;
import simbad.gap.diagnosis.DataSet;
import simbad.gap.diagnosis.Diagnosis;
import simbad.gap.diagnosis.EffectFinding;
import simbad.gap.diagnosis.Verdict;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.Worlds;
import simbad.sonar.frame.Pose;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SetupDetails;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;

/** Drives whose poses are off by 3 mm and half a degree, as their scenes say. */
class UncertainPosesTest {
  private static final int ROWS = 700;
  private static final double SIGMA_M = 0.003;
  private static final double SIGMA_RAD = Math.toRadians(0.5);
  private static final SensingSetup SAID =
      Worlds.POST.with(new SetupDetails(SIGMA_M, SIGMA_RAD, Map.of(), Optional.empty(), List.of()));

  private static Pose turned(Pose pose, double byRad) {
    return Pose.of(pose.position().xM(), pose.position().zM(), pose.heading().radians() + byRad);
  }

  /** The sensor looks past the post by up to 35 degrees, so that its cone of 20 ends on it. */
  private static List<ReadingRow> drive(Hypothesis truth) {
    Random random = new Random(5);
    List<ReadingRow> poses = new ArrayList<>();
    for (ReadingRow row : Worlds.poses(ROWS, 0.4, 1.3, 3)) {
      Pose aside = turned(row.pose(), Math.toRadians(70) * (random.nextDouble() - 0.5));
      poses.add(row.at(aside, row.circumstances()));
    }
    return Worlds.read(poses, truth, 4).stream()
        .map(row -> row.at(believed(row.pose(), random), row.circumstances()))
        .toList();
  }

  private static Pose believed(Pose pose, Random random) {
    return Pose.of(
        pose.position().xM() + SIGMA_M * random.nextGaussian(),
        pose.position().zM() + SIGMA_M * random.nextGaussian(),
        pose.heading().radians() + SIGMA_RAD * random.nextGaussian());
  }

  private static Diagnosis diagnosis(List<ReadingRow> rows) {
    return new Diagnoser(1, Set.of())
        .diagnose(new DataSet("drive", SAID, rows, List.of()), Audit.of(SAID, rows));
  }

  private static List<AuditFinding> edges(SensingSetup setup, List<ReadingRow> rows) {
    return Audit.of(setup, rows).stream()
        .filter(finding -> finding.check() == AuditCheck.EDGE)
        .toList();
  }

  @Test
  void whereTheConeEnds_nobodyKnows_andOnlyThere() {
    List<ReadingRow> rows = drive(Hypothesis.NONE);
    AuditFinding found = edges(SAID, rows).get(0);
    assertTrue(found.rows().size() > 20 && found.rows().size() < ROWS / 5, found.what());
    assertFalse(found.refuses());
    for (int row : found.rows()) {
      Pose pose = rows.get(row).pose();
      double bearing = Math.atan2(pose.position().zM(), -pose.position().xM());
      double aside = Math.IEEEremainder(pose.heading().radians() - bearing, 2 * Math.PI);
      double half = Math.atan2(0.08, Math.hypot(pose.position().xM(), pose.position().zM()));
      // The border of the cone, give or take the post's own width and the deviation.
      double border = SAID.sensor().coneHalfAngleRad();
      assertEquals(border, Math.abs(aside), half + 3 * SIGMA_RAD, "row " + row);
    }
    assertEquals(List.of(), edges(Worlds.POST, rows), "poses that are exact");
  }

  /** Straight before the post, 1.5 m being the threshold: two deviations are 6 mm. */
  @Test
  void whereEchoesEnd_nobodyKnowsEither() {
    List<ReadingRow> rows = new ArrayList<>();
    for (int mm = 1480; mm <= 1520; mm++) {
      Pose pose = Pose.of(-mm / 1000.0, 0, 0);
      rows.add(new ReadingRow("r", "s", 0.05 * rows.size(), pose, NoEcho.NO_ECHO));
    }
    Set<Integer> unsure = UncertainPoses.rows(SAID, rows, List.of());
    List<Integer> wanted = IntStream.rangeClosed(14, 26).boxed().toList();
    assertTrue(unsure.containsAll(wanted.subList(1, wanted.size() - 1)), unsure.toString());
    assertTrue(wanted.containsAll(unsure), unsure.toString());
  }

  @Test
  void placements_areLeftOutAsAWhole() {
    List<ReadingRow> placed = new ArrayList<>();
    for (ReadingRow row : drive(Hypothesis.NONE).subList(0, 100)) {
      for (int i = 0; i < 4; i++) {
        placed.add(
            new ReadingRow(
                row.run(), row.sensor(), 4 * row.timeS() + 0.05 * i, row.pose(), row.reading()));
      }
    }
    List<Integer> rows = edges(SAID, placed).get(0).rows();
    assertTrue(rows.size() > 12 && rows.size() < placed.size() / 5, rows.toString());
    for (int row : rows) {
      int first = row / 4 * 4;
      assertTrue(rows.containsAll(List.of(first, first + 1, first + 2, first + 3)), row + "");
    }
  }

  @Test
  void driveInWhichNothingChanged_isNone() {
    Diagnosis diagnosis = diagnosis(drive(Hypothesis.NONE));
    assertEquals(Verdict.NONE, diagnosis.verdict(), diagnosis.reason());
  }

  /** A robot drives round the post, and a tracker tells where it was 0.3 s ago. */
  @Test
  void posesThatAreLate_areALatency() {
    List<ReadingRow> way = new ArrayList<>();
    for (int i = 0; i < ROWS; i++) {
      double time = 0.05 * i;
      double distance = 0.85 + 0.45 * Math.sin(0.9 * time);
      double bearing = 0.4 * time;
      double aside = 0.4 * Math.sin(1.7 * time);
      Pose pose =
          Pose.of(
              distance * Math.cos(bearing),
              -distance * Math.sin(bearing),
              bearing + Math.PI + aside);
      way.add(new ReadingRow("r", "s", time, pose, NoEcho.NO_ECHO));
    }
    List<ReadingRow> now = Worlds.read(way, Hypothesis.NONE, 4);
    List<ReadingRow> late = new ArrayList<>();
    for (int i = 6; i < ROWS; i++) {
      late.add(now.get(i).at(now.get(i - 6).pose(), now.get(i).circumstances()));
    }
    Diagnosis diagnosis =
        new Diagnoser(1, Set.of()).diagnose(new DataSet("drive", Worlds.POST, late, List.of()));
    assertTrue(diagnosis.verdict().namesEffects(), diagnosis.verdict() + " " + diagnosis.reason());
    EffectFinding first = diagnosis.effects().get(0);
    assertEquals(Effect.LATENCY, first.effect());
    assertEquals(Optional.of("poses"), first.form());
    assertEquals(0.3, first.parameters().get(0).value(), 0.02);
  }

  @Test
  void sensorThatIsTurned_isNamed() {
    Diagnosis diagnosis = diagnosis(drive(Worlds.effect(Effect.BEAM_MISALIGNMENT, "all", 6)));
    assertEquals(Verdict.EXPLAINED, diagnosis.verdict(), diagnosis.reason());
    assertEquals(List.of(Effect.BEAM_MISALIGNMENT), diagnosis.explanation());
  }
}
