package simbad.gap.audit;

import java.util.ArrayList;
import java.util.List;
import simbad.gap.audit.AuditFinding.File;
import simbad.sonar.scene.SonarSpec;

/** The scene's figures against what a sonar in air can have. */
final class ConstantCheck {
  /** Sound in air of -40 and 60 degrees: 331.3 sqrt(1 + T/273.15), metres per second. */
  static final double SLOWEST = 306;

  static final double FASTEST = 366;

  /** Wrong by more than this factor is no wrong constant of sound-speed any more. */
  static final double FACTOR = 5;

  private static final double SOUND = 343;

  /** Further no ultrasonic sensor hears in air; so thresholds are limited as well. */
  static final double FURTHEST_M = 100;

  /** A narrower beam of 40 kHz takes an aperture of half a metre: 0.5 wavelengths / sin. */
  private static final double NARROWEST_DEG = 0.5;

  private final SonarSpec sensor;
  private final List<AuditFinding> found = new ArrayList<>();

  private ConstantCheck(SonarSpec sensor) {
    this.sensor = sensor;
  }

  static List<AuditFinding> of(SonarSpec sensor) {
    ConstantCheck check = new ConstantCheck(sensor);
    check.soundSpeed();
    check.beam();
    check.reach();
    return check.found;
  }

  private void soundSpeed() {
    double speed = sensor.assumedSoundSpeedMPerS();
    if (speed >= SLOWEST && speed <= FASTEST) {
      return;
    }
    boolean impossible = !(speed >= SOUND / FACTOR && speed <= SOUND * FACTOR);
    add(
        "assumed_sound_speed_m_s = " + Say.number(speed) + ", sound in air has 306 to 366 m/s",
        "write the speed with which the program computes its ranges, 343 at 20 degrees",
        impossible ? Severity.REFUSE : Severity.WARN);
  }

  private void beam() {
    double deg = Math.toDegrees(sensor.coneHalfAngleRad());
    if (deg < NARROWEST_DEG) {
      add(
          "cone_half_angle_deg = " + Say.number(deg) + ", which no small transducer reaches",
          "write it in degrees; it may be radians",
          Severity.WARN);
    }
  }

  private void reach() {
    if (sensor.maxRangeM() > FURTHEST_M) {
      add(
          "max_range_m = " + Say.number(sensor.maxRangeM()) + ", no sonar hears so far in air",
          "write it in metres",
          Severity.WARN);
    }
  }

  private void add(String what, String suggestion, Severity severity) {
    found.add(
        new AuditFinding(
            AuditCheck.CONSTANT, File.SCENE, what, List.of(), suggestion, "", severity));
  }
}
