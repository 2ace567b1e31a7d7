package simbad.bench.board;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/** Resets that can be brought about from outside, spelt as in docs/protocol.csv. */
public enum ResetCause {
  /** The supply is switched on. */
  POWER_ON,
  /** The supply fell for a moment. */
  BROWN_OUT,
  /** The watchdog ran out. */
  WATCHDOG,
  /** The reset pin was pulled low. */
  MASTER_CLEAR;

  /** Returns the word of docs/protocol.csv. */
  public String word() {
    return name().toLowerCase(Locale.ROOT).replace('_', '-');
  }

  static Optional<ResetCause> find(String word) {
    return Arrays.stream(values()).filter(cause -> cause.word().equals(word)).findFirst();
  }
}
