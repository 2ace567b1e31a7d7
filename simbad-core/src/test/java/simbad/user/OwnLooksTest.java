package simbad.user;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.j3d.utils.geometry.ColorCube;
import java.awt.BorderLayout;
import java.awt.Canvas;
import java.awt.Color;
import java.awt.Point;
import java.awt.Robot;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import javax.media.j3d.Appearance;
import javax.media.j3d.ColoringAttributes;
import javax.media.j3d.Transform3D;
import javax.media.j3d.TransformGroup;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import javax.vecmath.Color3f;
import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import simbad.gui.Simbatch;
import simbad.scene3d.Figure;
import simbad.sim.Agent;
import simbad.sim.Box;
import simbad.sim.EnvironmentDescription;
import simbad.sim.MouseOrbiter;
import simbad.sim.Simulator;
import simbad.sim.World;

/** Programs that draw their agents themselves, with Java 3D, and show the world themselves. */
class OwnLooksTest {
  private static final int SIDE = 300;
  private static final long PATIENCE_MS = 60_000;

  private final EnvironmentDescription environment = new EnvironmentDescription();
  private final List<JFrame> frames = new ArrayList<>();
  private final List<World> worlds = new ArrayList<>();

  @AfterEach
  void close() throws Exception {
    SwingUtilities.invokeAndWait(() -> frames.forEach(JFrame::dispose));
    worlds.forEach(World::dispose);
  }

  /** A magenta sphere instead of a green robot. */
  private static final class Bubble extends Agent {
    Bubble() {
      super(new Vector3d(), "bubble");
    }

    @Override
    protected void create3D() {
      Appearance magenta = new Appearance();
      magenta.setColoringAttributes(
          new ColoringAttributes(new Color3f(1, 0, 1), ColoringAttributes.SHADE_FLAT));
      addChild(new com.sun.j3d.utils.geometry.Sphere(radius, magenta));
    }

    @Override
    protected void performBehavior() {
      setTranslationalVelocity(1);
    }
  }

  @Test
  void ownLooks_withoutADisplay_areLeftOut() {
    Bubble bubble = new Bubble();
    environment.add(bubble);
    Simbatch batch = new Simbatch(environment, false);
    batch.reset();
    batch.step();
    assertEquals(0.05, bubble.getOdometer(), 1e-12);
  }

  private Canvas show(World world) throws Exception {
    Canvas canvas = world.getCanvas3D();
    worlds.add(world);
    SwingUtilities.invokeAndWait(
        () -> {
          JFrame frame = new JFrame();
          frames.add(frame);
          frame.add(canvas, BorderLayout.CENTER);
          frame.setSize(SIDE, SIDE);
          frame.setVisible(true);
        });
    return canvas;
  }

  /** Waits until a pixel of the canvas has a colour, and fails if it never gets it. */
  private static void await(Canvas canvas, int x, int y, Predicate<Color> expected)
      throws Exception {
    Robot robot = new Robot();
    long end = System.nanoTime() + PATIENCE_MS * 1_000_000;
    Point corner = canvas.getLocationOnScreen();
    Color seen = robot.getPixelColor(corner.x + x, corner.y + y);
    while (!expected.test(seen)) {
      assertTrue(System.nanoTime() < end, "pixel " + x + ", " + y + " is " + seen);
      Thread.sleep(50);
      seen = robot.getPixelColor(corner.x + x, corner.y + y);
    }
  }

  private static boolean isMagenta(Color color) {
    return color.getRed() > 200 && color.getGreen() < 60 && color.getBlue() > 200;
  }

  private static boolean isGreen(Color color) {
    return color.getGreen() > 2 * color.getRed() && color.getGreen() > 2 * color.getBlue();
  }

  private World world(Agent agent) {
    environment.setWorldSize(3);
    environment.showAxis(false);
    environment.worldViewPoint = World.VIEW_FROM_TOP;
    environment.add(agent);
    return new World(environment);
  }

  @Test
  @Tag("display")
  void ownLooks_areShown_insteadOfTheBody_andMove() throws Exception {
    Bubble bubble = new Bubble();
    World world = world(bubble);
    Simulator simulator = new Simulator(null, world, environment);
    Canvas canvas = show(world);
    int x = canvas.getWidth() / 2;
    int y = canvas.getHeight() / 2;
    await(canvas, x, y, OwnLooksTest::isMagenta);
    for (int i = 0; i < 20; i++) {
      simulator.simulateOneStep();
    }
    await(canvas, x, y, color -> !isMagenta(color));
    simulator.resetSimulation();
    await(canvas, x, y, OwnLooksTest::isMagenta);
    bubble.detach();
    await(canvas, x, y, color -> !isMagenta(color));
  }

