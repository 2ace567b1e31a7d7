package simbad.experiments.report;

import simbad.experiments.plot.Figure;
import simbad.obstacles.ObstacleType;

/** The polar plot of a threshold table. */
public final class TablePicture {
  private TablePicture() {}

  /**
   * Draws a table.
   *
   * @param type obstacle with its table
   */
  public static Figure of(ObstacleType type) {
    return RunPictures.table(type);
  }
}
