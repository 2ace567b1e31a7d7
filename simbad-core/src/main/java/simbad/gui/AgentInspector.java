package simbad.gui;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Font;
import java.util.stream.Stream;
import javax.swing.BorderFactory;
import javax.swing.BoxLayout;
import javax.swing.JComboBox;
import javax.swing.JInternalFrame;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.SwingUtilities;
import javax.swing.text.DefaultCaret;
import simbad.kernel.run.Pacer;
import simbad.sim.Agent;
import simbad.sim.Device;
import simbad.sim.SimpleAgent;
import simbad.sim.Simulator;

/** Shows an agent's state and a panel of each of its devices; the agent can be changed. */
public class AgentInspector extends JInternalFrame implements Runnable {
  private static final float FRAMES_PER_S = 2;
  private static final float BACKGROUND_FRAMES_PER_S = 0.5f;
  private static final int WIDTH = 340;
  private static final int HEIGHT = 480;
  private static final int GAP = 6;
  private static final int LINES = 14;
  private static final int SCROLL_PX = 16;

  private final transient Simulator simulator;
  private final transient Pacer pacer = new Pacer("agent inspector");
  private final JPanel devices = new JPanel();
  private final JTextArea text = new JTextArea(LINES, 1);
  private transient volatile SimpleAgent agent;
  private transient volatile float framesPerSecond;

  /**
   * Creates an inspector.
   *
   * @param agent is shown first
   * @param backgroundMode whether to look at the agent rarely
   * @param simulator steps the agent and the others that can be chosen
   */
  public AgentInspector(Agent agent, boolean backgroundMode, Simulator simulator) {
    super("", true, false, true, true);
    this.agent = agent;
    this.simulator = simulator;
    framesPerSecond = backgroundMode ? BACKGROUND_FRAMES_PER_S : FRAMES_PER_S;
    devices.setLayout(new BoxLayout(devices, BoxLayout.Y_AXIS));
    text.setEditable(false);
    text.setFocusable(false);
    // New text shall not scroll to itself.
    ((DefaultCaret) text.getCaret()).setUpdatePolicy(DefaultCaret.NEVER_UPDATE);
    text.setFont(new Font(Font.MONOSPACED, Font.PLAIN, text.getFont().getSize()));
    text.setBorder(BorderFactory.createEmptyBorder(GAP, GAP, GAP, GAP));
    setLayout(new BorderLayout());
    add(chooser(), BorderLayout.PAGE_START);
    add(scrolled(devices, text), BorderLayout.CENTER);
    setPreferredSize(new Dimension(WIDTH, HEIGHT));
    choose(agent);
    pack();
    setVisible(true);
    setFramesPerSecond(framesPerSecond);
  }

  private JPanel chooser() {
    JComboBox<SimpleAgent> chooser = AgentChooser.of(simulator);
    chooser.setSelectedItem(agent);
    chooser.addActionListener(event -> choose(chooser.getItemAt(chooser.getSelectedIndex())));
    return new LabelledRow(" Agent", chooser);
  }

  private static JScrollPane scrolled(JPanel panel, JTextArea below) {
    JPanel top = new JPanel(new BorderLayout());
    top.add(panel, BorderLayout.PAGE_START);
    top.add(below, BorderLayout.CENTER);
    JScrollPane pane = new JScrollPane(top);
    pane.setBorder(BorderFactory.createEmptyBorder());
    pane.getVerticalScrollBar().setUnitIncrement(SCROLL_PX);
    return pane;
  }

  /** Shows another agent from now on. */
  private void choose(SimpleAgent chosen) {
    if (agent instanceof Agent former && former.getAgentInspector() == this) {
      former.setAgentInspector(null);
    }
    agent = chosen;
    if (chosen instanceof Agent inspected) {
      inspected.setAgentInspector(this);
    }
    setTitle(chosen.getName() + " Inspector");
    devices.removeAll();
    Stream.concat(chosen.getSensorList().stream(), chosen.getActuatorList().stream())
        .map(AgentInspector::panel)
        .forEach(devices::add);
    devices.revalidate();
    Commands.run(this);
  }

  private static JPanel panel(Device device) {
    JPanel framed = new JPanel(new BorderLayout());
    framed.setBorder(BorderFactory.createTitledBorder(title(device)));
    framed.add(device.createInspectorPanel(), BorderLayout.CENTER);
    return framed;
  }

  /** Returns the device's name; its class if nobody has named it. */
  private static String title(Device device) {
    boolean unnamed = device.getName().startsWith("<");
    return unnamed ? device.getClass().getSimpleName() : device.getName();
  }

  /** Sets how often per second the agent is looked at; above 0. */
  public void setFramesPerSecond(float fps) {
    if (!(fps > 0)) {
      throw new IllegalArgumentException("fps = " + fps + " is not in (0, infinity)");
    }
    framesPerSecond = fps;
    pacer.start(1 / fps, this);
  }

  /** Looks at the agent once, between two steps, and has the result painted. */
  @Override
  public void run() {
    simulator.lock();
    String state;
    try {
      state = agent.asString();
    } finally {
      simulator.unlock();
    }
    SwingUtilities.invokeLater(() -> show(state));
  }

  /** Says the units of figures whose lines, which programs may read, have none. */
  static String withUnits(String state) {
    return state
        .replaceAll("(?m)^(counter: +\\d+)$", "$1 steps")
        .replaceAll("(?m)^steps/s: ( +\\S+) now$", "pace:    $1 steps/s now")
        .replaceAll("(?m)^( +\\S+) on average$", "$1 steps/s on average");
  }

  private void show(String state) {
    // In the order in which a layout takes its locks, which old programs start on any thread.
    synchronized (text.getTreeLock()) {
      text.setText(withUnits(state));
    }
    devices.repaint();
  }

  /** Looks at the agent now. */
  public void update() {
    run();
  }

  @Override
  public void dispose() {
    pacer.stop();
    if (agent instanceof Agent inspected) {
      inspected.setAgentInspector(null);
    }
    super.dispose();
  }
}
