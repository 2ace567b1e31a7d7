package simbad.gap.audit;

/** The checks of the audit, by the word that stands in files. */
public enum AuditCheck {
  /** A figure of the scene that no sonar in air has. */
  CONSTANT("constant"),
  /** Ranges beyond what the sensor measures. */
  RANGE_LIMIT("range-limit"),
  /** Ranges that are a multiple of what the scene says. */
  UNIT("unit"),
  /** A number that stands for no echo. */
  NO_ECHO_CODE("no-echo-code"),
  /** One value much more often than its neighbours, where the scene expects others. */
  PILE("pile"),
  /** Ranges that start again from 0. */
  WRAP("wrap"),
  /** One value that stays, whatever the sensor looks at. */
  STUCK("stuck"),
  /** The last value again and again. */
  HELD("held"),
  /** Single readings that are off by one and the same amount. */
  JUMP("jump"),
  /** Times that go back or stand twice. */
  CLOCK("clock"),
  /** Times between pings that are not the sensor's. */
  PERIOD("period"),
  /** Sensors inside obstacles. */
  INSIDE("inside"),
  /** Poses that never change though readings do. */
  STILL("still"),
  /** Poses in another frame or unit than the scene. */
  AXES("axes");

  private final String word;

  AuditCheck(String word) {
    this.word = word;
  }

  /** Returns the word as it stands in files. */
  public String word() {
    return word;
  }
}
