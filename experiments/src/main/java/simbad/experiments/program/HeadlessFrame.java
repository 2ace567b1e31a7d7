package simbad.experiments.program;

import java.awt.event.ActionEvent;
import java.awt.event.ActionListener;
import javax.swing.JDesktopPane;
import org.jspecify.annotations.Nullable;
import simbad.sim.EnvironmentDescription;
import simbad.sim.Simulator;
import simbad.sim.World;

/**
 * Stands in for the main window in a program that runs without one: it has the members of {@link
 * simbad.gui.Simbad} of its own.
 */
public class HeadlessFrame extends HeadlessWindow implements ActionListener {
  private static final long serialVersionUID = 1;

  private static volatile @Nullable HeadlessFrame instance;

  private final JDesktopPane desktop = new JDesktopPane();
  private final transient World world;
  private final transient Simulator simulator;

  /**
   * Makes the world and its agents; steps come when the program's main has ended or sleeps.
   *
   * @param environment what the world contains
   * @param backgroundMode of no account
   */
  @SuppressWarnings("ThisEscapedInObjectConstruction") // As the window does.
  public HeadlessFrame(EnvironmentDescription environment, boolean backgroundMode) {
    instance = this;
    world = new World(environment);
    simulator = new Simulator(desktop, world, environment);
    setContentPane(desktop);
    ProgramRun.started(simulator);
  }

  /** Does nothing: there is no menu. */
  @Override
  public void actionPerformed(ActionEvent event) {
    // Nobody chooses a demo.
  }

  /** Returns a desktop that nobody sees. */
  @Override
  public JDesktopPane getDesktopPane() {
    return desktop;
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
