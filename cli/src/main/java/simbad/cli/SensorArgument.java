package simbad.cli;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import simbad.experiments.run.SensorKind;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.SceneFile;
import simbad.sonar.predict.ModelFile;
import simbad.sonar.scene.SensingSetup;

/** A sensor on the command line: a name, or a diagnosis' folder. */
final class SensorArgument {
  private static final String DIAGNOSED = "diagnosed:";

  private SensorArgument() {}

  /**
   * Reads a sensor.
   *
   * @param word of the command line
   * @return empty for a word that names no sensor
   * @throws DataFormatException if a diagnosis' files are missing or wrong
   */
  static Optional<SensorKind> parse(String word) throws DataFormatException {
    if (!word.startsWith(DIAGNOSED)) {
      return SensorKind.find(word);
    }
    Path folder = Path.of(word.substring(DIAGNOSED.length()));
    SensingSetup setup = SceneFile.read(folder.resolve("scene.json"));
    Path name = folder.toAbsolutePath().normalize().getFileName();
    return Optional.of(
        SensorKind.diagnosed(
            name == null ? "" : name.toString(),
            ModelFile.read(folder.resolve("model.json"), setup)));
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
