package simbad.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import simbad.experiments.dataset.MadeDataSet;
import simbad.experiments.dataset.TableGrid;
import simbad.obstacles.Catalogue;
import simbad.sonar.frame.Pose;
import simbad.sonar.model.NominalModel;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.Reading;
import simbad.sonar.sensing.ReadingRow;

/** Small data sets round the original sensor's post, that are quick to diagnose. */
final class BenchData {
  private static final MadeDataSet GRID =
      TableGrid.of(
          Catalogue.find("round").orElseThrow(), Catalogue.srf04(), new SplittableRandom(2));

  static final SensingSetup SETUP = GRID.setup();

  private BenchData() {}

  /** Readings as the simulator expects them, every echo longer by an offset. */
  static List<ReadingRow> rows(int count, double offsetM) {
    NominalModel model = new NominalModel(SETUP.sensor(), SETUP.scene());
    SplittableRandom random = new SplittableRandom(5);
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      Pose pose = GRID.readings().get(i).pose();
      Reading reading = model.distribution(pose).sample(random);
      Reading real = reading instanceof Echo echo ? new Echo(echo.rangeM() + offsetM) : reading;
      rows.add(new ReadingRow("run " + i % 2, "S", i, pose, real));
    }
    return rows;
  }

  /** Writes a data set's folder. */
  static Path write(Path folder, List<ReadingRow> rows) throws IOException {
    Files.createDirectories(folder);
    new MadeDataSet(SETUP, rows).write(folder);
    return folder;
  }
}
