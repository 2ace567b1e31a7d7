package simbad.cli;

import java.util.List;
import java.util.Optional;
import simbad.experiments.run.SensorKind;
import simbad.sonar.format.DataFormatException;

/** A sensor on the command line: a name, or a diagnosis' folder. */
final class SensorArgument {
  private SensorArgument() {}

  /**
   * Reads a sensor.
   *
   * @param word of the command line
   * @return empty for a word that names no sensor
   * @throws DataFormatException if a diagnosis' files are missing or wrong
   */
  static Optional<SensorKind> parse(String word) throws DataFormatException {
    return SensorKind.read(word);
  }

  /** What to say of a word that names no sensor. */
  static String unknown(String word) {
    List<String> known = List.of(SensorKind.words().split(", "));
    return "'"
        + word
        + "' is not one of "
        + SensorKind.words()
        + SimilarWords.suggestion(word, known);
  }
}
