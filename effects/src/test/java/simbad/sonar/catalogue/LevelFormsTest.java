package simbad.sonar.catalogue;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.definition.Parameter;
import simbad.sonar.change.Gain;
import simbad.sonar.change.GatedOffset;
import simbad.sonar.change.LevelAbsorption;
import simbad.sonar.change.LevelAperture;
import simbad.sonar.change.LevelDrift;
import simbad.sonar.change.LevelGain;
import simbad.sonar.change.LevelScatter;
import simbad.sonar.change.RangeOffset;
import simbad.sonar.effect.Definitions;
import simbad.sonar.effect.FittedForm;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Point;
import simbad.sonar.frame.Pose;
import simbad.sonar.model.LevelModel;
import simbad.sonar.model.ReadingDistribution;
import simbad.sonar.ping.Change;
import simbad.sonar.ping.PingLog;
import simbad.sonar.predict.ChangedModel;
import simbad.sonar.predict.FittedModel;
import simbad.sonar.predict.ModelFile;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SensorLaw;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.scene.UniformDetection;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;
import simbad.sonar.shape.Outline;

class LevelFormsTest {
  private static final double THRESHOLD_M = 1.5;
  private static final SensingSetup SETUP = setup();

  @TempDir private Path folder = Path.of("target");

  private static SensingSetup setup() {
    Outline post =
        Outline.of(
            List.of(
                new Point(0.01, 0.01),
                new Point(0.01, -0.01),
                new Point(-0.01, -0.01),
                new Point(-0.01, 0.01)));
    Obstacle obstacle =
        new Obstacle("post", new Placement(0, 0, 0), post, new UniformDetection(THRESHOLD_M));
    SonarSpec sensor =
        new SonarSpec("s", Math.toRadians(20), 0.02, 4, 0.1, 343, 0.01, 0.005, 0.02, 0.03, 0.05);
    return new SensingSetup(sensor, new Scene(List.of(obstacle)), 4).under(SensorLaw.Model.LEVEL);
  }

  private static Change stated() {
    Form law = LevelForms.law(SETUP);
    return law.with(law.neutral());
  }

  /** Before the post's flat side, so many metres off and degrees past it. */
  private static List<ReadingRow> row(double distanceM, double pastDeg) {
    Pose pose = Pose.of(0, distanceM, Math.PI / 2 + Math.toRadians(pastDeg));
    return List.of(new ReadingRow("r", "s", 0, pose, NoEcho.NO_ECHO));
  }

  private static ReadingDistribution forecast(double distanceM, double pastDeg, Change... effects) {
    List<Change> changes = new ArrayList<>(List.of(stated()));
    changes.addAll(Arrays.asList(effects));
    ChangedModel model = new ChangedModel(SETUP, changes);
    return model.forecast(model.geometry(new PingLog(row(distanceM, pastDeg)))).get(0);
  }

  private static double chance(double distanceM, double pastDeg, Change... effects) {
    return 1 - forecast(distanceM, pastDeg, effects).noEchoProbability();
  }

  /** On the axis the beam is level, and far off no ringing is left: the law alone decides. */
  @ParameterizedTest
  @CsvSource({"0.6", "1.2", "1.45", "1.5", "1.6", "2.2"})
  void onTheAxis_itIsTheLevelModel(double distanceM) {
    LevelModel model = new LevelModel(SETUP.sensor(), SETUP.scene());
    ReadingDistribution own = forecast(distanceM, 0);
    ReadingDistribution asked = model.distribution(row(distanceM, 0).get(0).pose());

    assertEquals(asked.noEchoProbability(), own.noEchoProbability(), 1e-9);
  }

  @Test
  void atTheThreshold_theChanceIsHalf() {
    assertEquals(0.98 / 2, chance(THRESHOLD_M, 0), 1e-9);
  }

  @Test
  void aGainIsAShiftOfTheExcess() {
    double law = SETUP.sensor().levelLaw().excessSdDb();
    double loss = SETUP.sensor().levelLaw().lossDb(1.7) - SETUP.sensor().levelLaw().lossDb(1.5);

    assertEquals(0.98 / 2, chance(1.7, 0, new LevelGain(loss)), 1e-6);
    assertTrue(chance(1.7, 0, new LevelGain(loss + law)) > 0.8);
    assertEquals(0.98 / 2, chance(1.7, 0, new LevelAbsorption(-loss / (2 * 1.7))), 1e-6);
  }

  /** What scatters for two reasons scatters by the root of their squares. */
  @Test
  void moreScatter_flattensTheEdge() {
    double law = SETUP.sensor().levelLaw().excessSdDb();

    assertEquals(0.98 * 0.841345, chance(THRESHOLD_M, 0, new LevelScatter(law, 0)), 1e-3);
    assertEquals(
        0.98 * 0.691462, chance(THRESHOLD_M, 0, new LevelScatter(law, Math.sqrt(3) * law)), 1e-3);
  }

  @Test
  void aDrift_beginsWithItsFirstLevel() {
    double loss = SETUP.sensor().levelLaw().lossDb(1.7) - SETUP.sensor().levelLaw().lossDb(1.5);

    assertEquals(0.98 / 2, chance(1.7, 0, new LevelDrift(loss, 0, 0, 1)), 1e-6);
  }

