package simbad.sonar.predict;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.sonar.change.AirTemperature;
import simbad.sonar.change.RangeDrift;
import simbad.sonar.change.RangeOffset;
import simbad.sonar.change.RangeWalk;
import simbad.sonar.change.SoundSpeed;
import simbad.sonar.change.VerticalBeam;
import simbad.sonar.fixture.Scenes;
import simbad.sonar.fixture.Sonars;
import simbad.sonar.frame.Pose;
import simbad.sonar.ping.Change;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.Circumstances;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.MovedObstacle;
import simbad.sonar.sensing.ReadingRow;
import simbad.sonar.sensing.Readings;
import simbad.sonar.sensing.Sensor;
import simbad.sonar.sensing.TransducerPoses;

/**
 * Changes of the range that are not the same for every ping: each is a plain one there, worked out
 * on paper. The face of the box is 0.875 m ahead, its centre 1 m, and it is lost at 1.2 m.
 */
class RangesOfAPingTest {
  private static final double FACE_M = 0.875;
  private static final SensingSetup SETUP =
      new SensingSetup(Sonars.noisy(0.05, 0.02, 0.1, 0.1), Scenes.of(Scenes.box(1, 0, 1.2)), 6.5);

  private static double[] likelihood(List<ReadingRow> rows, Change change) {
    return Logs.likelihood(SETUP, rows, List.of(change));
  }

  private static List<ReadingRow> at(double timeS, double rangeM) {
    Pose pose = Pose.of(0, 0, 0);
    return List.of(
        Logs.row(0, pose, OptionalDouble.of(0.85)),
        Logs.row(timeS, pose, OptionalDouble.of(rangeM)));
  }

  private static void checkAt(double timeS, Change plain, Change drift) {
    for (double range : new double[] {0.8, 0.85, 0.9, 0.95}) {
      double[] found = likelihood(at(timeS, range), drift);
      assertEquals(likelihood(at(timeS, range), plain)[1], found[1], 1e-12, "range " + range);
      assertEquals(likelihood(at(timeS, range), new RangeOffset(0))[0], found[0], 1e-12);
    }
  }

  @Test
  void drift_growsWithTheTimeSinceTheFirstPing() {
    checkAt(10, new RangeOffset(0.05), new RangeDrift(0.005, 0, Double.POSITIVE_INFINITY));
    checkAt(10, new SoundSpeed(1.1), new RangeDrift(0, 0.01, Double.POSITIVE_INFINITY));
    double arrived = 1 - Math.exp(-1);
    checkAt(30, new RangeOffset(0.05), new RangeDrift(0.05 / arrived, 0, 30));
    checkAt(30, new SoundSpeed(1.1), new RangeDrift(0, 0.1 / arrived, 30));
    checkAt(1e6, new RangeOffset(0.05), new RangeDrift(0.05, 0, 30));
  }

  /** Changes are a set: the way comes first, then what scales it, then what is added. */
  @Test
  void changesOfTheRange_byTwos_inEitherOrder() {
    List<Change> changes =
        List.of(
            new VerticalBeam(0.3, Math.PI / 2, 0.01),
            new SoundSpeed(1.03),
            new RangeDrift(0, 0.01, Double.POSITIVE_INFINITY),
            new RangeOffset(0.05),
            new RangeDrift(0.005, 0, 30),
            new RangeWalk(0.05, 8));
    for (double range = 0.75; range < 1.3; range += 0.05) {
      for (Change one : changes) {
        for (Change other : changes) {
          double[] found = Logs.likelihood(SETUP, at(3, range), List.of(one, other));
          double[] swapped = Logs.likelihood(SETUP, at(3, range), List.of(other, one));
          assertEquals(found[1], swapped[1], 1e-12, one + ", " + other + " at " + range);
        }
      }
    }
  }

  /** What a model predicts in a log is what a sensor reads that drives with it. */
  @Test
  void drift_ofALiveSensor_beginsWithItsRun() {
    SensingSetup sharp =
        new SensingSetup(Sonars.noisy(0.001, 0, 0, 0), Scenes.of(Scenes.box(1, 0, 1.2)), 6.5);
    ChangedModel model =
        new ChangedModel(sharp, List.of(new RangeDrift(0.005, 0, Double.POSITIVE_INFINITY)));
    Sensor sensor = new DiagnosedSensor(model, List.of("sonar"), new Random(1));
    Readings readings = new Readings(1);
    TransducerPoses poses = new TransducerPoses(1);
    poses.setPosition(0, 0, 0, 0);
    poses.setDirection(0, 1, 0, 0);
    sensor.ping(poses, 100, readings);
    assertEquals(FACE_M, readings.rangeM(0), 0.001);
    sensor.ping(poses, 110, readings);
    assertEquals(FACE_M + 0.05, readings.rangeM(0), 0.001);
    sensor.reset();
    sensor.ping(poses, 200, readings);
    assertEquals(FACE_M, readings.rangeM(0), 0.001);
  }