  /** An environment may be used again: its nodes go from the former scene to the next. */
  @Test
  @Tag("display")
  void ownLooks_goToTheNextWorld() throws Exception {
    World former = world(new Bubble());
    new Simulator(null, former, environment).dispose();
    show(former);
    former.dispose();
    World next = new World(environment);
    new Simulator(null, next, environment);
    Canvas canvas = show(next);
    await(canvas, canvas.getWidth() / 2, canvas.getHeight() / 2, OwnLooksTest::isMagenta);
  }

  @Test
  @Tag("display")
  void colours_changeWhileShown() throws Exception {
    Agent agent =
        new Agent(new Vector3d(-0.1, 0, 0), "chameleon") {
          @Override
          protected void performBehavior() {
            setColor(new Color3f(1, 0, 1));
          }
        };
    World world = world(agent);
    Simulator simulator = new Simulator(null, world, environment);
    Canvas canvas = show(world);
    int besideTheNose = canvas.getHeight() / 2 - 20;
    await(canvas, canvas.getWidth() / 2 - 20, besideTheNose, OwnLooksTest::isGreen);
    simulator.simulateOneStep();
    await(
        canvas,
        canvas.getWidth() / 2 - 20,
        besideTheNose,
        color -> color.getRed() > 2 * color.getGreen());
  }

  /** Something that only the window shows. */
  @Test
  @Tag("display")
  void decoration_ofAnObject_isShown() throws Exception {
    environment.add(
        new Box(new Vector3d(0, -2, 0), new javax.vecmath.Vector3f(1, 1, 1), environment) {
          @Override
          protected void decorate(Figure figure) {
            Transform3D up = new Transform3D();
            up.setTranslation(new Vector3d(0, 2, 0));
            TransformGroup group = new TransformGroup(up);
            group.addChild(new ColorCube(0.2));
            figure.add(group);
          }
        });
    environment.setWorldSize(3);
    environment.worldViewPoint = World.VIEW_FROM_TOP;
    Canvas canvas = show(new World(environment));
    // The top of a colour cube.
    await(canvas, canvas.getWidth() / 2, canvas.getHeight() / 2, OwnLooksTest::isMagenta);
  }

  @Test
  @Tag("display")
  void mouse_movesTheEye_andADoubleClickBringsItBack() throws Exception {
    Canvas canvas = show(new World(environment));
    TransformGroup eye = new TransformGroup();
    Transform3D start = new Transform3D();
    start.setTranslation(new Vector3d(0, 0, 10));
    eye.setTransform(start);
    MouseOrbiter orbiter = new MouseOrbiter((javax.media.j3d.Canvas3D) canvas, eye);
    orbiter.setRotationCenter(new Point3d());
    orbiter.mousePressed(mouse(canvas, MouseEvent.MOUSE_PRESSED, MouseEvent.BUTTON1, 100, 100));
    orbiter.mouseDragged(mouse(canvas, MouseEvent.MOUSE_DRAGGED, MouseEvent.BUTTON1, 50, 100));
    checkEye(eye, 10 * Math.sin(0.5), 0, 10 * Math.cos(0.5));
    orbiter.mouseDragged(mouse(canvas, MouseEvent.MOUSE_DRAGGED, MouseEvent.BUTTON2, 50, 100));
    orbiter.resetView();
    checkEye(eye, 0, 0, 10);
    orbiter.mousePressed(mouse(canvas, MouseEvent.MOUSE_PRESSED, MouseEvent.BUTTON3, 100, 100));
    int dragged = 100 - canvas.getWidth();
    orbiter.mouseDragged(mouse(canvas, MouseEvent.MOUSE_DRAGGED, MouseEvent.BUTTON3, dragged, 100));
    checkEye(eye, 8.3, 0, 10);
    orbiter.mouseClicked(mouse(canvas, MouseEvent.MOUSE_CLICKED, MouseEvent.BUTTON1, 1, 1));
    checkEye(eye, 0, 0, 10);
    orbiter.mousePressed(mouse(canvas, MouseEvent.MOUSE_PRESSED, MouseEvent.BUTTON2, 100, 100));
    orbiter.mouseDragged(mouse(canvas, MouseEvent.MOUSE_DRAGGED, MouseEvent.BUTTON2, 100, 90));
    checkEye(eye, 0, 0, 10 * Math.pow(1.01, -10));
  }

  private static void checkEye(TransformGroup eye, double x, double y, double z) {
    Transform3D transform = new Transform3D();
    eye.getTransform(transform);
    Vector3d place = new Vector3d();
    transform.get(place);
    place.sub(new Vector3d(x, y, z));
    assertEquals(0, place.length(), 1e-6);
  }

  private static MouseEvent mouse(Canvas canvas, int id, int button, int x, int y) {
    int mask = MouseEvent.getMaskForButton(button);
    return new MouseEvent(canvas, id, 0, mask, x, y, 2, false, button);
  }
}
