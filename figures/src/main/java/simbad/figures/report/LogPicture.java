package simbad.figures.report;

import java.util.ArrayList;
import java.util.List;
import simbad.figures.plot.Caption;
import simbad.figures.plot.PlotFigure;
import simbad.figures.plot.PolarPlot;
import simbad.figures.plot.PolarPoint;
import simbad.figures.plot.PolarSeries;
import simbad.figures.plot.SeriesRole;
import simbad.figures.plot.SeriesStyle;
import simbad.gap.diagnosis.DataSet;
import simbad.sonar.frame.Pose;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.ReadingRow;
import simbad.sonar.shape.Outline;

/**
 * What was understood of a log, seen from above: where the sensors were, and the places that the
 * echoes tell of, a range ahead of each sensor. A mirrored axis or a wrong angle is seen at a
 * glance.
 */
public final class LogPicture {
  private LogPicture() {}

  /**
   * Draws a data set.
   *
   * @param data that was made of a log
   * @param source what is said of where it is from
   */
  public static PlotFigure of(DataSet data, String source) {
    List<PolarPoint> places = new ArrayList<>();
    List<PolarPoint> echoes = new ArrayList<>();
    for (ReadingRow row : data.readings()) {
      Pose pose = row.pose();
      places.add(PolarPoint.ofOffset(pose.position().xM(), pose.position().zM()));
      if (row.reading() instanceof Echo echo) {
        echoes.add(ahead(pose, echo.rangeM()));
      }
    }
    List<PolarSeries> series = new ArrayList<>();
    series.add(points("where the sensors were", SeriesRole.OTHER, places));
    series.add(points("where each echo came from, straight ahead", SeriesRole.ORIGINAL, echoes));
    for (Obstacle obstacle : data.setup().scene().obstacles()) {
      series.add(outline(obstacle, series.size()));
    }
    return new PolarPlot(
            new Caption("Sensors and echoes in " + data.name(), source), series, List.of())
        .figure();
  }

  private static PolarSeries points(String name, SeriesRole role, List<PolarPoint> points) {
    return new PolarSeries(name, role, SeriesStyle.POINTS, points);
  }

  private static PolarPoint ahead(Pose pose, double rangeM) {
    double heading = pose.heading().radians();
    return PolarPoint.ofOffset(
        pose.position().xM() + rangeM * Math.cos(heading),
        pose.position().zM() - rangeM * Math.sin(heading));
  }

  private static PolarSeries outline(Obstacle obstacle, int number) {
    Outline placed = obstacle.outline().placed(obstacle.worldFromObstacle());
    List<PolarPoint> corners =
        placed.corners().stream()
            .map(corner -> PolarPoint.ofOffset(corner.xM(), corner.zM()))
            .toList();
    return new PolarSeries(
        "obstacle " + (number - 1) + ": " + obstacle.name(),
        SeriesRole.TABLE,
        SeriesStyle.CLOSED_LINE,
        corners);
  }
}