  /** A factor of the threshold means the same under both laws: it is lost so much further off. */
  @Test
  void aFactorOfTheThreshold_movesTheDistanceOfLoss() {
    assertEquals(0.98 / 2, chance(1.2 * THRESHOLD_M, 0, new Gain(1.2)), 1e-9);
  }

  @Test
  void aWiderPistonHearsLessOffTheAxis() {
    assertEquals(chance(1.3, 0), chance(1.3, 0, new LevelAperture(1.5)), 1e-12);
    assertTrue(chance(1, 5, new LevelAperture(2)) < chance(1, 5) - 0.1);
    assertTrue(chance(1, 10, new LevelAperture(0.5)) > chance(1, 10) + 0.1);
  }

  /** Read 5 cm short, what is nearer than 7 cm would read less than the least range. */
  @Test
  void aGatedOffset_losesWhatWouldReadTooLittle() {
    GatedOffset offset = new GatedOffset(new RangeOffset(-0.05), 0.002);
    double far = chance(1, 0, new RangeOffset(-0.05));

    assertEquals(far, chance(1, 0, offset), 1e-9);
    assertTrue(chance(0.06, 0, offset) < 0.02 * chance(0.06, 0));
  }

  /** The least range of 2 cm was read in steps of one: it lies anywhere in the last one. */
  @Test
  void nearerThanTheLeastRange_theChanceFallsOverAStep() {
    double near = chance(0.030001, 0);

    assertTrue(near > 0.9, () -> "chance " + near);
    assertEquals(near / 2, chance(0.025, 0), 0.01);
    assertEquals(near, chance(0.029999, 0), 1e-3);
    assertEquals(0, chance(0.0199, 0));
  }

  @Test
  void strengthsByBearing_takeThePlaceOfThresholds() {
    double[] values = new double[3 * LevelForms.BEARINGS];
    Arrays.fill(values, 0, LevelForms.BEARINGS, SETUP.sensor().levelLaw().strengthDb(2.0));
    Change stronger = LevelForms.strength("post").with(values);

    assertEquals(0.98 / 2, chance(2.0, 0, stronger), 1e-9);
    assertEquals(chance(2.0, 0), chance(2.0, 0, LevelForms.strength("other").with(values)), 0);
  }

  @Test
  void whatIsNotKnownMakesAnEdgeSofter() {
    double[] values = new double[3 * LevelForms.BEARINGS];
    Arrays.fill(values, 0, LevelForms.BEARINGS, SETUP.sensor().levelLaw().strengthDb(1.5));
    double sure = chance(1.3, 0, LevelForms.strength("post").with(values));
    Arrays.fill(values, LevelForms.BEARINGS, 2 * LevelForms.BEARINGS, 3);
    double open = chance(1.3, 0, LevelForms.strength("post").with(values));

    assertTrue(open < sure - 0.05, open + " after " + sure);
  }

  @Test
  void receiverWeightsAddUpToOne() {
    for (double at : DoubleStream.of(0.01, 0.08, 0.1, 0.7, 3, 9).toArray()) {
      double sum = 0;
      for (int knot = 0; knot < LevelForms.RECEIVER_M.size(); knot++) {
        sum += LevelForms.receiverWeight(knot, at);
      }
      assertEquals(1, sum, 1e-12);
    }
  }

  /** The forms that effects have under the level law alone. */
  private static List<Form> ofLevels(SensingSetup setup) {
    List<Form> others = Forms.all(setup, List.of("s"));
    return Definitions.all().stream()
        .flatMap(definition -> definition.levelForms(setup, List.of("s")).stream())
        .filter(form -> !others.contains(form))
        .toList();
  }

  /** A scene that believes in thresholds reads the model of a diagnosis by levels. */
  @Test
  void aModelFileGivesEveryFormBack() throws Exception {
    SensingSetup plain =
        new SensingSetup(
            SETUP.sensor().withLaw(SensorLaw.UNSTATED), SETUP.scene(), SETUP.noEchoM());
    Random random = new Random(3);
    List<FittedForm> calibration =
        List.of(
            drawn(LevelForms.law(plain), random),
            drawn(LevelForms.strength("post"), random),
            drawn(LevelForms.path("post"), random));
    List<FittedForm> effects = ofLevels(plain).stream().map(form -> drawn(form, random)).toList();
    FittedModel model = new FittedModel(plain, List.of("s"), calibration, effects);
    Path file = folder.resolve("model.json");
    ModelFile.write(file, model);

    FittedModel read = ModelFile.read(file, plain);
    assertEquals(model.calibration(), read.calibration());
    assertEquals(model.effects(), read.effects());
    assertArrayEquals(likelihood(model), likelihood(read), 0);
  }

  private static double[] likelihood(FittedModel model) {
    double[] into = new double[1];
    ChangedModel diagnosed = model.calibrated();
    diagnosed.likelihood(diagnosed.geometry(new PingLog(row(1.4, 5))), into);
    return into;
  }

  private static FittedForm drawn(Form form, Random random) {
    List<Double> values = new ArrayList<>();
    for (Parameter parameter : form.parameters()) {
      double low = Math.max(parameter.low(), -1);
      double high = Math.min(parameter.high(), Math.max(1, low + 1));
      values.add(low + (high - low) * random.nextDouble());
    }
    return new FittedForm(form, values);
  }
}
