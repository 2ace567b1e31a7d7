package simbad.blindworld.world;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;

class ForecastTest {

  private static Forecast always(double atM) {
    double[] row = new double[Forecast.LEVELS];
    Arrays.fill(row, atM);
    return new Forecast(new double[][] {row});
  }

  /** Levels below and above a half balance, so a point forecast loses just its distance. */
  @Test
  void pointForecast_losesItsDistance() {
    assertEquals(0, always(1).lossCm(0, 1), 1e-12);
    assertEquals(7, always(1).lossCm(0, 1.07), 1e-9);
    assertEquals(30, always(1).lossCm(0, 0.7), 1e-9);
  }

  @Test
  void noEcho_countsAsTheSceneSays() {
    assertEquals(300, always(1).gapCm(new double[] {Double.POSITIVE_INFINITY}, 4), 1e-9);
  }

  /** The continuous ranked probability score of a Gaussian forecast of itself is sd / sqrt(pi). */
  @Test
  void ownForecast_losesWhatTheGaussianScoreSays() {
    Sensor sensor = new Sensor("s", 0.3, 0.02, 5, 0.1, 343, 0, 0.02, 0, 1e-6, 0.1);
    Scene scene = new Scene(5, sensor, List.of(TestWorlds.post("p", 0, 0, 3)));
    World.Listening still =
        new World(scene, Setup.nominal(sensor), List.of()).at(TestWorlds.approach(1, 1, 2000));
    Forecast forecast = Forecast.of(still, 5, 400, 1);
    // 19 levels leave out the tails, which cost a few per cent.
    assertEquals(2 / Math.sqrt(Math.PI), forecast.gapCm(still.read(9), 5), 0.06);
  }

  @Test
  void quantiles_areThoseOfTheRepeats() {
    Sensor sensor = new Sensor("s", 0.3, 0.02, 5, 0.1, 343, 0, 0, 0.3, 1e-6, 0.1);
    Scene scene = new Scene(5, sensor, List.of(TestWorlds.post("p", 0, 0, 3)));
    World.Listening still =
        new World(scene, Setup.nominal(sensor), List.of()).at(TestWorlds.approach(1, 1, 3));
    double[] row = Forecast.of(still, 5, 1000, 2).row(1);
    assertEquals(0.98, row[12], 1e-4, "q65 of 70 % echoes");
    assertEquals(5, row[14], 1e-12, "q75 of 30 % no-echoes");
  }

  @Test
  void lossIsNeverNegative() {
    Chance random = new Chance(8);
    for (int i = 0; i < 1000; i++) {
      double[] row = random.doubles(Forecast.LEVELS, 0, 4).sorted().toArray();
      double loss = new Forecast(new double[][] {row}).lossCm(0, random.nextDouble(0, 4));
      assertEquals(Math.abs(loss), loss);
    }
  }

  @Test
  void csv_hasNineteenColumns() {
    List<String> lines = always(1.25).csv().lines().toList();
    assertEquals(2, lines.size());
    assertEquals("q05,q10", lines.get(0).substring(0, 7));
    assertEquals(Forecast.LEVELS, lines.get(1).split(",", -1).length);
    assertEquals("1.2500", lines.get(1).substring(0, 6));
  }
}
