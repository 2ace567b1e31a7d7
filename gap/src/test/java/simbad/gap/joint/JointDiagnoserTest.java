package simbad.gap.joint;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.gap.Diagnoser;
import simbad.gap.diagnosis.DataSet;
import simbad.gap.diagnosis.Diagnosis;
import simbad.gap.diagnosis.Verdict;
import simbad.motion.MotionRun;
import simbad.motion.effect.FittedMotion;
import simbad.motion.effect.MotionForm;
import simbad.motion.format.MotionData;

/** Robots that reckon their way from wheels, as a tracker sees them and as four sonars hear. */
class JointDiagnoserTest {
  private static final double LARGER = 1.05;

  private static JointDiagnosis diagnose(DataSet data, MotionData drive) {
    return new JointDiagnoser(data, drive).diagnose(new Diagnoser(1, Set.of()));
  }

  private static JointDiagnosis diagnose(JointWorld world) {
    world.drive();
    return diagnose(world.data(), world.motion());
  }

  private static JointWorld largeWheels(long seed) {
    JointWorld world = new JointWorld(seed);
    world.wheels = LARGER;
    return world;
  }

  private static void checkWheels(JointDiagnosis diagnosis, boolean tracked, boolean heard) {
    assertEquals(Verdict.EXPLAINED, diagnosis.verdict(), diagnosis.reason());
    assertEquals(List.of("wheel-scale"), diagnosis.explanation(), diagnosis.reason());
    assertEquals(1, diagnosis.shared().size(), diagnosis.reason());
    Shared shared = diagnosis.shared().get(0);
    assertTrue(shared.isOne(), shared.words());
    assertEquals(tracked, shared.isTracked(), shared.words());
    assertEquals(heard, shared.isHeard(), shared.words());
    assertEquals(LARGER, shared.together().value(), 0.001, shared.words());
    assertTrue(
        shared.together().deviation()
            <= Math.min(shared.tracked().deviation(), shared.heard().deviation()));
  }

  /** The value stands in both models, so that either half can be predicted from the folder. */
  private static void checkModels(JointDiagnosis diagnosis) {
    FittedMotion moves = diagnosis.motion().fitted().get(0);
    assertEquals("wheel-scale", moves.form().form());
    assertEquals(diagnosis.shared().get(0).together().value(), moves.values()[0]);
    assertEquals("wheel-scale", diagnosis.sensing().fitted().forms().get(0).name());
    assertEquals(moves.values()[0], diagnosis.sensing().fitted().valuesOf(0)[0]);
  }

  @Test
  void wheelsThatAreTooLarge_areOneCause_inBothHalves() {
    JointDiagnosis diagnosis = diagnose(largeWheels(1));
    checkWheels(diagnosis, true, true);
    checkModels(diagnosis);
  }

  @Test
  void wheelsThatAreTooLarge_areFound_whereTheTrackIsTooShort() {
    JointWorld world = largeWheels(6).drive();
    MotionRun first = world.motion().runs().get(0);
    MotionRun brief = new MotionRun(first.name(), first.commands(), first.track().subList(0, 250));
    MotionData drive = new MotionData("joint", world.motion().robot(), List.of(brief), List.of());
    JointDiagnosis diagnosis = diagnose(world.data(), drive);
    assertTrue(diagnosis.motion().isSilent());
    checkWheels(diagnosis, false, true);
    checkModels(diagnosis);
  }

  @Test
  void wheelsThatAreTooLarge_areFound_whereReadingsAreFew() {
    JointWorld world = largeWheels(7).drive();
    DataSet all = world.data();
    DataSet few = new DataSet("joint", all.setup(), all.readings().subList(0, 12), List.of());
    JointDiagnosis diagnosis = diagnose(few, world.motion());
    assertFalse(diagnosis.isHeard());
    checkWheels(diagnosis, true, false);
    checkModels(diagnosis);
  }

  @Test
  void readingsAlone_nameTheScaleOfTheOdometry_withTheFormOfTheWheels() {
    Diagnosis alone = new Diagnoser(1, Set.of()).diagnose(largeWheels(2).drive().data());
    assertEquals(Verdict.EXPLAINED, alone.verdict(), alone.reason());
    assertEquals(List.of(Effect.ODOMETRY_SCALE), alone.explanation());
    assertEquals("wheel-scale", alone.fitted().forms().get(0).name());
    assertEquals(LARGER, alone.fitted().valuesOf(0)[0], 0.001);
  }

  @Test
  void motorsThatAreTooSlow_areNotHeard_becauseTheRobotKnows() {
    JointWorld world = new JointWorld(3);
    world.motors = 0.95;
    JointDiagnosis diagnosis = diagnose(world);
    assertEquals(List.of("wheel-scale"), diagnosis.explanation(), diagnosis.reason());
    Shared shared = diagnosis.shared().get(0);
    assertFalse(shared.isOne(), shared.words());
    assertTrue(shared.words().contains("the robot knows how far it goes"), shared.words());
    assertEquals(Verdict.NONE, diagnosis.sensing().verdict());
    assertEquals(0, diagnosis.sensing().fitted().size());
  }

  @Test
  void turningThatNobodyCounts_isOneCause() {
    JointWorld world = new JointWorld(4);
    world.bias = 0.01;
    JointDiagnosis diagnosis = diagnose(world);
    assertEquals(Verdict.EXPLAINED, diagnosis.verdict(), diagnosis.reason());
    assertEquals(List.of("turn-bias"), diagnosis.explanation(), diagnosis.reason());
    assertEquals(0.01, diagnosis.shared().get(0).together().value(), 3e-4);
  }

  @Test
  void aRobotThatDoesWhatItIsTold_hasNoGap() {
    JointDiagnosis diagnosis = diagnose(new JointWorld(5));
    assertEquals(Verdict.NONE, diagnosis.verdict(), diagnosis.reason());
    assertEquals(List.of(), diagnosis.explanation());
    assertEquals(List.of(), diagnosis.shared());
  }

  @Test
  void everyCounterpart_hasOneParameterOfOneName() {
    JointWorld world = new JointWorld(8);
    world.runs = 1;
    world.drive();
    List<Counterpart> all = Counterpart.all(world.data(), world.motion().robot());
    assertEquals(5, all.size());
    for (Counterpart one : all) {
      MotionForm moves = one.moves();
      assertEquals(1, moves.parameters().size());
      assertEquals(moves.parameters().get(0).name(), one.hears().parameters().get(0).name());
      assertEquals(moves.neutralValues()[0], one.hears().neutral()[0]);
    }
  }
}
