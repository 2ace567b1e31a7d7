package simbad.experiments.bag;

/**
 * A sensor_msgs/msg/Range.
 *
 * @param topic on which it was sent
 * @param frame in which the sensor looks along x
 * @param stampNs when, nanoseconds
 * @param fieldRad the whole angle in which it hears
 * @param leastM least range that is valid, metres
 * @param mostM greatest range that is valid, metres
 * @param rangeM what was read; infinite or no number by REP-117
 */
record RangeMessage(
    String topic,
    String frame,
    long stampNs,
    float fieldRad,
    float leastM,
    float mostM,
    float rangeM) {

  /** What a reading means by REP-117 and by the message's own definition. */
  enum Meaning {
    /** A range. */
    ECHO,
    /** Nothing in range. */
    NOTHING,
    /** Something nearer than can be measured. */
    TOO_NEAR,
    /** Not a reading. */
    INVALID
  }

  /** Returns what it means; a range outside what is valid is none. */
  Meaning meaning() {
    if (Float.isNaN(rangeM)) {
      return Meaning.INVALID;
    }
    if (rangeM < leastM) {
      return Meaning.TOO_NEAR;
    }
    return rangeM > mostM || rangeM == Float.POSITIVE_INFINITY ? Meaning.NOTHING : Meaning.ECHO;
  }
}
