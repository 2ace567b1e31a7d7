package simbad.gui;

import java.awt.event.ActionEvent;
import java.awt.event.ActionListener;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.BoxLayout;
import javax.swing.JComboBox;
import javax.swing.JMenu;
import javax.swing.JPanel;
import javax.swing.JRadioButtonMenuItem;
import javax.swing.JToggleButton;
import javax.swing.Timer;
import org.jspecify.annotations.Nullable;
import simbad.sim.SimpleAgent;
import simbad.sim.Simulator;
import simbad.sim.World;

/** Moves the view of a world: to a fixed place, or along with an agent. */
public class WorldControlGUI extends JPanel implements ActionListener {
  private static final String VIEW = "view ";
  private static final int REFRESH_MS = 200;

  private final transient World world;
  private final JComboBox<SimpleAgent> agents;
  private final transient List<Choice> places;
  private final transient List<Choice> followers;

  /** A program may move the view as well. */
  private final Timer refresh = new Timer(REFRESH_MS, event -> showChosen());

  /**
   * Creates the buttons.
   *
   * @param world whose view is moved
   * @param simulator has the agents that can be followed
   */
  public WorldControlGUI(World world, Simulator simulator) {
    this.world = world;
    agents = AgentChooser.of(simulator);
    AgentChooser.findRobot(simulator).ifPresent(agents::setSelectedItem);
    agents.addActionListener(event -> look(world.getViewPoint()));
    places =
        List.of(
            choice("top", World.VIEW_FROM_TOP, "Look down from above", "control 1"),
            choice("side", World.VIEW_FROM_EAST, "Look from the east", "control 2"));
    followers =
        List.of(
            choice("far", World.VIEW_ABOVE_AGENT, "Follow from far above", "control 3"),
            choice("near", World.VIEW_ABOVE_AGENT_NEAR, "Follow from near above", "control 4"),
            choice("beside", World.VIEW_AGENT_SIDE, "Follow at its side", "control 5"),
            choice("behind", World.VIEW_BEHIND_AGENT, "Follow from behind", "control 6"),
            choice("inwards", World.VIEW_INWARDS, "Look over it to the middle", "control 7"));
    setLayout(new BoxLayout(this, BoxLayout.Y_AXIS));
    add(new LabelledRow("View from", toggles(places)));
    add(new LabelledRow("Follow", toggles(followers)));
    add(new LabelledRow("Agent", agents));
    showChosen();
    refresh.start();
  }

  private static JToggleButton[] toggles(List<Choice> choices) {
    return choices.stream().map(Choice::toggle).toArray(JToggleButton[]::new);
  }

  private Choice choice(String name, int viewPoint, String toolTip, String keys) {
    Choice choice = new Choice(name, toolTip, keys, this);
    choice.setCommand(VIEW + viewPoint);
    return choice;
  }

  /** Returns a menu with the same views. */
  JMenu createMenu() {
    JMenu menu = new JMenu("View");
    menu.setMnemonic('V');
    places.forEach(place -> menu.add(new JRadioButtonMenuItem(place)));
    menu.addSeparator();
    followers.forEach(follower -> menu.add(named("follow ", new JRadioButtonMenuItem(follower))));
    return menu;
  }

  private static JRadioButtonMenuItem named(String prefix, JRadioButtonMenuItem item) {
    item.setText(prefix + item.getText());
    return item;
  }

  /** Moves the view as a button or menu item says, by its action command. */
  @Override
  public void actionPerformed(ActionEvent event) {
    if (event.getActionCommand().startsWith(VIEW)) {
      look(Integer.parseInt(event.getActionCommand().substring(VIEW.length())));
    }
  }

  private void look(int viewPoint) {
    SimpleAgent agent = chosenAgent();
    Commands.run(() -> world.changeViewPoint(viewPoint, agent));
    showChosen(viewPoint);
  }

  private @Nullable SimpleAgent chosenAgent() {
    return agents.getItemAt(agents.getSelectedIndex());
  }

  private void showChosen() {
    showChosen(world.getViewPoint());
  }

  private void showChosen(int viewPoint) {
    choices().forEach(choice -> choice.setSelected(choice.hasCommand(VIEW + viewPoint)));
  }

  private Stream<Choice> choices() {
    return Stream.concat(places.stream(), followers.stream());
  }

  /** Moves the view no more. */
  void close() {
    refresh.stop();
    choices().forEach(Choice::release);
  }
}
