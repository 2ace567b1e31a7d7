package simbad.figures.diagnosis;

import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import simbad.figures.page.Numbers;
import simbad.gap.diagnosis.DataSet;
import simbad.sonar.frame.Angles;
import simbad.sonar.frame.Point;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.sensing.ReadingRow;

/** What it costs that a log has no reference, or one that was taken elsewhere. */
final class ReferenceWords {
  /** So many rows are enough to calibrate the level law. */
  private static final int ENOUGH_ROWS = 700;

  private static final double SECONDS = 60;
  private static final double SECTOR_RAD = Math.toRadians(15);
  private static final double HALF_OCTAVES = 2;

  /** Fewer rows elsewhere are no matter. */
  private static final double WORTH_SAYING = 0.05;

  private ReferenceWords() {}

  /** A place as seen from the nearest obstacle: a sector of its bearings, half an octave of way. */
  private record Spot(int obstacle, int sector, int distance) {}

  /** Returns what to say of a log's reference; empty where it says all. */
  static Optional<String> of(DataSet data) {
    return data.reference().isEmpty() ? Optional.of(missing(data.readings())) : elsewhere(data);
  }

  private static String missing(List<ReadingRow> rows) {
    return "There is no reference. How far this set-up was off while the simulation was still"
        + " trusted is not known, and counts as an effect here: of twelve physical sets that were"
        + " taken all round obstacles none was answered rightly without one. "
        + enough(rows)
        + " of the same set-up from such a time, at many distances and bearings, would settle it.";
  }

  private static String enough(List<ReadingRow> rows) {
    double last = rows.stream().mapToDouble(ReadingRow::timeS).max().orElse(0);
    double first = rows.stream().mapToDouble(ReadingRow::timeS).min().orElse(0);
    boolean timed = last > first && rows.stream().allMatch(ReadingRow::isTimed);
    double minutes = (last - first) / rows.size() * ENOUGH_ROWS / SECONDS;
    return timed
        ? minutes <= 1
            ? "A minute of readings"
            : "Some " + Numbers.fixed(Math.ceil(minutes), 0) + " minutes of readings"
        : ENOUGH_ROWS + " readings";
  }

  private static Optional<String> elsewhere(DataSet data) {
    List<Obstacle> obstacles = data.setup().scene().obstacles();
    if (obstacles.isEmpty()) {
      return Optional.empty();
    }
    Set<Spot> seen = new HashSet<>();
    data.reference().forEach(row -> seen.add(spot(obstacles, row)));
    double unseen =
        data.readings().stream().filter(row -> !seen.contains(spot(obstacles, row))).count()
            / (double) data.readings().size();
    return unseen < WORTH_SAYING
        ? Optional.empty()
        : Optional.of(
            Numbers.percent(unseen, 0)
                + " of the readings come from bearings and distances (15 degrees, half an octave)"
                + " at which the reference has none. More is allowed there, and less is sure.");
  }

  private static Spot spot(List<Obstacle> obstacles, ReadingRow row) {
    Point at = row.pose().position();
    Obstacle nearest =
        obstacles.stream()
            .min(
                Comparator.comparingDouble(
                    one -> one.worldFromObstacle().centreDistanceM(at.xM(), at.zM())))
            .orElseThrow();
    double bearing = nearest.worldFromObstacle().bearingRad(at.xM(), at.zM());
    double distance = nearest.worldFromObstacle().centreDistanceM(at.xM(), at.zM());
    return new Spot(
        obstacles.indexOf(nearest),
        (int) (Angles.positive(bearing) / SECTOR_RAD),
        (int) Math.floor(HALF_OCTAVES * Math.log(Math.max(1e-3, distance)) / Math.log(2)));
  }
}
