package simbad.gap;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;
import simbad.definition.Trait;
import simbad.gap.audit.Audit;
import simbad.gap.diagnosis.DataSet;
import simbad.gap.diagnosis.Diagnosis;
import simbad.gap.diagnosis.Verdict;
import simbad.sonar.effect.Definitions;
import simbad.sonar.fixture.Shapes;
import simbad.sonar.fixture.Untimed;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Pose;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.scene.UniformDetection;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.ReadingRow;
import simbad.sonar.shape.Outline;

/**
 * A card of 85 mm that a servo turns before a sonar: until some 27 degrees it reads a little longer
 * with each degree, then the card sends nothing back, and what stands behind it is read. Believed
 * to be heard from all sides.
 */
class TiltedBoardTest {
  private static final double AWAY_M = 0.04;
  private static final int LOST_DEG = 27;
  private static final double[] BEHIND_M = {0.77, 2.45, 3.3};

  private static SensingSetup setup() {
    Outline card = Shapes.outline(-0.0425, 0, 0.0425, 0, 0.0425, -0.02, -0.0425, -0.02);
    Obstacle obstacle =
        new Obstacle("card", new Placement(0, 0, 0), card, new UniformDetection(4.35));
    SonarSpec sensor =
        new SonarSpec(
            "HC-SR04", Math.toRadians(25), 0.02, 4, 0.15, 344.8, 0.01, 0.0056, 0.01, 0.03, 0.06);
    return new SensingSetup(sensor, new Scene(List.of(obstacle)), 4);
  }

  private static List<ReadingRow> read() {
    Random random = new Random(7);
    List<ReadingRow> rows = new ArrayList<>();
    for (int deg = 1; deg <= 50; deg++) {
      // A card that is turned to the left is a sensor that went round to the right.
      double x = -AWAY_M * Math.sin(Math.toRadians(deg));
      double z = AWAY_M * Math.cos(Math.toRadians(deg));
      Pose pose = Pose.of(x, z, Math.atan2(z, -x));
      for (int sweep = 0; sweep < 4; sweep++) {
        boolean isHeard = deg < LOST_DEG + random.nextInt(-2, 3);
        double longer = 0.03 * Math.max(0, Math.min(deg, LOST_DEG) - 8) / (LOST_DEG - 8);
        double range =
            isHeard
                ? AWAY_M + longer + 0.003 * random.nextGaussian()
                : BEHIND_M[random.nextInt(BEHIND_M.length)] + 0.015 * random.nextGaussian();
        rows.add(
            new ReadingRow(
                "sweep" + sweep,
                "s",
                0,
                pose,
                new Echo(Math.rint(100 * range) / 100),
                Untimed.ROW));
      }
    }
    Collections.shuffle(rows, random);
    return rows;
  }

  /** It was "partly, vertical-beam" or "partly, range-offset", by which 1 % of the gap goes. */
  @Test
  void whatHalfOfTheEchoesContradict_isNotSure() {
    SensingSetup setup = setup();
    List<ReadingRow> rows = read();
    Diagnosis diagnosis =
        new Diagnoser(1, Set.of())
            .diagnose(new DataSet("card", setup, rows, List.of()), Audit.of(setup, rows));
    assertTrue(
        diagnosis.verdict() == Verdict.UNEXPLAINED || diagnosis.verdict() == Verdict.PARTLY,
        diagnosis.verdict() + " " + diagnosis.reason());
    boolean isPartly = diagnosis.verdict() == Verdict.PARTLY;
    boolean moves =
        diagnosis.explanation().stream().anyMatch(Definitions.with(Trait.MOVES_RANGES)::contains);
    assertFalse(isPartly && moves, diagnosis.explanation().toString());
  }
}
