package simbad.sonar.predict;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import simbad.sonar.effect.FittedForm;
import simbad.sonar.effect.Form;
import simbad.sonar.fixture.Scenes;
import simbad.sonar.fixture.Sonars;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.frame.Pose;
import simbad.sonar.model.NominalModel;
import simbad.sonar.model.ReadingDistribution;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.Reading;
import simbad.sonar.sensing.ReadingRow;
import simbad.sonar.sensing.Readings;
import simbad.sonar.sensing.Sensor;
import simbad.sonar.sensing.TransducerPoses;

class DiagnosedSensorTest {
  private static final SonarSpec EXACT = Sonars.exact(15, 0.03, 6);

  private static FittedForm fitted(SensingSetup setup, String name, Double... values) {
    Form form =
        Logs.forms(setup, List.of("a", "b")).stream()
            .filter(one -> one.toString().equals(name))
            .findFirst()
            .orElseThrow();
    return new FittedForm(form, List.of(values));
  }

  private static FittedModel model(SonarSpec sensor, Scene scene, FittedForm... effects) {
    SensingSetup setup = new SensingSetup(sensor, scene, 6.5);
    return new FittedModel(setup, List.of("a", "b"), List.of(), List.of(effects));
  }

  private static TransducerPoses poses(Pose... all) {
    TransducerPoses poses = new TransducerPoses(all.length);
    for (int i = 0; i < all.length; i++) {
      double heading = all[i].heading().radians();
      poses.setPosition(i, all[i].position().xM(), 0.05, all[i].position().zM());
      poses.setDirection(i, Math.cos(heading), 0, -Math.sin(heading));
    }
    return poses;
  }

  private static List<Reading> ping(Sensor sensor, double timeS, Pose... all) {
    Readings readings = new Readings(all.length);
    sensor.ping(poses(all), timeS, readings);
    List<Reading> read = new ArrayList<>();
    for (int i = 0; i < all.length; i++) {
      read.add(readings.reading(i));
    }
    return read;
  }

  private static double range(Reading reading) {
    assertTrue(reading instanceof Echo, reading.toString());
    return ((Echo) reading).rangeM();
  }

  /** Without changes and noise: what the nominal model says at every golden pose. */
  @Test
  void noChange_readsWhatTheNominalModelExpects() throws DataFormatException {
    SensingSetup golden = Logs.setup("two");
    Sensor sensor = model(EXACT, golden.scene()).bind(EXACT, golden.scene(), new Random(1));
    NominalModel nominal = new NominalModel(EXACT, golden.scene());
    int echoes = 0;
    for (ReadingRow row : Logs.rows("two", golden, new Random(1))) {
      Reading expected = nominal.distribution(row.pose()).sample(new Random(1));
      Reading found = ping(sensor, row.timeS(), row.pose()).get(0);
      assertEquals(expected instanceof Echo, found instanceof Echo);
      if (expected instanceof Echo echo) {
        assertEquals(echo.rangeM(), range(found), 1e-9);
        echoes++;
      }
    }
    assertTrue(echoes > 5, "echoes: " + echoes);
  }

