package simbad.blindworld.wavesetup;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import simbad.blindworld.world.Chance;
import simbad.blindworld.world.Scene;
import simbad.blindworld.world.Sensor;

/** What a user writes down, over twelve rooms. */
class UserTest {

  private static final List<Room> ROOMS = new ArrayList<>();
  private static final List<User.Calibration> FOUND = new ArrayList<>();

  @BeforeAll
  static void calibrate() {
    for (int seed = 0; seed < 12; seed++) {
      Chance random = new Chance(seed);
      Room room = Room.draw(random);
      ROOMS.add(room);
      FOUND.add(new User(room, random.split()).calibrate(0.25));
    }
  }

  @Test
  void sensor_isWhatARangerIs() {
    for (User.Calibration found : FOUND) {
      Sensor sensor = found.scene().sensor();
      double half = Math.toDegrees(sensor.halfAngleRad());
      assertTrue(half >= 5 && half <= 45, "half-angle " + half);
      assertTrue(sensor.minRangeM() >= 0.02 && sensor.minRangeM() <= 0.3, sensor.toString());
      assertTrue(sensor.rangeNoiseM() >= 0.002 && sensor.rangeNoiseM() < 0.04, sensor.toString());
      assertTrue(sensor.edgeWidthM() >= 0.005 && sensor.edgeWidthM() < 0.2, sensor.toString());
      assertEquals(0.25, sensor.periodS());
    }
  }

  /** The thermometer is off by a kelvin at most, the day by less than two, and the user rounds. */
  @Test
  void speed_isThatOfTheDay() {
    for (int i = 0; i < FOUND.size(); i++) {
      double truth = ROOMS.get(i).parts().air().soundSpeedMPerS();
      assertEquals(truth, FOUND.get(i).scene().sensor().soundSpeedMPerS(), 0.6 * 3 + 0.5);
    }
  }

  /** What is the same all round has a table that is nearly so; what has faces has not. */
  @Test
  void tables_tellRoundFromEdged() {
    int edged = 0;
    for (int i = 0; i < FOUND.size(); i++) {
      Scene scene = FOUND.get(i).scene();
      for (int k = 0; k < scene.obstacles().size(); k++) {
        List<Double> table = scene.obstacles().get(k).shadow().radiiM();
        double least = table.stream().mapToDouble(Double::doubleValue).min().orElseThrow();
        double most = scene.obstacles().get(k).shadow().greatestM();
        boolean round = ROOMS.get(i).articles().get(k).isRound();
        edged += round ? 0 : 1;
        assertTrue(round ? least > 0.6 * most : least < 0.7 * most, table.toString());
      }
    }
    assertTrue(edged > 3, edged + " edged ones");
  }

  @Test
  void sameSeed_givesTheSameCalibration() {
    Chance random = new Chance(3);
    Room room = Room.draw(random);
    assertEquals(FOUND.get(3).scene(), new User(room, random.split()).calibrate(0.25).scene());
  }
}
