package simbad.gui;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.FlowLayout;
import javax.swing.JLabel;
import javax.swing.JPanel;

/** A row of controls behind a label; labels of equal width stand below one another. */
final class LabelledRow extends JPanel {
  private static final int LABEL_WIDTH = 84;
  private static final int GAP = 4;

  LabelledRow(String label, Component... controls) {
    super(new BorderLayout());
    JLabel head = new JLabel(label);
    head.setPreferredSize(new Dimension(LABEL_WIDTH, head.getPreferredSize().height));
    JPanel row = new JPanel(new FlowLayout(FlowLayout.LEADING, GAP, GAP / 2));
    for (Component control : controls) {
      row.add(control);
    }
    add(head, BorderLayout.LINE_START);
    add(row, BorderLayout.CENTER);
  }
}
