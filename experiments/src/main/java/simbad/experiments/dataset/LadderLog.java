package simbad.experiments.dataset;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.frame.Pose;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.ReadingRow;

/**
 * A ladder of distances: a sensor squarely before a board, columns {@code true_cm, reading_cm} and
 * perhaps {@code set, note}; rows without a true distance are left out.
 *
 * <p>What the log does not say: the board is 1.2 m wide; pings follow every 60 ms; the sensor is an
 * HC-SR04 by its data sheet (15 degrees to each side, 2 cm to 4 m, 3 mm) that gives unrounded
 * ranges. The believed speed of sound is the one with which the author turned times into
 * centimetres; it changes nothing but the fitted speed's value.
 */
public final class LadderLog {
  private static final String SET = "set";
  private static final String NOTE = "note";
  private static final double CM = 100;
  private static final double BOARD_M = 1.2;
  private static final double HEARD_M = 10;
  private static final double PERIOD_S = 0.06;
  private static final double LOOKS_DOWN_THE_Z_AXIS = Math.PI / 2;

  private LadderLog() {}

  /**
   * Which rows of a log are converted.
   *
   * @param set those of this set; empty for those of any, of a log that may have no such column
   * @param skip but those with this note; empty for all, of a log that may have no such column
   */
  public record Rows(Optional<String> set, Optional<String> skip) {
    private LogTable read(Path file) throws DataFormatException {
      List<String> columns = new ArrayList<>(List.of("true_cm", "reading_cm"));
      set.ifPresent(any -> columns.add(SET));
      skip.ifPresent(any -> columns.add(NOTE));
      return LogTable.read(file, columns.toArray(String[]::new));
    }

    private boolean has(LogTable log, int row) {
      return set.filter(wanted -> !log.text(row, SET).equals(wanted)).isEmpty()
          && skip.filter(log.text(row, NOTE)::equals).isEmpty()
          && !log.text(row, "true_cm").isEmpty();
    }

    @Override
    public String toString() {
      return "row" + set.map(name -> " of set '" + name + "'").orElse("");
    }
  }

  /**
   * Converts a log; a row's note, where there is one, is the name of its run.
   *
   * @param file csv
   * @param which rows
   * @param soundSpeedMPerS with which its author computed ranges
   * @throws DataFormatException naming file, line and field of the first fault
   */
  public static MadeDataSet read(Path file, Rows which, double soundSpeedMPerS)
      throws DataFormatException {
    LogTable log = which.read(file);
    List<ReadingRow> rows = new ArrayList<>();
    for (int row = 0; row < log.size(); row++) {
      if (which.has(log, row)) {
        rows.add(
            new ReadingRow(
                log.label(row, NOTE),
                "HC-SR04",
                rows.size() * PERIOD_S,
                Pose.of(0, log.number(row, "true_cm") / CM, LOOKS_DOWN_THE_Z_AXIS),
                new Echo(log.number(row, "reading_cm") / CM)));
      }
    }
    if (rows.isEmpty()) {
      throw log.fault("has no " + which + " with a true distance");
    }
    return new MadeDataSet(setup(soundSpeedMPerS), rows);
  }

  private static SensingSetup setup(double soundSpeedMPerS) {
    SonarSpec sensor =
        new SonarSpec(
            "HC-SR04",
            Math.toRadians(15),
            0.02,
            4,
            0.5,
            soundSpeedMPerS,
            0,
            0.003,
            0.005,
            0.05,
            PERIOD_S);
    return new SensingSetup(
        sensor, new Scene(List.of(Shapes.board("board", 0, BOARD_M, HEARD_M))), 4);
  }
}
