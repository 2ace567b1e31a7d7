package simbad.gui;

import java.util.HashMap;
import java.util.Map;
import javax.swing.JDesktopPane;
import javax.swing.JInternalFrame;
import javax.swing.JPanel;
import javax.swing.Timer;
import simbad.sim.Agent;
import simbad.sim.Simulator;

/** Opens a window for each panel that an agent has for its own output, whenever it gets one. */
final class OutputWindows {
  private static final int REFRESH_MS = 500;
  private static final int STAGGER_PX = 30;

  private final JDesktopPane desktop;
  private final Simulator simulator;
  private final Map<Agent, JPanel> shown = new HashMap<>();
  private final Timer refresh = new Timer(REFRESH_MS, event -> look());

  OutputWindows(JDesktopPane desktop, Simulator simulator) {
    this.desktop = desktop;
    this.simulator = simulator;
    look();
    refresh.start();
  }

  private void look() {
    shown.values().forEach(JPanel::repaint);
    simulator.getAgentList().stream()
        .filter(Agent.class::isInstance)
        .map(Agent.class::cast)
        .filter(agent -> agent.getUIPanel() != null)
        .filter(agent -> shown.put(agent, agent.getUIPanel()) != agent.getUIPanel())
        .forEach(this::open);
  }

  private void open(Agent agent) {
    JInternalFrame window =
        new JInternalFrame("Output of " + agent.getName(), true, true, true, true);
    window.setContentPane(agent.getUIPanel());
    window.setFrameIcon(new RobotIcon(RobotIcon.TITLE_PX));
    window.pack();
    window.setLocation(shown.size() * STAGGER_PX, shown.size() * STAGGER_PX);
    desktop.add(window);
    window.setVisible(true);
    window.toFront();
  }

  /** Looks for panels no more; the windows belong to the desktop. */
  void close() {
    refresh.stop();
  }
}
