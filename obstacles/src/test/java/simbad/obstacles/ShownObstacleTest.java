package simbad.obstacles;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.AWTException;
import java.awt.Canvas;
import java.awt.Color;
import java.awt.GraphicsEnvironment;
import java.awt.Point;
import java.awt.Robot;
import java.util.Objects;
import java.util.function.Predicate;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import javax.vecmath.Vector3d;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import simbad.sim.Agent;
import simbad.sim.EnvironmentDescription;
import simbad.sim.Simulator;
import simbad.sim.World;
import simbad.sonar.model.DetectionRule;

/** A detection shadow and the cones of a belt, as the window shows them from above. */
@Tag("display")
class ShownObstacleTest {
  private static final int SIDE_PX = 400;
  private static final double WORLD_M = 8;
  private static final long PATIENCE_MS = 60_000;

  private final EnvironmentDescription environment = new EnvironmentDescription();
  private final JFrame frame = new JFrame();
  private @Nullable World world;

  @AfterEach
  void close() throws Exception {
    SwingUtilities.invokeAndWait(frame::dispose);
    if (world != null) {
      world.dispose();
    }
  }

  private Canvas show() throws Exception {
    assertEquals(false, GraphicsEnvironment.isHeadless(), "this test needs a display");
    environment.setWorldSize((float) WORLD_M);
    environment.showAxis(false);
    environment.worldViewPoint = World.VIEW_FROM_TOP;
    World shown = new World(environment);
    world = shown;
    Canvas canvas = shown.getCanvas3D();
    SwingUtilities.invokeAndWait(
        () -> {
          frame.add(canvas);
          frame.setSize(SIDE_PX, SIDE_PX);
          frame.setVisible(true);
        });
    return canvas;
  }

  /**
   * Returns the colour of the floor at a place, metres. A square window sees 1.12 world sides
   * across: all of the floor, and a margin.
   */
  private static Color color(Canvas canvas, double x, double z) throws AWTException {
    double pixelsPerMetre = canvas.getWidth() / (1.12 * WORLD_M);
    Point corner = canvas.getLocationOnScreen();
    return new Robot()
        .getPixelColor(
            corner.x + (int) (canvas.getWidth() / 2.0 + x * pixelsPerMetre),
            corner.y + (int) (canvas.getHeight() / 2.0 + z * pixelsPerMetre));
  }

  private static void await(Canvas canvas, double x, double z, Predicate<Color> expected)
      throws Exception {
    long end = System.nanoTime() + PATIENCE_MS * 1_000_000;
    while (!expected.test(color(canvas, x, z))) {
      assertTrue(System.nanoTime() < end, "at " + x + ", " + z + " is " + color(canvas, x, z));
      Thread.sleep(50);
    }
  }

  private static boolean isGrey(Color color) {
    return Math.abs(color.getRed() - color.getBlue()) < 10 && color.getRed() > 60;
  }

  /** More red than blue, with green about between the two. */
  private static boolean isSand(Color color) {
    return color.getRed() > color.getBlue() + 30 && color.getGreen() > color.getBlue() + 10;
  }

  private static int redness(Color color) {
    return color.getRed() - color.getGreen();
  }

  @Test
  void shadow_ofAnObstacle_isShown() throws Exception {
    environment.add(new RoundObstacle(new Vector3d(), 0));
    Canvas canvas = show();
    await(canvas, 1.1, 1.1, ShownObstacleTest::isSand);
    await(canvas, 2.6, 2.6, ShownObstacleTest::isGrey);
  }

  /** Before the first ping the cones are stubs; where something is heard they reach it. */
  @Test
  void cones_areAsLongAsTheRange() throws Exception {
    environment.add(new RoundObstacle(new Vector3d(), 0));
    SonarBelt belt = Bench.belt(DetectionRule.ORIGINAL);
    belt.setUpdateOnEachFrame(true);
    Agent robot =
        new Agent(new Vector3d(2.4, 0, 0), "robot") {
          @Override
          protected void create() {
            super.create();
            addSensorDevice(belt, new Vector3d(), 0);
          }
        };
    environment.add(robot);
    Canvas canvas = show();
    Simulator simulator = new Simulator(null, Objects.requireNonNull(world), environment);
    await(canvas, 1.4, 0.42, ShownObstacleTest::isSand);
    int redBefore = redness(color(canvas, 1.4, 0.42));
    simulator.simulateOneStep();
    assertEquals(true, belt.hasHit(6));
    // A metre ahead of the robot, 23 degrees off the sonar's axis, seen through the shadow.
    await(canvas, 1.4, 0.42, color -> redness(color) > redBefore + 8);
  }
}
