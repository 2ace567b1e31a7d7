package simbad.bench.protocol;

import java.util.Arrays;
import java.util.Optional;

/** How the firmware reports its pings. */
public enum FirmwareMode {
  /** Lines with number, microseconds, status and checksum. */
  FRAME("frame", 1),
  /** What the thesis's listing printed: steps of 2 cm, neither numbered nor protected. */
  THESIS("thesis", ThesisLine.STEP_US);

  private final String word;
  private final double stepUs;

  FirmwareMode(String word, double stepUs) {
    this.word = word;
    this.stepUs = stepUs;
  }

  /** Returns the word of the command that turns to it, as in docs/protocol.csv. */
  public String word() {
    return word;
  }

  /** Returns the step of the times that it reports, in microseconds. */
  public double stepUs() {
    return stepUs;
  }

  /**
   * Finds the mode that a word means.
   *
   * @param word as in docs/protocol.csv
   */
  public static Optional<FirmwareMode> find(String word) {
    return Arrays.stream(values()).filter(mode -> mode.word.equals(word)).findFirst();
  }
}