  /** 40 log10(1.2 / 1) = 3.167 dB over the threshold. */
  @Test
  void walk_fallsWithTheExcess() {
    double excess = 40 * Math.log10(1.2);
    RangeWalk walk = new RangeWalk(0.05 * Math.exp(excess / 8), 8);
    for (double range : new double[] {0.85, 0.9, 0.95}) {
      List<ReadingRow> rows = at(1, range);
      assertEquals(likelihood(rows, new RangeOffset(0.05))[1], likelihood(rows, walk)[1], 1e-12);
    }
    assertEquals(0.02, new RangeWalk(0.02, 5).addedM(-3));
    assertEquals(0.02 / Math.E, new RangeWalk(0.02, 5).addedM(5), 1e-15);
  }

  /** A triangle of 0.3 m, 0.875 m and 0.925 m. */
  @Test
  void verticalBeam_readsTheSlantingWay() {
    VerticalBeam beam = new VerticalBeam(0.3, Math.PI / 2, 0.01);
    assertEquals(0.925, beam.meanM(FACE_M), 1e-12);
    assertEquals(FACE_M, beam.rangeM(0.925), 1e-12);
    assertEquals(0, beam.rangeM(0.2));
    for (double range : new double[] {0.85, 0.9, 0.95}) {
      assertEquals(
          likelihood(at(1, range), new RangeOffset(0.05))[1],
          likelihood(at(1, range), beam)[1],
          1e-12);
    }
  }

  /** At tan(a) = 0.3 / 0.875 the face is at the edge of the beam: every second echo is left. */
  @Test
  void verticalBeam_losesWhatIsNear() {
    double atFace = Math.atan(0.3 / FACE_M);
    double all = echo(new VerticalBeam(0.3, Math.PI / 2, 0.01));
    assertEquals(all / 2, echo(new VerticalBeam(0.3, atFace, 0.01)), 1e-12);
    assertEquals(0, echo(new VerticalBeam(0.3, atFace / 2, 0.01)), 1e-12);
    assertEquals(all, echo(new VerticalBeam(0.3, Math.min(1.5, atFace * 3), 0.01)), 1e-12);
  }

  private static double echo(Change change) {
    List<ReadingRow> silent = List.of(Logs.row(0, Pose.of(0, 0, 0), Logs.SILENCE));
    return 1 - likelihood(silent, change)[0];
  }

  private static List<ReadingRow> inAirOf(double temperatureC, double rangeM) {
    Circumstances air =
        new Circumstances(
            true,
            Optional.empty(),
            OptionalDouble.of(temperatureC),
            MovedObstacle.UNMOVED,
            OptionalDouble.empty(),
            OptionalDouble.empty());
    return List.of(new ReadingRow("run", "sonar", 0, Pose.of(0, 0, 0), new Echo(rangeM), air));
  }

  /** An ideal gas at four times the absolute temperature carries sound twice as fast. */
  @ParameterizedTest
  @ValueSource(doubles = {0.4, 0.45, 0.5})
  void temperature_ofEachPing_scalesItsRange(double range) {
    double hot = 4 * (273.15 + 20) - 273.15;
    AirTemperature air = new AirTemperature(1, 1);
    assertEquals(0.5, air.scaleAt(hot), 1e-12);
    assertEquals(
        likelihood(inAirOf(hot, range), new SoundSpeed(0.5))[0],
        likelihood(inAirOf(hot, range), air)[0],
        1e-12);
    assertEquals(
        likelihood(inAirOf(20, range), new SoundSpeed(1))[0],
        likelihood(inAirOf(20, range), air)[0],
        1e-12);
  }

  /** 331.3 m/s at 0 degrees and 343.2 at 20: ISO 9613-1 has the same root. */
  @Test
  void temperature_scalesAsAirDoes() {
    assertEquals(343.2 / 331.3, new AirTemperature(1, 1).scaleAt(0), 4e-4);
    assertEquals(1, new AirTemperature(1, 0).scaleAt(-20));
    assertNotEquals(1, new AirTemperature(1, 0.5).scaleAt(-20));
    assertEquals(new PingLog(inAirOf(7, 1)).temperatureC(0), 7);
    assertEquals(Double.NaN, new PingLog(at(1, 1)).temperatureC(0));
  }

  @Test
  void figures_areChecked() {
    assertThrows(IllegalArgumentException.class, () -> new RangeDrift(Double.NaN, 0, 1));
    assertThrows(IllegalArgumentException.class, () -> new RangeDrift(0, -1, 1));
    assertThrows(IllegalArgumentException.class, () -> new RangeDrift(0, 0, 0));
    assertThrows(IllegalArgumentException.class, () -> new RangeWalk(0, 0));
    assertThrows(IllegalArgumentException.class, () -> new VerticalBeam(-1, 1, 0.1));
    assertThrows(IllegalArgumentException.class, () -> new VerticalBeam(1, Double.NaN, 0.1));
    assertThrows(IllegalArgumentException.class, () -> new AirTemperature(1, 1.5));
    assertThrows(IllegalArgumentException.class, () -> new AirTemperature(0, 1));
  }
}