  /** All effects with memory at once, and noise: shares of 20,000 runs against the forecast. */
  @Test
  void memory_isThatOfTheForecast() {
    SonarSpec noisy = Sonars.noisy(0.01, 0.02, 0.1, 0.1);
    Scene scene = Scenes.of(Scenes.box(1, 0, 0.95), Scenes.box(1.6, 0, 1.5));
    SensingSetup setup = new SensingSetup(noisy, scene, 6.5);
    FittedModel model =
        model(
            noisy,
            scene,
            fitted(setup, "dropout/bursts", 0.3, 3.0),
            fitted(setup, "hysteresis/both", 0.25),
            fitted(setup, "stale-reading/count", 1.6),
            fitted(setup, "previous-ping/shift", 0.4, 0.31, 0.01),
            fitted(setup, "crosstalk/any", 0.1, 0.05, 3.0));
    double[] places = {0, 0.05, 0.15, 0.1, -0.05};
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < places.length; i++) {
      rows.add(Logs.row(0.1 * i, Pose.of(places[i], 0, 0), Logs.SILENCE));
    }
    List<ReadingDistribution> forecast = Logs.forecast(setup, rows, model.changes());
    double[] limits = {0.3, 0.55, 0.8, 0.87, 1, 1.4, 1.5, 2};
    int runs = 20_000;
    int[][] upTo = new int[places.length][limits.length];
    Sensor sensor = model.bind(noisy, scene, new Random(11));
    for (int run = 0; run < runs; run++) {
      sensor.reset();
      for (int ping = 0; ping < places.length; ping++) {
        Reading reading = ping(sensor, 0.1 * ping, Pose.of(places[ping], 0, 0)).get(0);
        for (int i = 0; i < limits.length; i++) {
          // Half a step further: a reading on the limit counts however it was rounded.
          boolean within = reading instanceof Echo echo && echo.rangeM() <= limits[i] + 0.005;
          upTo[ping][i] += within ? 1 : 0;
        }
      }
    }
    for (int ping = 0; ping < places.length; ping++) {
      for (int i = 0; i < limits.length; i++) {
        double expected = forecast.get(ping).echoUpTo(limits[i] + 0.005);
        // Four standard deviations of a share, and what a forecast leaves out of ghosts of noise.
        assertEquals(expected, upTo[ping][i] / (double) runs, 0.015, ping + " to " + limits[i]);
      }
    }
  }

  @Test
  void latency_readsAtTheEarlierPose() {
    Scene scene = Scenes.of(Scenes.box(2, 0, 5));
    SensingSetup setup = new SensingSetup(EXACT, scene, 6.5);
    Sensor sensor =
        model(EXACT, scene, fitted(setup, "latency/time", 0.15)).bind(EXACT, scene, new Random(1));
    assertEquals(1.875, range(ping(sensor, 7, Pose.of(0, 0, 0)).get(0)), 1e-12);
    assertEquals(1.875, range(ping(sensor, 7.1, Pose.of(0.1, 0, 0)).get(0)), 1e-12);
    // 0.05 s after 7.0, half of the way to the pose at 7.1.
    assertEquals(1.825, range(ping(sensor, 7.2, Pose.of(0.2, 0, 0)).get(0)), 1e-9);
    assertEquals(1.725, range(ping(sensor, 7.3, Pose.of(0.3, 0, 0)).get(0)), 1e-9);
    sensor.reset();
    assertEquals(1.575, range(ping(sensor, 0, Pose.of(0.3, 0, 0)).get(0)), 1e-12);
  }

  /** A driven sensor remembers what it saw before in this run, and nothing of the run before. */
  @Test
  void scatteredLatency_scattersFromTheSecondPingOfARun() {
    Scene scene = Scenes.of(Scenes.box(2, 0, 5));
    SensingSetup setup = new SensingSetup(EXACT, scene, 6.5);
    Sensor sensor =
        model(EXACT, scene, fitted(setup, "latency/scattered", 0.0, 0.5))
            .bind(EXACT, scene, new Random(1));
    int runs = 4000;
    double squares = 0;
    for (int run = 0; run < runs; run++) {
      sensor.reset();
      assertEquals(1.875, range(ping(sensor, 0, Pose.of(0, 0, 0)).get(0)), 1e-12);
      double off = range(ping(sensor, 0.1, Pose.of(0.1, 0, 0)).get(0)) - 1.775;
      squares += off * off;
    }
    assertEquals(0.05, Math.sqrt(squares / runs), 0.002);
  }

  @Test
  void drift_countsFromTheFirstPing_scaleFromItsPlace() {
    Scene scene = Scenes.of(Scenes.box(2, 0, 5));
    SensingSetup setup = new SensingSetup(EXACT, scene, 6.5);
    Sensor scaled =
        model(EXACT, scene, fitted(setup, "odometry-scale/path", 1.2))
            .bind(EXACT, scene, new Random(1));
    assertEquals(1.375, range(ping(scaled, 0, Pose.of(0.5, 0, 0)).get(0)), 1e-12);
    assertEquals(1.255, range(ping(scaled, 1, Pose.of(0.6, 0, 0)).get(0)), 1e-9);
    Sensor drifting =
        model(EXACT, scene, fitted(setup, "heading-drift/heading", 5.0))
            .bind(EXACT, scene, new Random(1));
    assertTrue(ping(drifting, 60, Pose.of(0, 0, 0)).get(0) instanceof Echo);
    // After 5 s the sensor looks 25 degrees away from the box, its cone is 15 wide either side.
    assertEquals(NoEcho.NO_ECHO, ping(drifting, 65, Pose.of(0, 0, 0)).get(0));
  }

  /** Each transducer has a memory of its own: here a last reading. */
  @Test
  void staleReading_isEachTransducersOwn() {
    Scene scene = Scenes.of(Scenes.box(2, 0, 5));
    SensingSetup setup = new SensingSetup(EXACT, scene, 6.5);
    Sensor sensor =
        model(EXACT, scene, fitted(setup, "stale-reading/count", 2.0))
            .bind(EXACT, scene, new Random(1));
    Pose towards = Pose.of(0, 0, 0);
    Pose away = Pose.of(0, 0, Math.PI);
    List<Reading> first = ping(sensor, 0, towards, away);
    assertEquals(List.of(new Echo(1.875), NoEcho.NO_ECHO), first);
    assertEquals(first, ping(sensor, 0.1, away, away));
    assertEquals(first, ping(sensor, 0.2, away, away));
    assertEquals(List.of(NoEcho.NO_ECHO, NoEcho.NO_ECHO), ping(sensor, 0.3, away, away));
  }

  @Test
  void misalignment_ofOneSensor_isThatOfItsTransducer() {
    Scene scene = Scenes.of(Scenes.box(2, 0, 5));
    SensingSetup setup = new SensingSetup(EXACT, scene, 6.5);
    Sensor sensor =
        model(EXACT, scene, fitted(setup, "beam-misalignment/only:b", 30.0))
            .bind(EXACT, scene, new Random(1));
    Pose pose = Pose.of(0, 0, 0);
    List<Reading> read = ping(sensor, 0, pose, pose, pose);
    assertEquals(List.of(new Echo(1.875), NoEcho.NO_ECHO, new Echo(1.875)), read);
  }

  /** What is known of one obstacle says nothing of an obstacle of another name. */
  @Test
  void changeOfOneObstacle_goesByItsName() {
    Scene two = Scenes.of(Scenes.box(2, 0, 5), Scenes.box(-2, 0, 5));
    SensingSetup setup = new SensingSetup(EXACT, two, 6.5);
    FittedForm moved = fitted(setup, "obstacle-offset/only:box#1", 0.5, 0.0);
    FittedForm gain = fitted(setup, "gain/factor", 0.5);
    FittedModel model = model(EXACT, two, moved, gain);
    Sensor there = model.bind(EXACT, two, new Random(1));
    assertEquals(2.375, range(ping(there, 0, Pose.of(0, 0, 0)).get(0)), 1e-12);
    // Alone its label is no longer box#1; the gain still holds: 2.55 m are beyond half of 5 m.
    Scene one = Scenes.of(Scenes.box(2, 0, 5));
    Sensor elsewhere = model.bind(EXACT, one, new Random(1));
    assertEquals(1.875, range(ping(elsewhere, 0, Pose.of(0, 0, 0)).get(0)), 1e-12);
    assertEquals(NoEcho.NO_ECHO, ping(elsewhere, 1, Pose.of(-0.55, 0, 0)).get(0));
  }

  @Test
  void sameSeed_sameReadings() {
    SonarSpec noisy = Sonars.noisy(0.001, 0.05, 0.3, 0.1);
    Scene scene = Scenes.of(Scenes.box(2, 0, 2.1));
    SensingSetup setup = new SensingSetup(noisy, scene, 6.5);
    FittedModel model = model(noisy, scene, fitted(setup, "dropout/bursts", 0.3, 3.0));
    assertEquals(sequence(model, 5), sequence(model, 5));
    assertNotEquals(sequence(model, 5), sequence(model, 6));
  }

  private static List<Reading> sequence(FittedModel model, long seed) {
    Sensor sensor = model.bind(EXACT, model.setup().scene(), new Random(seed));
    List<Reading> read = new ArrayList<>();
    for (int i = 0; i < 50; i++) {
      read.addAll(ping(sensor, 0.1 * i, Pose.of(0, 0, 0), Pose.of(0.1, 0, 0)));
    }
    return read;
  }
}
