package simbad.gui;

import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.GraphicsEnvironment;
import java.awt.Toolkit;
import java.awt.event.ActionEvent;
import java.awt.event.ActionListener;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.WindowEvent;
import java.lang.reflect.InvocationTargetException;
import java.util.Arrays;
import java.util.concurrent.CountDownLatch;
import javax.swing.JDesktopPane;
import javax.swing.JFrame;
import javax.swing.JMenuBar;
import javax.swing.SwingUtilities;
import org.jspecify.annotations.Nullable;
import simbad.demo.BaseDemo;
import simbad.demo.Demo;
import simbad.demo.DemoManager;
import simbad.scene3d.DisplayException;
import simbad.sim.EnvironmentDescription;
import simbad.sim.Simulator;
import simbad.sim.World;

/**
 * The main window: the world in 3D, an inspector of its agents, and the control of the simulation.
 *
 * <p>It may be created on any thread. Closing it ends the program; {@link #dispose()} only frees
 * what the window holds.
 */
public class Simbad extends JFrame implements ActionListener {
  private static final String TITLE = "Simbad Sonar";
  private static final Dimension SIZE = new Dimension(1280, 800);
  private static volatile @Nullable Simbad instance;

  private final boolean backgroundMode;
  private final JDesktopPane desktop = new JDesktopPane();
  private final transient CountDownLatch closed = new CountDownLatch(1);
  private transient @Nullable Session session;
  private transient volatile Simulator simulator;

  /**
   * Opens the window and shows an environment in it.
   *
   * @param environment what the world contains
   * @param backgroundMode true to step at once, as fast as possible, without controls, and to draw
   *     rarely; false to wait for the user, and then to step in time with the clock
   * @throws DisplayException if there is no display
   */
  @SuppressWarnings("ThisEscapedInObjectConstruction")
  public Simbad(EnvironmentDescription environment, boolean backgroundMode) {
    super(titleWhereThereIsADisplay());
    this.backgroundMode = backgroundMode;
    instance = this;
    // Java 3D takes about a second to start; the frame is there before it has.
    SwingUtilities.invokeLater(this::openFrame);
    Session first = new Session(desktop, environment, backgroundMode);
    simulator = first.simulator();
    onEventThread(() -> show(first, environment));
  }

  private static String titleWhereThereIsADisplay() {
    if (GraphicsEnvironment.isHeadless()) {
      throw DisplayException.noWindow();
    }
    return TITLE;
  }

  /** Returns what steps the agents of the environment that is shown. */
  public Simulator getSimulator() {
    return simulator;
  }

  /** Returns the world that is shown. */
  public World getWorld() {
    return simulator.getWorld();
  }

  /**
   * Paints the window; from any thread but the event thread, has it painted soon. Old programs call
   * this from their main, which could wait for what the event thread holds, and it for them.
   */
  @Override
  public void update(Graphics graphics) {
    if (SwingUtilities.isEventDispatchThread()) {
      super.update(graphics);
    } else {
      repaint();
    }
  }

  private static void onEventThread(Runnable task) {
    if (SwingUtilities.isEventDispatchThread()) {
      task.run();
      return;
    }
    try {
      SwingUtilities.invokeAndWait(task);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (InvocationTargetException e) {
      throw new IllegalStateException(e.getCause());
    }
  }

  private void openFrame() {
    setIconImages(RobotIcon.images());
    desktop.setFocusable(true);
    setContentPane(desktop);
    // After the desktop has its place: what stands in a window takes the look on.
    Theme.install();
    setDefaultCloseOperation(EXIT_ON_CLOSE);
    Dimension screen = Toolkit.getDefaultToolkit().getScreenSize();
    setSize(Math.min(SIZE.width, screen.width), Math.min(SIZE.height, screen.height));
    setLocationRelativeTo(null);
    desktop.addComponentListener(new FollowSize());
    setVisible(true);
  }

  /** Arranges the windows anew when there is more or less room for them. */
  private final class FollowSize extends ComponentAdapter {
    @Override
    public void componentResized(ComponentEvent event) {
      arrange();
    }
  }

  private void show(Session opened, EnvironmentDescription environment) {
    closeSession();
    simulator = opened.simulator();
    if (closed.getCount() == 0) {
      // The window was closed while this world was made.
      Commands.run(opened::dispose);
      return;
    }
    session = opened;
    opened.open();
    setJMenuBar(menuBar(opened));
    setTitle(TITLE + " - " + name(environment));
    validate();
    opened.arrange();
  }

  private static String name(EnvironmentDescription environment) {
    String name = environment.getClass().getSimpleName();
    return name.isEmpty() ? "simulation" : name;
  }

  private JMenuBar menuBar(Session opened) {
    JMenuBar bar = new JMenuBar();
    Menus menus = new Menus(this);
    bar.add(menus.file());
    bar.add(DemoManager.createMenu(this));
    opened.menus().forEach(bar::add);
    bar.add(menus.window());
    bar.add(menus.help());
    return bar;
  }

  /**
   * Shows another environment instead of the present one. Returns at once; the windows change when
   * the new world is there.
   */
  public void open(EnvironmentDescription environment) {
    SwingUtilities.invokeLater(() -> replace(environment));
  }

  private void replace(EnvironmentDescription environment) {
    closeSession();
    Commands.run(
        () -> {
          Session next = new Session(desktop, environment, backgroundMode);
          SwingUtilities.invokeLater(() -> show(next, environment));
        });
  }

  private void closeSession() {
    Session former = session;
    session = null;
    if (former != null) {
      former.close();
      Commands.run(former::dispose);
    }
  }

  /** Opens the demo that was chosen in the menu of examples. */
  @Override
  public void actionPerformed(ActionEvent event) {
    Demo demo = DemoManager.getDemoFromActionEvent(event);
    if (demo != null) {
      open(demo);
    }
  }

  void arrange() {
    if (session != null) {
      session.arrange();
    }
  }

  void inspect() {
    if (session != null) {
      session.inspect();
    }
  }

  /** Runs the simulation that is shown, as the button does. Returns at once. */
  public void startSimulation() {
    SwingUtilities.invokeLater(
        () -> {
          if (session != null) {
            session.start();
          }
        });
  }

  /** Closes the window as its close button does. */
  void quit() {
    dispatchEvent(new WindowEvent(this, WindowEvent.WINDOW_CLOSING));
  }

  /** Closes the window and frees what it holds, in a moment; the program goes on. */
  @Override
  public void dispose() {
    closeSession();
    if (instance == this) {
      instance = null;
    }
    super.dispose();
    closed.countDown();
  }

  /** Waits until the window has been disposed of. */
  public void awaitClosed() throws InterruptedException {
    closed.await();
  }

  /** Returns the desktop on which the windows stand; programs may add their own. */
  public JDesktopPane getDesktopPane() {
    return desktop;
  }

  /** Returns the main window that was opened last, null if there is none. */
  public static @Nullable Simbad getSimbadInstance() {
    return instance;
  }

  /**
   * Opens the window with the first demo.
   *
   * @param args {@code -bg} for background mode
   */
  public static void main(String[] args) {
    new Simbad(new BaseDemo(), Arrays.asList(args).contains("-bg"));
  }
}
