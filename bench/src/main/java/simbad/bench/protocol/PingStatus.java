package simbad.bench.protocol;

import java.util.Arrays;
import java.util.Optional;

/** What the firmware makes of a ping. */
public enum PingStatus {
  /** Something answered. */
  ECHO("echo"),
  /** The sensor listened to the end and nothing answered. */
  NO_ECHO("no-echo"),
  /** No pulse came, or none ended. */
  STUCK("stuck"),
  /** Something answered from nearer than the sensor measures. */
  TOO_NEAR("too-near");

  private final String word;

  PingStatus(String word) {
    this.word = word;
  }

  /** Returns the word on the line, as in docs/protocol.csv. */
  public String word() {
    return word;
  }

  /**
   * Finds the status that a word means.
   *
   * @param word as in docs/protocol.csv
   */
  public static Optional<PingStatus> find(String word) {
    return Arrays.stream(values()).filter(status -> status.word.equals(word)).findFirst();
  }
}
