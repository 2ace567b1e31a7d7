package simbad.experiments.dataset;

import simbad.sonar.format.DataFormatException;

/** Whoever knows what a log does not say: a person at a terminal, or nobody. */
@FunctionalInterface
public interface Questions {
  /** Nobody is there: what is missing is said in one line. */
  Questions NOBODY =
      (option, question, seen) -> {
        throw LogSettings.fault(option, "is missing: " + question + "; saw " + seen);
      };

  /**
   * Asks.
   *
   * @param option that would have said it
   * @param question in a few words
   * @param seen what the log shows
   * @return the option's value
   * @throws DataFormatException if nobody answers
   */
  String ask(String option, String question, String seen) throws DataFormatException;
}
