package simbad.gui;

import java.awt.Component;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.stream.Stream;
import javax.swing.JDesktopPane;
import javax.swing.JInternalFrame;
import javax.swing.JMenu;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import javax.swing.event.InternalFrameAdapter;
import javax.swing.event.InternalFrameEvent;
import org.jspecify.annotations.Nullable;
import simbad.scene3d.DisplayException;
import simbad.sim.Agent;
import simbad.sim.EnvironmentDescription;
import simbad.sim.Simulator;
import simbad.sim.World;

/**
 * The simulation of one environment in the main window. Created on any thread; windows are opened
 * and closed on the event thread, what they show is freed elsewhere.
 */
final class Session {
  /** How often the world is drawn while steps go as fast as they can. */
  private static final int BACKGROUND_DRAWING_MS = 2000;

  private final JDesktopPane desktop;
  private final boolean backgroundMode;
  private final World world;
  private final Simulator simulator;
  private final Timer rareDrawing = new Timer(BACKGROUND_DRAWING_MS, event -> drawOnce());
  private @Nullable WorldWindow worldWindow;
  private @Nullable AgentInspector inspector;
  private @Nullable ControlWindow control;
  private @Nullable OutputWindows outputs;

  /** Creates the world and its agents, and starts Java 3D if it is there. */
  Session(JDesktopPane desktop, EnvironmentDescription environment, boolean backgroundMode) {
    this.desktop = desktop;
    this.backgroundMode = backgroundMode;
    world = new World(environment);
    simulator = new Simulator(desktop, world, environment);
    startJava3D();
  }

  /** Returns what steps the agents. */
  Simulator simulator() {
    return simulator;
  }

  /** Takes its time, which the event thread then does not lose. */
  private void startJava3D() {
    try {
      world.getCanvas3D();
    } catch (DisplayException e) {
      // The window of the world meets the same and says it.
    }
  }

  /** Opens the windows; on the event thread. */
  void open() {
    worldWindow = new WorldWindow(world);
    inspector = AgentChooser.findRobot(simulator).map(this::inspectorOf).orElse(null);
    control = backgroundMode ? null : new ControlWindow(world, simulator);
    Stream.of(control, inspector, worldWindow)
        .filter(window -> window != null)
        .forEach(this::install);
    arrange();
    outputs = new OutputWindows(desktop, simulator);
    desktop.requestFocusInWindow();
    if (backgroundMode) {
      world.stopRendering();
      rareDrawing.start();
      Commands.run(simulator::startBackgroundMode);
    }
  }

  private AgentInspector inspectorOf(Agent agent) {
    return new AgentInspector(agent, backgroundMode, simulator);
  }

  private void install(JInternalFrame window) {
    window.setFrameIcon(new RobotIcon(RobotIcon.TITLE_PX));
    desktop.add(window);
    window.addInternalFrameListener(new KeysToDesktop());
    for (Component part : window.getContentPane().getComponents()) {
      part.addMouseListener(new ClickToDesktop());
    }
  }

  /** Robots listen to the keys of the desktop, whichever window is in front. */
  private final class KeysToDesktop extends InternalFrameAdapter {
    @Override
    public void internalFrameActivated(InternalFrameEvent event) {
      SwingUtilities.invokeLater(desktop::requestFocusInWindow);
    }
  }

  private final class ClickToDesktop extends MouseAdapter {
    @Override
    public void mousePressed(MouseEvent event) {
      desktop.requestFocusInWindow();
    }
  }

  /** Steps on and on, as the button does. */
  void start() {
    Commands.run(simulator::startSimulation);
  }

  private void drawOnce() {
    Commands.run(world::renderOnce);
  }

  /** Puts the windows where they were at first. */
  void arrange() {
    if (worldWindow != null) {
      new Tiling(worldWindow, inspector, control).arrange(desktop.getSize());
    }
  }

  /** Returns the menus that control this session. */
  Stream<JMenu> menus() {
    Stream<JMenu> show = Stream.ofNullable(worldWindow).map(WorldWindow::createMenu);
    return control == null
        ? show
        : Stream.concat(
            Stream.of(control.simulatorControl().createMenu(), control.worldControl().createMenu()),
            show);
  }

  /** Opens an inspector for the first agent if none is open; on the event thread. */
  void inspect() {
    if (inspector == null || inspector.isClosed()) {
      inspector = AgentChooser.findRobot(simulator).map(this::inspectorOf).orElse(null);
      if (inspector != null) {
        install(inspector);
        inspector.toFront();
        arrange();
      }
    }
  }

  /** Closes the windows, those of others that stand on the desktop included. */
  void close() {
    rareDrawing.stop();
    if (outputs != null) {
      outputs.close();
    }
    for (JInternalFrame window : desktop.getAllFrames()) {
      window.dispose();
      desktop.remove(window);
    }
    desktop.repaint();
  }

  /** Frees the world and its agents; may wait for a step. */
  void dispose() {
    simulator.dispose();
    world.dispose();
  }
}
