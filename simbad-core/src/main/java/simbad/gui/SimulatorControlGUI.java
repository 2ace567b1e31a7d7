package simbad.gui;

import java.awt.event.ActionEvent;
import java.awt.event.ActionListener;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import javax.swing.BoxLayout;
import javax.swing.JButton;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JMenu;
import javax.swing.JPanel;
import javax.swing.JRadioButtonMenuItem;
import javax.swing.JToggleButton;
import javax.swing.Timer;
import org.jspecify.annotations.Nullable;
import simbad.sim.Simulator;

/** Runs, pauses and steps a simulator and sets its speed. */
public class SimulatorControlGUI extends JPanel implements ActionListener {
  private static final String FACTOR = "time factor ";
  private static final float[] FACTORS = {0.2f, 0.5f, 1, 5, 10, 20};
  private static final int REFRESH_MS = 200;

  private final transient Simulator simulator;
  private final transient Choice run =
      new Choice("run", "Prepare the behaviours and step on and on", "F5", this);
  private final transient Choice pause = new Choice("pause", "Stop stepping", "F6", this);
  private final transient Choice step = new Choice("step", "Stop and do one step", "F7", this);
  private final transient Choice reset =
      new Choice("reset", "Stop and put every agent back to its start", "F8", this);
  private final transient Choice restart =
      new Choice("restart", "Put every agent back and run", "F9", this);
  private final transient List<Choice> factors;
  private final JLabel state = new JLabel(" ");
  private final Timer refresh = new Timer(REFRESH_MS, event -> showState());

  /**
   * Creates the buttons.
   *
   * @param parent accepted for old programs; may be null
   * @param simulator is controlled
   */
  public SimulatorControlGUI(@Nullable JFrame parent, Simulator simulator) {
    this.simulator = simulator;
    factors = factorChoices();
    setLayout(new BoxLayout(this, BoxLayout.Y_AXIS));
    add(
        new LabelledRow(
            "Simulation", commands().stream().map(Choice::button).toArray(JButton[]::new)));
    add(
        new LabelledRow(
            "Time factor", factors.stream().map(Choice::toggle).toArray(JToggleButton[]::new)));
    add(new LabelledRow("State", state));
    showState();
    refresh.start();
  }

  private List<Choice> factorChoices() {
    return IntStream.range(0, FACTORS.length).mapToObj(i -> factorChoice(FACTORS[i])).toList();
  }

  private Choice factorChoice(float factor) {
    String text = factor < 1 ? String.valueOf(factor) : String.valueOf((int) factor);
    Choice choice =
        new Choice(text, "Simulated seconds per second of the clock: " + text, "", this);
    choice.setCommand(FACTOR + factor);
    choice.setSelected(simulator.getVirtualTimeFactor() == factor);
    return choice;
  }

  private List<Choice> commands() {
    return List.of(run, pause, step, reset, restart);
  }

  /** Returns a menu with the same commands. */
  public JMenu createMenu() {
    JMenu menu = new JMenu("Simulation");
    menu.setMnemonic('S');
    commands().forEach(menu::add);
    menu.addSeparator();
    JMenu speed = new JMenu("time factor");
    factors.forEach(factor -> speed.add(new JRadioButtonMenuItem(factor)));
    menu.add(speed);
    return menu;
  }

  /** Does what a button or menu item says, by its action command. */
  @Override
  public void actionPerformed(ActionEvent event) {
    String command = event.getActionCommand();
    switch (command) {
      case "run" -> Commands.run(simulator::startSimulation);
      case "pause" -> Commands.run(simulator::stopSimulation);
      case "step" -> Commands.run(simulator::performSimulationStep);
      case "reset" -> Commands.run(simulator::resetSimulation);
      case "restart" -> Commands.run(simulator::restartSimulation);
      default -> setFactor(command);
    }
    Commands.run(() -> javax.swing.SwingUtilities.invokeLater(this::showState));
  }

  private void setFactor(String command) {
    if (command.startsWith(FACTOR)) {
      float factor = Float.parseFloat(command.substring(FACTOR.length()));
      factors.forEach(choice -> choice.setSelected(choice.hasCommand(command)));
      Commands.run(() -> simulator.setVirtualTimeFactor(factor));
    }
  }

  private void showState() {
    boolean running = simulator.isRunning();
    run.setEnabled(!running);
    pause.setEnabled(running);
    String time =
        simulator.getAgentList().stream()
            .findFirst()
            .map(agent -> String.format(Locale.ROOT, ", %.1f s", agent.getLifeTime()))
            .orElse("");
    state.setText((running ? "running" : "paused") + time);
  }

  /** Looks at the simulator and controls it no more. */
  void close() {
    refresh.stop();
    commands().forEach(Choice::release);
    factors.forEach(Choice::release);
  }
}
