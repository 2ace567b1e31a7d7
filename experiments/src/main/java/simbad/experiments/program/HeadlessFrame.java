package simbad.experiments.program;

import java.awt.event.ActionEvent;
import javax.swing.JDesktopPane;
import org.jspecify.annotations.Nullable;
import simbad.sim.EnvironmentDescription;
import simbad.sim.Simulator;
import simbad.sim.World;

/**
 * Stands in for the main window in a program that runs without one: it has the members of {@link
 * simbad.gui.Simbad} of its own. What a program calls of a window besides does nothing.
 */
public class HeadlessFrame {
  private static volatile @Nullable HeadlessFrame instance;

  private final World world;
  private final Simulator simulator;

  /**
   * Makes the world and its agents; steps come when the program's main has ended.
   *
   * @param environment what the world contains
   * @param backgroundMode of no account
   */
  @SuppressWarnings("ThisEscapedInObjectConstruction") // As the window does.
  public HeadlessFrame(EnvironmentDescription environment, boolean backgroundMode) {
    world = new World(environment);
    simulator = new Simulator(null, world, environment);
    instance = this;
    ProgramRun.opened(simulator);
  }

  /** Does nothing: there is no menu. */
  public void actionPerformed(ActionEvent event) {
    // Nobody chooses a demo.
  }

  /** Returns a desktop that nobody sees. */
  public JDesktopPane getDesktopPane() {
    return new JDesktopPane();
  }

  /** Returns what steps the agents. */
  public Simulator getSimulator() {
    return simulator;
  }

  /** Returns the world. */
  public World getWorld() {
    return world;
  }

  /** Does nothing: steps come by themselves. */
  public void startSimulation() {
    // As above.
  }

  /** Returns the frame that was opened last, null if there is none. */
  public static @Nullable HeadlessFrame getSimbadInstance() {
    return instance;
  }
}
