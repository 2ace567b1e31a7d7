package simbad.experiments.dataset;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;

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
  private static final String TRUE = "true_cm";
  private static final double BOARD_M = 1.2;
  private static final double HEARD_M = 10;
  private static final double PERIOD_S = 0.06;

  private LadderLog() {}

  /**
   * Which rows of a log are converted.
   *
   * @param set those of this set; empty for those of any, of a log that may have no such column
   * @param skip but those with this note; empty for all, of a log that may have no such column
   */
  public record Rows(Optional<String> set, Optional<String> skip) {
    private List<RowRule> rules(LogTable log) throws DataFormatException {
      List<RowRule> rules = new ArrayList<>();
      if (set.isPresent()) {
        rules.add(RowRule.word(LogColumns.require(log, SET), set.get(), true));
      }
      if (skip.isPresent()) {
        rules.add(RowRule.word(LogColumns.require(log, NOTE), skip.get(), false));
      }
      return rules;
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
    LogTable log = LogTable.read(file, LogFormat.PLAIN);
    LoggedFigure distance = LoggedFigure.column(LogColumns.require(log, TRUE), Unit.CM, 0);
    int reading = LogColumns.require(log, "reading_cm");
    OptionalInt note = LogColumns.find(log, NOTE);
    LogRows rows = new LogRows();
    LogRows.Labels labels = LogRows.Labels.of("");
    rows.take(
        log,
        new LogRows.Plan(
            which.rules(log),
            List.of(new LogRows.Range(reading, "HC-SR04")),
            new RangeRule(Unit.CM, soundSpeedMPerS, NoEchoCodes.NONE),
            PoseRule.ladder(distance, LoggedFigure.constant(0, Unit.M), 0),
            Clock.ofTaken(PERIOD_S),
            note.isPresent() ? labels.withRun(note.getAsInt()) : labels,
            Map.of()),
        false);
    if (rows.rows().isEmpty()) {
      throw log.fault("has no " + which + " with a true distance");
    }
    return new MadeDataSet(setup(soundSpeedMPerS), rows.rows());
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
