package simbad.gui;

import java.awt.BorderLayout;
import java.awt.Component;
import javax.swing.JInternalFrame;
import javax.swing.JLabel;
import javax.swing.SwingConstants;
import javax.swing.SwingUtilities;
import simbad.scene3d.DisplayException;
import simbad.sim.World;

/** Shows the world in 3D; where that is impossible, why. */
public final class WorldWindow extends JInternalFrame {
  /** Side at first, as in the original. */
  private static final int SIDE_PX = 400;

  /** Creates a window of a world. */
  public WorldWindow(World world) {
    super("world", true, false, true, true);
    setLayout(new BorderLayout());
    add(view(world));
    setSize(SIDE_PX, SIDE_PX);
    setVisible(true);
  }

  private Component view(World world) {
    try {
      Component canvas = world.getCanvas3D();
      world.whenDrawingFails(why -> SwingUtilities.invokeLater(() -> explain(canvas, why)));
      return canvas;
    } catch (DisplayException e) {
      return explanation(e.getMessage());
    }
  }

  private void explain(Component canvas, String why) {
    getContentPane().remove(canvas);
    add(explanation(why));
    validate();
  }

  private static JLabel explanation(String why) {
    JLabel label = new JLabel("<html><center>" + escape(why) + "</center></html>");
    label.setHorizontalAlignment(SwingConstants.CENTER);
    return label;
  }

  private static String escape(String text) {
    return text.replace("&", "&amp;").replace("<", "&lt;");
  }
}
