package simbad.experiments.run;

import java.util.ArrayList;
import java.util.List;
import simbad.sonar.check.Checks;

/**
 * A share at every cell of a square grid whose middle is the obstacle's centre, in the obstacle's
 * frame.
 *
 * @param cells how many cells to a side, at least 1
 * @param halfWidthM half the side in metres; finite, above 0
 * @param shares in [0, 1], one a cell, row by row: along +x within a row, the rows along +z
 */
public record ShareGrid(int cells, double halfWidthM, List<Double> shares) {
  /** Checks the numbers and copies the list. */
  public ShareGrid {
    Checks.positive("halfWidthM", halfWidthM);
    shares = List.copyOf(shares);
    if (cells < 1 || shares.size() != cells * cells) {
      throw new IllegalArgumentException(
          shares.size() + " shares do not fill " + cells + " x " + cells + " cells");
    }
    for (double share : shares) {
      Checks.share("share", share);
    }
  }

  /** Asks for the share at the middle of every cell. */
  public static ShareGrid of(int cells, double halfWidthM, ShareAt shareAt) {
    List<Double> shares = new ArrayList<>(Math.max(0, cells) * Math.max(0, cells));
    for (int row = 0; row < cells; row++) {
      for (int column = 0; column < cells; column++) {
        double xM = middleM(column, cells, halfWidthM);
        shares.add(shareAt.share(xM, middleM(row, cells, halfWidthM)));
      }
    }
    return new ShareGrid(cells, halfWidthM, shares);
  }

  private static double middleM(int index, int cells, double halfWidthM) {
    return halfWidthM * ((2 * index + 1.0) / cells - 1);
  }

  /**
   * Returns the offset of the middle of a column or row from the obstacle's centre, metres.
   *
   * @param index of the column or row, from 0
   */
  public double centreM(int index) {
    return middleM(index, cells, halfWidthM);
  }

  /** Returns the share at a cell. */
  public double share(int column, int row) {
    return shares.get(row * cells + column);
  }

  /** A share by place. */
  @FunctionalInterface
  public interface ShareAt {
    /**
     * The share at an offset from the obstacle's centre, in its frame.
     *
     * @return a number in [0, 1]
     */
    double share(double xM, double zM);
  }
}
