package simbad.gap.calibrate.level;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.gap.fixture.LevelWorlds;
import simbad.sonar.frame.Placement;
import simbad.sonar.scene.Detection;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.TableDetection;
import simbad.sonar.scene.UniformDetection;
import simbad.sonar.shape.ThresholdTable;

/** What a cone says of the beam, before posts whose thresholds are known. */
class ConesTest {
  private static final double CONE_RAD = Math.toRadians(20);
  private static final double STEP_RAD = Math.toRadians(2.5);

  private static Scene scene(Detection... detections) {
    List<Obstacle> all = new ArrayList<>();
    for (Detection own : detections) {
      all.add(
          new Obstacle(
              "post " + all.size(),
              new Placement(all.size(), 0, 0),
              LevelWorlds.POST.scene().obstacles().get(0).outline(),
              own));
    }
    return new Scene(all);
  }

  private static Trials.Trial border(int target, int bearing, double distance) {
    return new Trials.Trial(
        -1, target, bearing * STEP_RAD, distance, distance, CONE_RAD, false, 0, 1, 0);
  }

  /** Three bearings that are four steps apart, at half of the threshold and three quarters. */
  @Test
  void atItsBorderAPostIsJustLost() {
    assertEquals(
        List.of(
            border(0, 0, 0.75),
            border(0, 0, 1.125),
            border(0, 4, 0.75),
            border(0, 4, 1.125),
            border(0, 8, 0.75),
            border(0, 8, 1.125)),
        Cones.of(scene(new UniformDetection(1.5)), CONE_RAD));
  }

  /** The thresholds fall to both sides of the table's first bearing: there and back round 0. */
  @Test
  void theStrongestBearingsAreAskedAllRound() {
    double[] table = new double[72];
    Arrays.setAll(table, i -> 2 - 0.02 * Math.min(i, 72 - i));
    List<Integer> bearings =
        Cones.of(scene(new TableDetection(ThresholdTable.of(table))), CONE_RAD).stream()
            .map(trial -> (int) Math.round(trial.bearingRad() / STEP_RAD))
            .distinct()
            .toList();

    assertEquals(List.of(0, 4, 140), bearings);
  }

  /** So short a threshold says "weak" and no more. */
  @Test
  void aWeakPostSaysNothing() {
    List<Trials.Trial> all =
        Cones.of(scene(new UniformDetection(0.2), new UniformDetection(0.4)), CONE_RAD);

    assertEquals(6, all.size());
    assertEquals(border(1, 0, 0.2), all.get(0));
  }

  @Test
  void aQuarterTurnIsNoCone() {
    Scene scene = scene(new UniformDetection(1.5));

    assertEquals(0, Cones.of(scene, Math.PI / 2).size());
    assertEquals(6, Cones.of(scene, Math.toRadians(89)).size());
  }
}
