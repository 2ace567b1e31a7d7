package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.sonar.format.Sensitivity;
import simbad.sonar.format.SensorFile;

class SensorCommandTest {
  private static final Path SENSORS = Path.of("..", "data", "sensors");

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  /** Figures of the makers' sheets. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "srf04 | SRF04 | cone half angle 27.50 degrees | range 0.03000 to 6.000 m",
        "hc-sr04 | HC-SR04 | a ping every 0.06000 s | range 0.02000 to 4.000 m",
        "maxbotix-lv-ez1 | MaxBotix LV | steps of 0.02540 m | range 0.1520 to 6.450 m",
      })
  void shippedSensors_areRead(String file, String name, String one, String other) {
    Shell shell =
        Shell.simbad("sensor", "show", SENSORS.resolve(file.strip() + ".json").toString());
    assertEquals(0, shell.status(), shell.err());
    assertTrue(shell.out().startsWith(name), shell.out());
    assertTrue(shell.out().contains(one), shell.out());
    assertTrue(shell.out().contains(other), shell.out());
  }

  @Test
  void plot_drawsBeamAndCone() throws IOException {
    Path picture = folder.resolve("srf04.svg");
    Shell shell =
        Shell.simbad(
            "sensor",
            "plot",
            SENSORS.resolve("srf04.json").toString(),
            "--out",
            picture.toString());
    assertEquals(new Shell(0, "", ""), shell);
    assertTrue(Files.readString(picture).contains("<svg"));
  }

  /** A piston's far field is 2 J1(x)/x with x = ka sin(angle): nothing that was drawn by hand. */
  @Test
  void srf04_isThePistonThatItsFileNames() throws Exception {
    Sensitivity curve = SensorFile.findSensitivity(SENSORS.resolve("srf04.json")).orElseThrow();
    double ka = 2.2117854 / Math.sin(Math.toRadians(27.5));
    double before = -1;
    for (Sensitivity.Point point : curve.points()) {
      double x = ka * Math.sin(Math.toRadians(point.offAxisDeg()));
      double db = x == 0 ? 0 : 20 * Math.log10(Math.abs(2 * besselJ1(x) / x));
      assertEquals(db, point.levelDb(), 0.006, point.toString());
      assertTrue(point.offAxisDeg() - before <= 1, "a corner at " + point);
      before = point.offAxisDeg();
    }
    assertEquals(90, before);
  }

  /** Bessel's own integral, by the midpoint rule, which is exact for a periodic function. */
  private static double besselJ1(double x) {
    int parts = 1000;
    double sum = 0;
    for (int i = 0; i < parts; i++) {
      double t = (i + 0.5) * Math.PI / parts;
      sum += Math.cos(t - x * Math.sin(t));
    }
    return sum / parts;
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "[[0, 0], [10]] | sensitivity_db.1: [10] is not a pair",
        "[[10, 0], [5, -1]] | angle 5.0 does not rise from 10.0",
        "[[0, 3]] | 3 is not a level in [-200, 0] dB",
      })
  void badCurves_areRefused(String curve, String complaint) throws IOException {
    String srf04 = Files.readString(SENSORS.resolve("srf04.json"));
    Path file =
        Files.writeString(
            folder.resolve("bad.json"),
            srf04.replaceAll(
                "(?s)\"sensitivity_db\": .*?]\\s*]", "\"sensitivity_db\": " + curve.strip()));
    checkRefused(file, complaint);
  }

  @Test
  void sensorWithoutCurve_hasNothingToPlot() {
    checkRefused(SENSORS.resolve("hc-sr04.json"), "has no sensitivity_db to plot");
  }

  private void checkRefused(Path sensor, String complaint) {
    Path picture = folder.resolve("none.svg");
    Shell shell = Shell.simbad("sensor", "plot", sensor.toString(), "--out", picture.toString());
    assertEquals(2, shell.status(), shell.err());
    assertTrue(shell.err().contains(complaint), shell.err());
    assertTrue(Files.notExists(picture));
  }
}
