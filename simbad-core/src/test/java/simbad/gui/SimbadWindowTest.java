package simbad.gui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.lang.ref.WeakReference;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import javax.swing.JToggleButton;
import javax.swing.SwingUtilities;
import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.sim.Agent;
import simbad.sim.Box;
import simbad.sim.EnvironmentDescription;
import simbad.sim.KeyInputSensor;
import simbad.sim.RobotFactory;
import simbad.sim.World;

/** The main window, used as a person uses it. */
@Tag("display")
class SimbadWindowTest {
  /** A robot that drives along +x with all that a robot can carry. */
  private static final class Rover extends Agent {
    private final KeyInputSensor keys;

    Rover(double z, String name) {
      super(new Vector3d(-3, 0, z), name);
      RobotFactory.addSonarBeltSensor(this, 12);
      RobotFactory.addBumperBeltSensor(this);
      RobotFactory.addLamp(this).setOn(true);
      keys = RobotFactory.addKeyInputSensor(this);
    }

    @Override
    protected void performBehavior() {
      setTranslationalVelocity(1);
    }
  }

  private static final class Field extends EnvironmentDescription {
    private final Rover first = new Rover(0, "first");
    private final Rover second = new Rover(2, "second");

    Field() {
      setWorldSize(10);
      add(new Box(new Vector3d(3, 0, 0), new Vector3f(1, 1, 1), this));
      add(first);
      add(second);
    }
  }

  private final Field field = new Field();

  private Desk open() throws Exception {
    Desk desk = new Desk(new Simbad(field, false));
    Desk.await("the world is drawn", () -> colours(desk) > 10);
    return desk;
  }

  private static long colours(Desk desk) {
    try {
      return Desk.colours(desk.world());
    } catch (Exception e) {
      throw new AssertionError(e);
    }
  }

  /** Waits until the picture has come to rest and returns it. */
  private static BufferedImage still(Desk desk) throws Exception {
    BufferedImage before = desk.world();
    for (int i = 0; i < 100; i++) {
      Thread.sleep(100);
      BufferedImage now = desk.world();
      if (Desk.difference(before, now) == 0) {
        return now;
      }
      before = now;
    }
    throw new AssertionError("the picture of a world at rest does not come to rest");
  }

  @Test
  void buttons_runPauseStepAndReset() throws Exception {
    try (Desk desk = open()) {
      assertEquals(0, field.first.getCounter());
      desk.click("run");
      Desk.await("steps are done", () -> field.first.getCounter() > 10);
      desk.photograph("running");
      desk.click("pause");
      int paused = field.first.getCounter();
      desk.click("step");
      assertEquals(paused + 1, field.first.getCounter());
      desk.click("reset");
      assertEquals(0, field.first.getCounter());
      assertEquals(0, field.first.getOdometer());
      desk.click("restart");
      Desk.await("steps are done", () -> field.first.getCounter() > 0);
      desk.choose("pause");
    }
  }

  @Test
  void view_changesWhenTheRobotMoves() throws Exception {
    try (Desk desk = open()) {
      BufferedImage before = still(desk);
      for (int i = 0; i < 20; i++) {
        desk.click("step");
      }
      assertTrue(Desk.difference(before, still(desk)) > 0.001, "the robots went 1 m");
      desk.click("reset");
      assertTrue(Desk.difference(before, still(desk)) < 0.0005, "they are back");
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"Mouse and keys", "About"})
  void help_isDrawn_notSpeltOut(String item) throws Exception {
    try (Desk desk = open()) {
      SwingUtilities.invokeLater(() -> desk.chooseUnawaited(item));
      Desk.await("a dialog", () -> !desk.dialogs().isEmpty());
      JDialog dialog = desk.dialogs().get(0);
      List<JLabel> labels = Desk.onEventThread(() -> Desk.parts(dialog, JLabel.class).toList());
      // The parsed text, which the label draws in place of the letters.
      assertEquals(1, labels.stream().filter(Desk::isHtml).count());
      assertTrue(labels.stream().noneMatch(l -> l.getText() != null && !Desk.isHtml(l)));
      desk.photograph("help " + item, dialog);
      SwingUtilities.invokeAndWait(dialog::dispose);
    }
  }

