package simbad.gui;

import java.awt.Dimension;
import java.awt.Rectangle;
import javax.swing.JInternalFrame;
import org.jspecify.annotations.Nullable;

/**
 * Where the windows of a simulation stand: the world on the left, as large as it can be, what
 * inspects and controls it in a column on the right.
 *
 * @param world takes what is left
 * @param inspector stands above the control; null if there is none
 * @param control stands at the foot of the column; null if there is none
 */
record Tiling(
    JInternalFrame world, @Nullable JInternalFrame inspector, @Nullable JInternalFrame control) {
  private static final int LEAST_COLUMN = 320;

  /** A world is not worth looking at when it is narrower. */
  private static final int LEAST_WORLD = 300;

  /** Arranges the windows on a desktop of a given size. */
  void arrange(Dimension desktop) {
    int column = inspector == null && control == null ? 0 : columnWidth(desktop.width);
    int left = desktop.width - column;
    int foot = control == null ? 0 : Math.min(control.getPreferredSize().height, desktop.height);
    world.setBounds(new Rectangle(0, 0, left, desktop.height));
    place(inspector, new Rectangle(left, 0, column, desktop.height - foot));
    place(control, new Rectangle(left, desktop.height - foot, column, foot));
  }

  private int columnWidth(int width) {
    int wanted = control == null ? LEAST_COLUMN : control.getPreferredSize().width;
    return Math.max(1, Math.min(Math.max(LEAST_COLUMN, wanted), width - LEAST_WORLD));
  }

  private static void place(@Nullable JInternalFrame window, Rectangle bounds) {
    if (window != null) {
      window.setBounds(bounds);
    }
  }
}
