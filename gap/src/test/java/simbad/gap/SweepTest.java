package simbad.gap;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.gap.diagnosis.DataSet;
import simbad.gap.diagnosis.Diagnosis;
import simbad.gap.diagnosis.Verdict;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.Worlds;
import simbad.sonar.frame.Pose;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;

/** A sensor on a servo, 80 cm before a post, that reads three times at every second degree. */
class SweepTest {
  private static final int READ = 3;

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
    return new Diagnoser(1, Set.of())
        .diagnose(new DataSet("sweep", Worlds.POST, sweep(truth), List.of()));
  }

  @Test
  void clean_isNone() {
    Diagnosis diagnosis = diagnosis(Hypothesis.NONE);
    assertEquals(Verdict.NONE, diagnosis.verdict(), diagnosis.reason());
  }

  /** A post that stands 15 cm further is no air of 100 degrees, and no sensor under a table. */
  @Test
  void postThatStandsFurther_isNoFaultOfTheRange() {
    Diagnosis diagnosis = diagnosis(Worlds.effect(Effect.OBSTACLE_OFFSET, "all", 0, -0.15));
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
