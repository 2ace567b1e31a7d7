package simbad.figures.report;

import simbad.experiments.run.Trace;
import simbad.figures.plot.PlotFigure;
import simbad.obstacles.ObstacleType;

/** The polar plot of a threshold table. */
public final class TablePicture {
  private TablePicture() {}

  /**
   * Draws a table.
   *
   * @param type obstacle with its table
   */
  public static PlotFigure of(ObstacleType type) {
    return RunPictures.table(type);
  }

  /**
   * Draws two tables over each other.
   *
   * @param first obstacle with its table, whose outline is drawn
   * @param second another, drawn as a broad line beneath
   */
  public static PlotFigure of(ObstacleType first, ObstacleType second) {
    return RunPictures.tables(first, second);
  }

  /**
   * Draws a table with a trace over it.
   *
   * @param type obstacle with its table
   * @param name of the trace in the legend
   * @param trace in the obstacle's frame
   */
  public static PlotFigure of(ObstacleType type, String name, Trace trace) {
    return RunPictures.table(type, name, trace);
  }
}
