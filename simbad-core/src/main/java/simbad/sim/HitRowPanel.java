package simbad.sim;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.util.function.IntPredicate;
import javax.swing.JPanel;

/** A row of squares, filled where a sensor has a hit. */
final class HitRowPanel extends JPanel {
  private static final int SQUARE = 12;

  private final int count;
  private final transient IntPredicate hit;

  HitRowPanel(int count, IntPredicate hit) {
    this.count = count;
    this.hit = hit;
    setPreferredSize(new Dimension((count + 1) * SQUARE, 2 * SQUARE));
  }

  @Override
  protected void paintComponent(Graphics graphics) {
    super.paintComponent(graphics);
    for (int i = 0; i < count; i++) {
      int x = SQUARE / 2 + i * SQUARE;
      graphics.setColor(hit.test(i) ? Color.RED : Color.LIGHT_GRAY);
      graphics.fillRect(x, SQUARE / 2, SQUARE - 2, SQUARE - 2);
    }
  }
}
