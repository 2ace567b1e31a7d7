package simbad.sonar.sensing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.sonar.fixture.Refusal;
import simbad.sonar.frame.Angles;

class ReadingsTest {
  @Test
  void readings_areNoEcho_untilOneIsSet() {
    Readings readings = new Readings(3);
    readings.setEcho(1, 0.5);
    assertEquals(3, readings.size());
    assertEquals(NoEcho.NO_ECHO, readings.reading(0));
    assertEquals(new Echo(0.5), readings.reading(1));
    assertEquals(0.5, readings.rangeM(1));
    assertTrue(readings.isEcho(1));
    assertFalse(readings.isEcho(2));
  }

  @Test
  void readings_areForgotten() {
    Readings readings = new Readings(2);
    readings.setEcho(0, 1);
    readings.setEcho(1, 2);
    readings.setNoEcho(0);
    assertFalse(readings.isEcho(0));
    assertTrue(readings.isEcho(1));
    readings.clear();
    assertFalse(readings.isEcho(1));
  }

  @Test
  void range_ofNoEcho_isRefused() {
    Readings readings = new Readings(5);
    String message =
        String.valueOf(
            assertThrows(IllegalStateException.class, () -> readings.rangeM(4)).getMessage());
    assertEquals("transducer 4 heard no echo", message);
  }

  @ParameterizedTest
  @ValueSource(doubles = {-1e-9, Double.NaN, Double.POSITIVE_INFINITY})
  void range_outOfItsDomain_isRefused(double bad) {
    Refusal.check(() -> new Echo(bad), "rangeM = " + bad, "[0, infinity)");
    Refusal.check(() -> new Readings(1).setEcho(0, bad), "range = " + bad, "[0, infinity)");
  }

  /** Headings by direction: (x, z) = (cos h, -sin h), a tilt does not count. */
  @ParameterizedTest
  @CsvSource({
    "1, 0, 0, 0",
    "0, 0, -1, 90",
    "-1, 0, 0, 180",
    "0, 0, 1, -90",
    "0.6, 0.8, 0, 0",
    "0.5, 0.7071, -0.5, 45"
  })
  void poses_keepPlaceAndDirection(double x, double y, double z, double headingDeg) {
    TransducerPoses poses = new TransducerPoses(2);
    poses.setPosition(1, 1, 2, 3);
    poses.setDirection(1, x, y, z);
    assertEquals(2, poses.size());
    assertEquals(headingDeg, Math.toDegrees(Angles.signed(poses.headingRad(1))), 1e-9);
    assertEquals("1.0 2.0 3.0", poses.xM(1) + " " + poses.yM(1) + " " + poses.zM(1));
    assertEquals(x, poses.directionX(1));
    assertEquals(y, poses.directionY(1));
    assertEquals(z, poses.directionZ(1));
    assertEquals(0, poses.xM(0), "the other one stays where it was");
  }

  @Test
  void reset_ofASensorWithoutMemory_doesNothing() {
    Sensor sensor = (poses, timeS, readings) -> readings.clear();
    sensor.reset();
    sensor.ping(new TransducerPoses(0), 0, new Readings(0));
  }
}
