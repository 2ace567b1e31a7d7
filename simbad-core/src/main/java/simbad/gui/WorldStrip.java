package simbad.gui;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;

/** What stands below the world: the legend, a line of news and a button. */
final class WorldStrip extends JPanel {
  private static final int GAP = 3;

  private final JLabel news = new JLabel(" ");

  WorldStrip(Legend legend, JButton button) {
    super(new BorderLayout());
    JPanel row = new JPanel(new BorderLayout(4 * GAP, 0));
    row.setBorder(BorderFactory.createEmptyBorder(GAP, 4 * GAP, GAP, GAP));
    row.add(news, BorderLayout.CENTER);
    row.add(button, BorderLayout.LINE_END);
    add(legend, BorderLayout.CENTER);
    add(row, BorderLayout.PAGE_END);
    addComponentListener(new RowsByWidth());
  }

  /** Says something in one line; the whole of it is in the tool tip. */
  void say(String text) {
    news.setText(text);
    news.setToolTipText(text);
  }

  String news() {
    return news.getText();
  }

  /** A narrower strip needs more rows for the legend. */
  private final class RowsByWidth extends ComponentAdapter {
    @Override
    public void componentResized(ComponentEvent event) {
      for (Component part : getComponents()) {
        part.invalidate();
      }
      revalidate();
    }
  }
}
