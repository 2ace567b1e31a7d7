package simbad.gui;

import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.BoxLayout;
import javax.swing.JInternalFrame;
import javax.swing.JPanel;
import simbad.sim.Simulator;
import simbad.sim.World;

/** The buttons that run the simulation and move the view. */
public class ControlWindow extends JInternalFrame {
  private static final int GAP = 6;

  private final WorldControlGUI worldControl;
  private final SimulatorControlGUI simulatorControl;

  /** Creates a window that controls a world and its simulator. */
  public ControlWindow(World world, Simulator simulator) {
    super("Control", false, false, false, true);
    worldControl = new WorldControlGUI(world, simulator);
    simulatorControl = new SimulatorControlGUI(null, simulator);
    JPanel content = new JPanel();
    content.setLayout(new BoxLayout(content, BoxLayout.Y_AXIS));
    content.setBorder(BorderFactory.createEmptyBorder(GAP, GAP, GAP, GAP));
    content.add(simulatorControl);
    content.add(Box.createVerticalStrut(GAP));
    content.add(worldControl);
    setContentPane(content);
    pack();
    setVisible(true);
  }

  WorldControlGUI worldControl() {
    return worldControl;
  }

  SimulatorControlGUI simulatorControl() {
    return simulatorControl;
  }

  @Override
  public void dispose() {
    worldControl.close();
    simulatorControl.close();
    super.dispose();
  }
}
