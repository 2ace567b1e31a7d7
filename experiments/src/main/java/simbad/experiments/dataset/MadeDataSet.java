package simbad.experiments.dataset;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import simbad.gap.diagnosis.DataSetFolder;
import simbad.sonar.format.ReadingsWriter;
import simbad.sonar.format.SceneWriter;
import simbad.sonar.format.TextFile;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.ReadingRow;

/**
 * A data set that is not yet in a folder.
 *
 * @param setup what the simulator believes
 * @param readings what was read
 * @param further columns that nothing reads, by their names; a cell for each reading
 */
public record MadeDataSet(
    SensingSetup setup, List<ReadingRow> readings, Map<String, List<String>> further) {
  /** Copies the collections in their order. */
  public MadeDataSet {
    readings = List.copyOf(readings);
    further = Collections.unmodifiableMap(new LinkedHashMap<>(further));
  }

  /** Creates one of readings alone. */
  public MadeDataSet(SensingSetup setup, List<ReadingRow> readings) {
    this(setup, readings, Map.of());
  }

  /**
   * Writes its files.
   *
   * @param folder exists and is empty
   * @throws IOException if something cannot be written
   */
  public void write(Path folder) throws IOException {
    save(folder.resolve(DataSetFolder.SCENE), SceneWriter.text(setup));
    save(folder.resolve(DataSetFolder.READINGS), ReadingsWriter.text(readings, further));
  }

  private static void save(Path file, String text) throws IOException {
    TextFile.write(file, text);
  }
}
