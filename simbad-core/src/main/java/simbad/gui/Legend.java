package simbad.gui;

import java.awt.Dimension;
import java.awt.FlowLayout;
import java.util.Arrays;
import java.util.Set;
import javax.swing.JLabel;
import javax.swing.JPanel;
import simbad.scene3d.Sign;

/** Says what the colours in the world mean; in as many rows as its width needs. */
final class Legend extends JPanel {
  private static final int GAP = 12;
  private static final int ROW_GAP = 3;

  private final boolean empty;

  Legend(Set<Sign> signs) {
    super(new FlowLayout(FlowLayout.LEADING, GAP, ROW_GAP));
    empty = signs.isEmpty();
    Arrays.stream(Sign.values()).filter(signs::contains).map(Legend::entry).forEach(this::add);
    setVisible(!empty);
  }

  boolean isEmpty() {
    return empty;
  }

  private static JLabel entry(Sign sign) {
    return new Entry(sign);
  }

  /** Its sample changes with the theme. */
  private static final class Entry extends JLabel {
    private final Sign sign;

    Entry(Sign sign) {
      super(text(sign));
      this.sign = sign;
      setIcon(new Swatch(sign, Theme.isDark()));
    }

    @Override
    public void updateUI() {
      super.updateUI();
      // Also called by the constructor of the label, before there is a sign.
      if (sign != null) {
        setIcon(new Swatch(sign, Theme.isDark()));
      }
    }
  }

  private static String text(Sign sign) {
    return switch (sign) {
      case ROBOT -> "robot, red nose ahead";
      case SILENT -> "sensor without echo";
      case ECHO -> "echo, as long as its range";
      case SHADOW -> "detection shadow";
      case EDGE -> "its edge: the thresholds";
      case TRAIL -> "where it has been";
      case AXES -> "axes: x red, y green, z blue";
    };
  }

  /** Returns the height of the rows that the entries need at the width of the parent. */
  @Override
  public Dimension getPreferredSize() {
    int width = getParent() == null ? Integer.MAX_VALUE : getParent().getWidth();
    int rows = 1;
    int used = GAP;
    int high = 0;
    for (java.awt.Component entry : getComponents()) {
      Dimension size = entry.getPreferredSize();
      high = Math.max(high, size.height);
      if (used > GAP && used + size.width + GAP > width) {
        rows++;
        used = GAP;
      }
      used += size.width + GAP;
    }
    return new Dimension(Math.min(used, width), rows * (high + ROW_GAP) + ROW_GAP);
  }
}
