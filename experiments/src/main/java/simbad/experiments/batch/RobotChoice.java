package simbad.experiments.batch;

import java.nio.file.Path;
import java.util.Optional;
import simbad.experiments.run.DiagnosedFolder;
import simbad.experiments.run.RobotKind;
import simbad.experiments.run.SensorKind;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.JsonInput;

/**
 * A robot of a batch.
 *
 * @param label how it is called
 * @param robot how it moves; empty: as it is told
 */
record RobotChoice(String label, Optional<RobotKind> robot) {
  static final String DIMENSION = "robots";

  /** The robot that does what it is told. */
  static final String TOLD = "told";

  static final RobotChoice AS_TOLD = new RobotChoice(TOLD, Optional.empty());

  /** The file or folder that the spec names; empty for a robot that does what it is told. */
  static Optional<Path> path(JsonInput where) throws DataFormatException {
    if (where.text().equals(TOLD)) {
      return Optional.empty();
    }
    String text = DiagnosedFolder.in(where.text()).orElse(where.text());
    return Optional.of(InputPlace.name(where, text));
  }

  static RobotChoice read(JsonInput where, int position, InputPlace place)
      throws DataFormatException {
    Optional<Path> path = path(where);
    if (path.isEmpty()) {
      return AS_TOLD;
    }
    Path own = place.of(DIMENSION, position, path.get());
    RobotKind robot =
        DiagnosedFolder.in(where.text()).isPresent()
            ? RobotKind.diagnosed(own)
            : RobotKind.believed(own);
    return new RobotChoice(robot.name(), Optional.of(robot));
  }

  SensorKind under(SensorKind sensor) {
    return robot.map(sensor::on).orElse(sensor);
  }
}
