package simbad.gap;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.definition.Effect;
import simbad.gap.diagnosis.DataSet;
import simbad.gap.diagnosis.Diagnosis;
import simbad.gap.fixture.Ladders;
import simbad.sonar.fixture.Shapes;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Pose;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.UniformDetection;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.ReadingRow;

/**
 * A plate of 10 cm is turned before a sensor, a degree a step, four times. From some angle on it
 * sends the sound away, and what stands behind is heard in its place.
 */
class TurnedPlateTest {
  private static final double HALF_M = 0.05;
  private static final SensingSetup PLATE =
      new SensingSetup(
          Ladders.BOARD.sensor().withResolution(0.01),
          new Scene(
              List.of(
                  new Obstacle(
                      "plate",
                      new Placement(0, 0, 0),
                      Shapes.outline(-HALF_M, 0, HALF_M, 0, HALF_M, -0.02, -HALF_M, -0.02),
                      new UniformDetection(10)))),
          4);

  /** From the plate the sensor goes round. */
  private static List<ReadingRow> log(double distanceM, double lostDeg, long seed) {
    Random random = new Random(seed);
    double[] behind = {0.6 + random.nextDouble(), 1.8 + random.nextDouble()};
    List<ReadingRow> rows = new ArrayList<>();
    for (int sweep = 0; sweep < 4; sweep++) {
      for (int deg = 1; deg <= 50; deg++) {
        double turn = Math.toRadians(deg);
        double heard = 1 / (1 + Math.exp((deg - lostDeg) / 2));
        double range =
            random.nextDouble() < heard
                ? distanceM * Math.cos(turn) + 0.002 * random.nextGaussian()
                : behind[random.nextInt(2)] + 0.02 * random.nextGaussian();
        Pose pose =
            Pose.of(distanceM * Math.sin(turn), distanceM * Math.cos(turn), Math.PI / 2 + turn);
        rows.add(
            new ReadingRow(
                "sweep" + sweep, "s", 300 * sweep + deg, pose, new Echo(rounded(range))));
      }
    }
    return rows;
  }

  private static double rounded(double rangeM) {
    return Math.rint(100 * rangeM) / 100;
  }

  private static Diagnosis diagnose(List<ReadingRow> rows) {
    return new Diagnoser(1, Set.of()).diagnose(new DataSet("plate", PLATE, rows, List.of()));
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  void turnedAway_itIsHeardNoMore(long seed) {
    Diagnosis diagnosis = diagnose(log(0.12, 20, seed));
    assertTrue(diagnosis.explanation().contains(Effect.ORIENTATION_SHADOW), diagnosis.reason());
    // What may be at work beside it is no surer than that it is what is left.
    double named = 1 - diagnosis.unknownProbability();
    diagnosis.effects().stream()
        .filter(one -> !diagnosis.explanation().contains(one.effect()))
        .filter(one -> one.indistinguishableFrom().isEmpty())
        .forEach(one -> assertTrue(one.probability() <= named, one::toString));
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2})
  void heardAtEveryAngle_itHasNoShadow(long seed) {
    Diagnosis diagnosis = diagnose(log(0.12, 500, seed));
    assertFalse(diagnosis.explanation().contains(Effect.ORIENTATION_SHADOW), diagnosis.reason());
  }
}
