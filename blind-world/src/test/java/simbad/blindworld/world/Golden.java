package simbad.blindworld.world;

import java.io.IOException;
import java.nio.file.Path;
import simbad.blindworld.baseline.DataSet;
import simbad.blindworld.file.Csv;
import simbad.blindworld.file.FormatException;

/**
 * The format's golden scenes and rows (part of the format's description, computed by its authors).
 */
final class Golden {

  static final Path FOLDER = Path.of("src/test/resources/golden");

  private Golden() {}

  static Scene scene(String name) throws IOException, FormatException {
    return DataSet.scene(FOLDER.resolve(name + ".scene.json"));
  }

  static Recording rows(String name) throws IOException, FormatException {
    return DataSet.rows(Csv.read(FOLDER.resolve(name + ".rows.csv")));
  }
}
