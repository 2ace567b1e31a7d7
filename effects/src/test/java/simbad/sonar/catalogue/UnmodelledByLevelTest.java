package simbad.sonar.catalogue;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.sonar.change.LevelBoard;
import simbad.sonar.change.LevelPost;
import simbad.sonar.change.ReadingTimeout;
import simbad.sonar.frame.Pose;
import simbad.sonar.level.LevelLaw;
import simbad.sonar.ping.Change;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.Mixture;
import simbad.sonar.ping.Moment;
import simbad.sonar.ping.PingLog;
import simbad.sonar.predict.ChangedModel;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SensorLaw;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;

/** Things that are not in an empty scene, and a clock that ends what is read; by hand. */
class UnmodelledByLevelTest {
  private static final double HEARD = 0.98;
  private static final SensingSetup SETUP =
      new SensingSetup(
              new SonarSpec(
                  "s", Math.toRadians(20), 0.02, 4, 0.1, 343, 0.01, 0.005, 0.02, 0.03, 0.05),
              new Scene(List.of()),
              4)
          .under(SensorLaw.Model.LEVEL);
  private static final LevelLaw LAW = SETUP.sensor().levelLaw();

  private static double chance(Pose pose, Change thing) {
    Change law = LevelForms.law(SETUP).with(LevelForms.law(SETUP).neutral());
    ChangedModel model = new ChangedModel(SETUP, List.of(law, thing));
    PingLog log = new PingLog(List.of(new ReadingRow("r", "s", 0, pose, NoEcho.NO_ECHO)));
    return 1 - model.forecast(model.geometry(log)).get(0).noEchoProbability();
  }

  /** A mirror image spreads once on the way there and back. */
  private static LevelBoard atThreshold(double distanceM, double halfWidthM) {
    double strength = LAW.strengthDb(distanceM) - 20 * Math.log10(distanceM / 2);
    return new LevelBoard(0, 0, 0, halfWidthM, strength);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.8, 1.5, 3})
  void aBoardIsAMirrorFromEitherSide(double distanceM) {
    LevelBoard board = atThreshold(distanceM, 5);

    assertEquals(HEARD / 2, chance(Pose.of(distanceM, 0.1, Math.PI), board), 1e-9);
    assertEquals(HEARD / 2, chance(Pose.of(-distanceM, 0.1, 0), board), 1e-9);
    assertEquals(0, chance(Pose.of(distanceM, 0.1, 0), board), "behind the sensor");
  }

  /**
   * Behind a knife edge as much is lost as before it: half the amplitude, 6.03 dB by the formula.
   */
  @Test
  void atItsEdgeHalfTheAmplitudeIsLost() {
    LevelBoard board = atThreshold(1.5, 0.2);
    double lost = 6.9 + 20 * Math.log10(Math.sqrt(1.01) - 0.1);
    LevelBoard louder = new LevelBoard(0, 0, 0, 0.2, board.reflectedDb() + lost);

    assertEquals(6.03, lost, 0.01);
    assertEquals(HEARD / 2, chance(Pose.of(1.5, 0.2, Math.PI), louder), 1e-9);
    assertEquals(HEARD / 2, chance(Pose.of(1.5, -0.2, Math.PI), louder), 1e-9);
    assertTrue(chance(Pose.of(1.5, 0.3, Math.PI), louder) < 0.01, "beyond it");
  }

  @Test
  void aPostIsATargetFromItsSurface() {
    LevelPost post = new LevelPost(0, 0, 0.1, LAW.strengthDb(1.5));

    assertEquals(HEARD / 2, chance(Pose.of(1.6, 0, Math.PI), post), 1e-9);
    assertEquals(HEARD / 2, chance(Pose.of(0, 1.6, Math.PI / 2), post), 1e-9);
    assertTrue(chance(Pose.of(1.6, 0, Math.PI + 0.5), post) < 0.01, "off the axis");
    assertEquals(0, chance(Pose.of(0.05, 0, Math.PI), post), "inside");
  }

  @Test
  void whatIsNotThere_isNotHeard() {
    double none = Double.NEGATIVE_INFINITY;

    assertEquals(0, chance(Pose.of(1, 0, Math.PI), new LevelPost(0, 0, 0.1, none)));
    assertEquals(0, chance(Pose.of(1, 0, Math.PI), new LevelBoard(0, 0, 0, 1, none)));
    assertThrows(IllegalArgumentException.class, () -> new LevelPost(0, 0, -0.1, 0));
    assertThrows(IllegalArgumentException.class, () -> new LevelBoard(0, 0, 0, 1, Double.NaN));
  }

  /**
   * What would read more is lost: of ranges of 1.406 m with 5 mm scatter 0.7881 are below 1.41 m.
   */
  @Test
  void aClockEndsWhatIsRead() {
    Mixture mixture = new Mixture();
    mixture.add(1.406, 0.005, 0.5);
    mixture.add(1.41, 0, 0.1);
    mixture.add(1.42, 0, 0.1);
    mixture.addEven(1.40, 1.44, 0.2);
    new ReadingTimeout(1.41).apply(new Moment(emptyGeometry()), mixture);

    assertEquals(0.5 * 0.7881446, mixture.share(0), 1e-6);
    assertEquals(0.1, mixture.share(1), 1e-12);
    assertEquals(0, mixture.share(2), 1e-12);
    assertEquals(0.2 / 4, mixture.share(3), 1e-12);
    assertThrows(IllegalArgumentException.class, () -> new ReadingTimeout(0));
  }

  private static Geometry emptyGeometry() {
    ChangedModel model = new ChangedModel(SETUP, List.of());
    return model.geometry(new PingLog(List.of()));
  }
}
