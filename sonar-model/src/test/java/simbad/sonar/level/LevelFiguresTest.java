package simbad.sonar.level;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.sonar.fixture.Levels;
import simbad.sonar.fixture.Refusal;

class LevelFiguresTest {
  private static final double CONE_RAD = Math.toRadians(27.5);

  @Test
  void none_isDefaultsAndTheSensorsOwnFigures() {
    LevelLaw law = LevelFigures.NONE.law(CONE_RAD, 0.007);
    assertEquals(33.75, law.levelDb());
    assertEquals(1.5, law.spreadingExponent());
    assertEquals(1.32, law.absorptionDbPerM(), 0.005);
    assertEquals(40 * Math.log10(0.5), law.beam().twoWayDb(CONE_RAD), 1e-3);
    assertEquals(0.5, law.excessSdDb());
    assertEquals(Curve.constant(0.007), law.noiseM());
    assertEquals(343.2 * 0.0002 / 2, law.pulseLengthM(), 1e-5);
    assertEquals(11, LevelFigures.NONE.missing().size());
  }

  /** 20 log10(1 + 24 exp(-r / 0.3003 m)). */
  @Test
  void defaultReceiver_recovers() {
    Curve receiver = LevelDefaults.RECEIVER_THRESHOLD_DB;
    assertEquals(27.96, receiver.at(0));
    assertEquals(10.455, receiver.at(0.7), 0.006);
    assertEquals(0.1, receiver.at(2.294), 0.02);
    assertEquals(0.01, receiver.at(9), 0.01);
  }

  /** Half a burst of 8 cycles of 25 us, all of it at the threshold, a tenth 20 dB above. */
  @Test
  void defaultWalk_isThatOfARisingBurst() {
    assertEquals(0.0343, LevelDefaults.WALK_M.at(0), 1e-4);
    assertEquals(0.0343, LevelDefaults.WALK_M.at(-9), 1e-4);
    assertEquals(0.0343 / 2, LevelDefaults.WALK_M.at(6), 1e-4);
    assertEquals(0.0343 / 10, LevelDefaults.WALK_M.at(20), 1e-4);
    assertTrue(LevelDefaults.WALK_M.at(99) < 0.001);
  }

  @Test
  void stated_isTaken() {
    LevelFigures figures =
        Levels.figures(
            """
            "frequency_hz": 49400, "spreading_exponent": 2, "absorption_db_per_m": 0.9,
            "temperature_c": 0, "beam": {"aperture_radius_m": 0.0194},
            "receiver_threshold_db": [[0, 20], [1, 0]], "excess_sd_db": 2, "walk_m": [[0, 0.01]],
            "noise_m": [[0, 0.02], [10, 0.01]], "pulse_length_s": 0.0005, "level_db": 12
            """);
    LevelLaw law = figures.law(CONE_RAD, 0.007);
    double k = 2 * Math.PI * 49_400 / 331.3;
    assertEquals(
        new LevelLaw(
            12,
            2,
            0.9,
            PistonBeam.of(0.0194, k),
            Curve.of(0, 20, 1, 0),
            2,
            Curve.constant(0.01),
            Curve.of(0, 0.02, 10, 0.01),
            331.3 * 0.0005 / 2),
        law);
    assertEquals(List.of(), figures.missing());
  }

  /** Colder air is slower and, at this humidity, absorbs less: one cause, two figures. */
  @Test
  void temperature_changesSpeedAndAbsorption() {
    LevelLaw cold =
        Levels.figures("\"temperature_c\": 0, \"humidity_percent\": 50").law(CONE_RAD, 0.004);
    LevelLaw warm =
        Levels.figures("\"temperature_c\": 20, \"humidity_percent\": 50").law(CONE_RAD, 0.004);
    assertEquals(0.45, cold.absorptionDbPerM(), 0.005);
    assertEquals(1.32, warm.absorptionDbPerM(), 0.005);
    assertTrue(cold.pulseLengthM() < warm.pulseLengthM());
    assertEquals(
        List.of("humidity_percent"),
        Levels.figures("\"temperature_c\": 3").missing().subList(2, 3));
  }

  @Test
  void beam_ofAConeThatLooksBehindItself_isEverywhere() {
    assertEquals(Beam.everywhere(), LevelFigures.NONE.law(Math.PI / 2, 0.004).beam());
  }

  @Test
  void beam_asACurve() {
    LevelFigures figures = Levels.figures("\"beam\": {\"two_way_db\": [[0, 0], [30, -12]]}");
    assertEquals(-6, figures.law(CONE_RAD, 0).beam().twoWayDb(Math.toRadians(15)), 1e-9);
    Refusal.check(
        () ->
            new LevelFigures(
                figures.frequencyHz(),
                figures.spreadingExponent(),
                figures.absorptionDbPerM(),
                figures.temperatureC(),
                figures.humidityPercent(),
                java.util.OptionalDouble.of(0.007),
                figures.twoWayDb(),
                figures.receiverThresholdDb(),
                figures.excessSdDb(),
                figures.walkM(),
                figures.noiseM(),
                figures.pulseLengthS(),
                figures.levelDb()),
        "apertureRadiusM = 0.007 beside a curve");
  }
}
