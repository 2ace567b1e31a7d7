package simbad.gap;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.gap.audit.Audit;
import simbad.gap.audit.AuditCheck;
import simbad.gap.audit.AuditFinding;
import simbad.gap.audit.Severity;
import simbad.gap.diagnosis.DataSet;
import simbad.gap.diagnosis.Diagnosis;
import simbad.gap.diagnosis.EffectFinding;
import simbad.gap.diagnosis.Remedies;
import simbad.gap.diagnosis.Verdict;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.Worlds;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Pose;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SetupDetails;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.Reading;
import simbad.sonar.sensing.ReadingRow;

/** A sensor on a servo, 80 cm before a post, that reads three times at every second degree. */
class SweepTest {
  private static final int READ = 3;

  /** Headings are known to a degree. */
  private static final SensingSetup SERVO =
      Worlds.POST.with(
          new SetupDetails(0, Math.toRadians(1), Map.of(), Optional.empty(), List.of()));

  private static List<ReadingRow> sweep(Hypothesis truth) {
    List<ReadingRow> poses = new ArrayList<>();
    for (int degrees = 10; degrees <= 170; degrees += 2) {
      for (int i = 0; i < READ; i++) {
        double time = 0.1 * poses.size();
        Pose pose = Pose.of(0, 0.8, Math.toRadians(degrees));
        poses.add(new ReadingRow("sweep", "s", time, pose, NoEcho.NO_ECHO));
      }
    }
    return Worlds.read(poses, truth, 2);
  }

  private static Diagnosis diagnosis(Hypothesis truth) {
    return diagnosis(Worlds.POST, sweep(truth));
  }

  private static Diagnosis diagnosis(SensingSetup said, List<ReadingRow> rows) {
    return new Diagnoser(1, Set.of())
        .diagnose(new DataSet("sweep", said, rows, List.of()), Audit.of(said, rows));
  }

  @Test
  void clean_isNone() {
    Diagnosis diagnosis = diagnosis(Hypothesis.NONE);
    assertEquals(Verdict.NONE, diagnosis.verdict(), diagnosis.reason());
  }

  /** The servo's middle is off by 8 degrees: that, or the post stands aside. */
  @Test
  void servoThatIsTurned_isTiedWithThePostsPlace() {
    Diagnosis diagnosis =
        diagnosis(SERVO, sweep(Worlds.effect(Effect.BEAM_MISALIGNMENT, "all", 8)));
    assertEquals(Verdict.EXPLAINED, diagnosis.verdict(), diagnosis.reason());
    EffectFinding named = diagnosis.effects().get(0);
    Set<Effect> both = new TreeSet<>(named.indistinguishableFrom());
    both.add(named.effect());
    assertEquals(Set.of(Effect.BEAM_MISALIGNMENT, Effect.OBSTACLE_OFFSET), both);
    List<EffectFinding> toActUpon = Remedies.toActUpon(diagnosis);
    assertEquals(both, toActUpon.stream().map(EffectFinding::effect).collect(Collectors.toSet()));
    assertEquals(diagnosis.explanation(), List.of(toActUpon.get(0).effect()));
    for (EffectFinding one : toActUpon) {
      String todo = Remedies.of(one, SERVO.sensor());
      assertTrue(todo.matches("(move the obstacle|turn the sensor [5-9]\\.).*"), todo);
    }
  }

  /**
   * The post stands aside, and one ping in forty hears a stranger: the post is named all the same.
   */
  @Test
  void postAside_isNamedBesideStrangeEchoes() {
    Random random = new Random(3);
    List<ReadingRow> rows = new ArrayList<>();
    for (ReadingRow row : sweep(Worlds.effect(Effect.OBSTACLE_OFFSET, "all", 0.15, 0))) {
      Reading read = random.nextInt(40) > 0 ? row.reading() : new Echo(1 + random.nextDouble());
      rows.add(
          new ReadingRow(
              row.run(), row.sensor(), row.timeS(), row.pose(), read, row.circumstances()));
    }
    Diagnosis diagnosis = diagnosis(Worlds.POST, rows);
    assertTrue(diagnosis.verdict().namesEffects(), diagnosis.verdict() + " " + diagnosis.reason());
    Effect first = diagnosis.effects().get(0).effect();
    assertTrue(
        Set.of(Effect.BEAM_MISALIGNMENT, Effect.OBSTACLE_OFFSET).contains(first), first.word());
  }

  /**
   * A cone that is wider by 2 degrees than believed is no effect where headings may be so far off.
   */
  @Test
  void edgeOfTheCone_isLeftOut_whereAServoTurns() {
    List<ReadingRow> rows = sweep(Worlds.effect(Effect.BEAM_WIDTH, "cone", 1.5));
    Diagnosis exact = diagnosis(Worlds.POST, rows);
    Diagnosis diagnosis = diagnosis(SERVO, rows);
    assertNotEquals(Verdict.NONE, exact.verdict());
    assertEquals(Verdict.NONE, diagnosis.verdict(), diagnosis.reason());
    assertEquals(
        List.of(AuditCheck.EDGE), diagnosis.audit().stream().map(AuditFinding::check).toList());
  }