  @Test
  void everyView_isAnotherPicture() throws Exception {
    try (Desk desk = open()) {
      List<BufferedImage> pictures = new ArrayList<>();
      for (String view :
          List.of("top", "side", "follow far", "follow near", "follow beside", "follow behind")) {
        desk.choose(view);
        BufferedImage picture = still(desk);
        desk.photograph("view " + view);
        assertTrue(Desk.colours(picture) > 10, view + " shows something");
        pictures.forEach(
            other -> assertTrue(Desk.difference(other, picture) > 0.02, view + " is different"));
        pictures.add(picture);
      }
    }
  }

  /** A program that moves the view leaves the buttons right. */
  @Test
  void viewMovedByTheProgram_isTheOneChosen() throws Exception {
    try (Desk desk = open()) {
      ControlWindow control = desk.frame(ControlWindow.class);
      Objects.requireNonNull(field.first.world).changeViewPoint(World.VIEW_FROM_EAST, field.first);
      Desk.await(
          "side is chosen",
          () ->
              Desk.parts(control, JToggleButton.class)
                  .filter(AbstractButton::isSelected)
                  .anyMatch(toggle -> toggle.getText().equals("side")));
    }
  }

  @Test
  void inspector_followsTheChosenAgent() throws Exception {
    try (Desk desk = open()) {
      AgentInspector inspector = desk.frame(AgentInspector.class);
      assertSame(inspector, field.first.getAgentInspector());
      JComboBox<?> chooser = Desk.parts(inspector, JComboBox.class).findFirst().orElseThrow();
      JTextArea text = Desk.parts(inspector, JTextArea.class).findFirst().orElseThrow();
      Desk.await("the first is shown", () -> text.getText().contains("name:      first"));
      Desk.onEventThread(
          () -> {
            chooser.setSelectedItem(field.second);
            return true;
          });
      Desk.await("the second is shown", () -> text.getText().contains("name:      second"));
      assertEquals("second Inspector", inspector.getTitle());
      assertSame(inspector, field.second.getAgentInspector());
      assertNull(field.first.getAgentInspector());
      desk.click("step");
      Desk.await("the step is shown", () -> text.getText().contains("counter:   1"));
      desk.photograph("inspector");
    }
  }

  @Test
  void keys_ofTheDesktop_reachTheRobots() throws Exception {
    try (Desk desk = open()) {
      Desk.onEventThread(
          () -> {
            desk.window
                .getDesktopPane()
                .dispatchEvent(
                    new KeyEvent(
                        desk.window.getDesktopPane(),
                        KeyEvent.KEY_PRESSED,
                        0,
                        0,
                        KeyEvent.VK_UP,
                        KeyEvent.CHAR_UNDEFINED));
            return true;
          });
      assertEquals(KeyEvent.VK_UP, field.first.keys.getLastKey());
    }
  }

  @Test
  void panelOfAnAgent_getsAWindow() throws Exception {
    try (Desk desk = open()) {
      JPanel panel = new JPanel();
      panel.add(new JLabel("output of mine"));
      field.second.setUIPanel(panel);
      Desk.await("the panel is shown", panel::isShowing);
      desk.photograph("output");
    }
  }

