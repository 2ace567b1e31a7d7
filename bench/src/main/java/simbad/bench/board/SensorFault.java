package simbad.bench.board;

/** What may be wrong with the sensor's line. */
public enum SensorFault {
  /** Nothing. */
  NONE("none"),
  /** No echo ever, whatever stands there. */
  NO_ECHO("no-echo"),
  /** The echo line stays high. */
  STUCK_HIGH("high"),
  /** The echo line stays low. */
  STUCK_LOW("low");

  private final String order;

  SensorFault(String order) {
    this.order = order;
  }

  String order() {
    return order;
  }
}