  /** Twice at every third degree; each angle is off by a degree more. */
  private static List<ReadingRow> scattered(Hypothesis truth, long seed) {
    Random random = new Random(seed);
    List<ReadingRow> written = new ArrayList<>();
    List<ReadingRow> real = new ArrayList<>();
    for (int degrees = 0; degrees <= 180; degrees += 3) {
      double off = random.nextGaussian();
      for (int i = 0; i < 2; i++) {
        double time = 0.1 * written.size();
        Pose pose = Pose.of(0, 0.8, Math.toRadians(degrees));
        written.add(new ReadingRow("sweep", "s", time, pose, NoEcho.NO_ECHO));
        real.add(
            new ReadingRow(
                "sweep",
                "s",
                time,
                Pose.of(0, 0.8, Math.toRadians(degrees + off)),
                NoEcho.NO_ECHO));
      }
    }
    List<ReadingRow> rows = new ArrayList<>();
    for (ReadingRow row : Worlds.read(real, truth, seed)) {
      rows.add(row.at(written.get(rows.size()).pose(), row.circumstances()));
    }
    return rows;
  }

  private static void assertTurned(Diagnosis diagnosis, Set<Effect> others) {
    assertEquals(Verdict.EXPLAINED, diagnosis.verdict(), diagnosis.reason());
    Set<Effect> named = new TreeSet<>(diagnosis.explanation());
    assertTrue(named.removeAll(others) || others.isEmpty(), named.toString());
    assertEquals(1, named.size(), named.toString());
    assertTrue(
        Set.of(Effect.BEAM_MISALIGNMENT, Effect.OBSTACLE_OFFSET).containsAll(named),
        named.toString());
  }

  /** What a border at such angles decides does not outweigh all other readings. */
  @Test
  void turnedServo_isFound_whereItsAnglesScatter() {
    Hypothesis turned = Worlds.effect(Effect.BEAM_MISALIGNMENT, "all", 10);
    assertTurned(diagnosis(SERVO, scattered(turned, 3)), Set.of());
  }

  /** No object beside the post; and no cone that is as wide as all of the arc. */
  @Test
  void turnedServoWithAWiderCone_isFoundAsBoth() {
    Form wider = Forms.find(Effect.BEAM_WIDTH, "cone", Worlds.POST, List.of("s")).orElseThrow();
    Hypothesis truth = Worlds.effect(Effect.BEAM_MISALIGNMENT, "all", -20).and(wider, 12);
    assertTurned(diagnosis(SERVO, scattered(truth, 2)), Set.of(Effect.BEAM_WIDTH));
  }

  /** Angles that count from the other end put the post where it is not: said, and not refused. */
  @Test
  void anglesTheOtherWayRound_areSuspected() {
    List<ReadingRow> rows = new ArrayList<>();
    for (ReadingRow row : sweep(Worlds.effect(Effect.OBSTACLE_OFFSET, "all", 0.4, 0))) {
      Pose pose = Pose.of(0, 0, Math.PI - row.pose().heading().radians());
      rows.add(row.at(pose, row.circumstances()));
    }
    SensingSetup believed =
        new SensingSetup(
            Worlds.POST.sensor(),
            new Scene(
                List.of(Worlds.POST.scene().obstacles().get(0).with(new Placement(0.4, -0.8, 0)))),
            Worlds.POST.noEchoM());
    AuditFinding axes =
        Audit.of(believed, rows).stream()
            .filter(one -> one.check() == AuditCheck.AXES)
            .findFirst()
            .orElseThrow();
    assertEquals(Severity.NOTE, axes.severity());
    assertTrue(axes.what().contains("perhaps headings turn clockwise"), axes.what());
  }

  /** A post that stands 15 cm further is no air of 100 degrees, and no sensor under a table. */
  @Test
  void postThatStandsFurther_isNoFaultOfTheRange() {
    Diagnosis diagnosis = diagnosis(Worlds.effect(Effect.OBSTACLE_OFFSET, "all", 0, -0.15));
    assertTrue(diagnosis.reason().contains("obstacle-offset"), diagnosis.reason());
    List<Effect> named = diagnosis.verdict().namesEffects() ? diagnosis.explanation() : List.of();
    for (Effect effect : List.of(Effect.SOUND_SPEED, Effect.RANGE_OFFSET, Effect.VERTICAL_BEAM)) {
      assertFalse(named.contains(effect), diagnosis.verdict() + " " + named);
    }
  }

  /** The post stands 30 degrees to the other side: it is not that the sensor stops listening. */
  @Test
  void postOnTheOtherSide_isNoTimeOut() {
    double aside = 0.8 * Math.tan(Math.toRadians(30));
    Diagnosis diagnosis = diagnosis(Worlds.effect(Effect.OBSTACLE_OFFSET, "all", aside, 0));
    List<Effect> named = diagnosis.verdict().namesEffects() ? diagnosis.explanation() : List.of();
    assertFalse(named.contains(Effect.EARLY_TIMEOUT), diagnosis.verdict() + " " + named);
    assertFalse(named.contains(Effect.DEAD_ZONE), diagnosis.verdict() + " " + named);
  }
}