  @Test
  void otherEnvironments_replaceOneAnother_andAreFreed() throws Exception {
    List<WeakReference<Agent>> former = new ArrayList<>();
    try (Desk desk = new Desk(new Simbad(new EnvironmentDescription(), false))) {
      for (int i = 0; i < 4; i++) {
        former.add(openField(desk, i));
      }
      desk.choose("BaseDemo");
      Desk.await("the demo is there", () -> desk.window.getTitle().endsWith("BaseDemo"));
      // Swing remembers who had the focus last until somebody else has it.
      Desk.settle();
      desk.click("run");
      Desk.await("the former agents are freed", () -> freed(former) == former.size());
      assertEquals(3, desk.window.getDesktopPane().getAllFrames().length);
    }
  }

  /** Lets no reference to the environment stay on the test's own stack. */
  private static WeakReference<Agent> openField(Desk desk, int i) throws Exception {
    Field next = new Field();
    desk.window.open(next);
    Desk.await("field " + i + " is there", () -> next.first.getAgentInspector() != null);
    Desk.settle();
    desk.click("run");
    Desk.await("field " + i + " runs", () -> next.first.getCounter() > 1);
    return new WeakReference<>(next.first);
  }

  private static long freed(List<WeakReference<Agent>> agents) {
    System.gc();
    return agents.stream().filter(agent -> agent.get() == null).count();
  }

  @Test
  void closing_freesTheWorld_andLetsThoseWhoWaitGoOn() throws Exception {
    Simbad window = new Simbad(new Field(), false);
    WeakReference<Simbad> reference = new WeakReference<>(window);
    assertSame(window, Simbad.getSimbadInstance());
    try (Desk desk = new Desk(window)) {
      desk.click("run");
    }
    window.awaitClosed();
    assertNull(Simbad.getSimbadInstance());
    assertFalse(window.isDisplayable());
    assertEquals(0, window.getDesktopPane().getAllFrames().length);
    assertSame(window, reference.get());
  }

  /** Whoever disposes of the window and returns from main has ended the program. */
  @Test
  void disposedWindow_leavesNoThreadThatKeepsTheProgramAlive() throws Exception {
    try (Desk desk = open()) {
      assertTrue(threadsOfJava3D().count() > 1);
      desk.click("run");
    }
    Desk.await("Java 3D lets go", () -> threadsOfJava3D().allMatch(Thread::isDaemon));
    assertTrue(threadsOfJava3D().findAny().isPresent(), "the renderer stays, as a daemon");
  }

  private static Stream<Thread> threadsOfJava3D() {
    return Thread.getAllStackTraces().keySet().stream()
        .filter(thread -> thread.getName().startsWith("J3D-"));
  }

  @Test
  void backgroundMode_stepsAtOnce_withoutControls() throws Exception {
    try (Desk desk = new Desk(new Simbad(field, true))) {
      Desk.await("steps are done", () -> field.first.getCounter() > 1000);
      assertEquals(2, desk.window.getDesktopPane().getAllFrames().length);
      desk.photograph("background");
    }
  }

  @Test
  void environmentWithoutAgents_opens() throws Exception {
    try (Desk desk = new Desk(new Simbad(new EnvironmentDescription(), false))) {
      desk.click("run");
      assertEquals(2, desk.window.getDesktopPane().getAllFrames().length);
    }
  }

  /** Who chooses quickly gets what was chosen last, once. */
  @Test
  void environmentsOpenedInARow_leaveTheLast() throws Exception {
    try (Desk desk = new Desk(new Simbad(new EnvironmentDescription(), false))) {
      desk.window.open(new EnvironmentDescription());
      desk.window.open(field);
      Desk.await("the last is there", () -> field.first.getAgentInspector() != null);
      Desk.settle();
      assertEquals(3, desk.window.getDesktopPane().getAllFrames().length);
      assertTrue(desk.window.getTitle().endsWith("Field"));
    }
  }

  @Test
  void darkTheme_canBeChosen() throws Exception {
    try (Desk desk = open()) {
      desk.choose("Dark theme");
      assertTrue(Theme.isDark());
      desk.photograph("dark");
      desk.choose("Dark theme");
      assertFalse(Theme.isDark());
    }
  }
}
