package simbad.gui;

import java.awt.Component;
import java.util.Optional;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JComboBox;
import javax.swing.JList;
import simbad.sim.Agent;
import simbad.sim.SimpleAgent;
import simbad.sim.Simulator;

/** Lists the agents of a simulator by their names. */
final class AgentChooser {
  private AgentChooser() {}

  static JComboBox<SimpleAgent> of(Simulator simulator) {
    JComboBox<SimpleAgent> chooser =
        new JComboBox<>(simulator.getAgentList().toArray(new SimpleAgent[0]));
    chooser.setRenderer(new Names());
    chooser.setToolTipText("Which agent");
    // Keys are for robots that listen to them.
    chooser.setFocusable(false);
    return chooser;
  }

  /** Returns the first agent that is a robot, not a ball or a cherry. */
  static Optional<Agent> findRobot(Simulator simulator) {
    return simulator.getAgentList().stream()
        .filter(Agent.class::isInstance)
        .map(Agent.class::cast)
        .findFirst();
  }

  private static final class Names extends DefaultListCellRenderer {
    @Override
    public Component getListCellRendererComponent(
        JList<?> list, Object value, int index, boolean selected, boolean focused) {
      Object name = value instanceof SimpleAgent agent ? agent.getName() : "none";
      return super.getListCellRendererComponent(list, name, index, selected, focused);
    }
  }
}
