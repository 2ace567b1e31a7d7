package simbad.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import javax.media.j3d.BoundingBox;
import javax.media.j3d.BoundingSphere;
import javax.swing.JPanel;
import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;
import org.junit.jupiter.api.Test;

/** Line sensors, keys, matrices and the panels that show devices, all without a display. */
class DevicesTest {
  private final EnvironmentDescription environment = new EnvironmentDescription();
  private final Agent robot = new Agent(new Vector3d(), "robot");

  private Simulator run(int steps) {
    environment.add(robot);
    Simulator simulator = new Simulator(null, new World(environment), environment);
    for (int i = 0; i < steps; i++) {
      simulator.simulateOneStep();
    }
    return simulator;
  }

  /** Returns the number of colours that a panel shows. */
  private static long colours(JPanel panel) {
    panel.setSize(panel.getPreferredSize().width + 50, panel.getPreferredSize().height + 50);
    BufferedImage image =
        new BufferedImage(panel.getWidth(), panel.getHeight(), BufferedImage.TYPE_INT_RGB);
    panel.paint(image.getGraphics());
    int[] pixels =
        image.getRGB(0, 0, panel.getWidth(), panel.getHeight(), null, 0, panel.getWidth());
    return Arrays.stream(pixels).distinct().count();
  }

  @Test
  void lineSensor_seesTheLineBelow_only() {
    // The line is 8 cm wide round z = 0: of rays at 0, 3 and 6 cm from the middle the outer miss.
    LineSensor sensor = RobotFactory.addLineSensor(robot);
    Line line = new Line(new Vector3d(-1, 0, 0), 3, environment);
    line.rotate90(1);
    environment.add(line);
    run(1);
    boolean[] hits = {false, true, true, true, false};
    for (int i = 0; i < hits.length; i++) {
      assertEquals(hits[i], sensor.hasHit(i), "ray " + i);
    }
    // The line is 5 mm high, the rays start at 25 mm.
    assertEquals(0.0225, sensor.getMeasurement(2), 1e-6);
    assertEquals(0.025f, sensor.getMeasurement(0));
    assertTrue(colours(sensor.createInspectorPanel()) >= 3);
    sensor.reset();
    assertFalse(sensor.hasHit(2));
  }

  @Test
  void lineSensor_flags() {
    LineSensor sensor = new LineSensor(0.3f, 0, 0.1f, 2, LineSensor.FLAG_RETURN_INFINITY);
    sensor.update();
    assertEquals(Double.POSITIVE_INFINITY, sensor.getMeasurement(1));
    assertEquals(2, sensor.getNumSensors());
    assertEquals(0.1f, sensor.getMaxRange());
    assertEquals(LineSensor.FLAG_RETURN_INFINITY, sensor.getFlags());
  }

  @Test
  void line_turnsAboutItsStart() {
    Line line = new Line(new Vector3d(1, 0, 2), 3, environment);
    BoundingBox along = (BoundingBox) line.getTransformedBounds();
    checkBox(along, new Point3d(0.96, -0.0025, 2), new Point3d(1.04, 0.0025, 5));
    line.rotate90(1);
    BoundingBox across = (BoundingBox) line.getTransformedBounds();
    checkBox(across, new Point3d(1, -0.0025, 1.96), new Point3d(4, 0.0025, 2.04));
  }

  private static void checkBox(BoundingBox box, Point3d lower, Point3d upper) {
    Point3d corner = new Point3d();
    box.getLower(corner);
    assertTrue(corner.epsilonEquals(lower, 1e-6), "lower = " + corner);
    box.getUpper(corner);
    assertTrue(corner.epsilonEquals(upper, 1e-6), "upper = " + corner);
  }

  @Test
  void keys_areRemembered_untilReset() {
    KeyInputSensor keys = RobotFactory.addKeyInputSensor(robot);
    JPanel panel = keys.createInspectorPanel();
    run(2);
    assertEquals(KeyEvent.VK_UNDEFINED, keys.getLastKey());
    assertTrue(colours(panel) >= 2);
    KeyEvent event =
        new KeyEvent(panel, KeyEvent.KEY_PRESSED, 0, 0, KeyEvent.VK_LEFT, KeyEvent.CHAR_UNDEFINED);
    keys.keyPressed(event);
    keys.keyTyped(event);
    keys.keyReleased(event);
    assertEquals(KeyEvent.VK_LEFT, keys.getLastKey());
    assertTrue(colours(panel) >= 2);
    assertSame(keys, panel.getKeyListeners()[0]);
    keys.reset();
    assertEquals(KeyEvent.VK_UNDEFINED, keys.getLastKey());
  }

  @Test
  void panels_showBelts_andLamps() {
    RangeSensorBelt sonars = RobotFactory.addSonarBeltSensor(robot);
    RangeSensorBelt bumpers = RobotFactory.addBumperBeltSensor(robot);
    LampActuator lamp = RobotFactory.addLamp(robot);
    environment.add(new Box(new Vector3d(1, 0, 0), new Vector3f(0.5f, 1, 0.5f), environment));
    run(1);
    assertTrue(sonars.hasHit(0));
    assertTrue(colours(sonars.createInspectorPanel()) >= 3);
    assertTrue(colours(bumpers.createInspectorPanel()) >= 2);
    assertTrue(colours(lamp.createInspectorPanel()) >= 2);
    lamp.setOn(true);
    assertTrue(colours(lamp.createInspectorPanel()) >= 2);
    assertEquals(1, new GripperActuator().createInspectorPanel().getComponentCount());
  }

  @Test
  void matrix_isReadByCell_andByShare() {
    SensorMatrix matrix = new SensorMatrix(3, 2);
    matrix.getArray()[5] = 7;
    assertEquals(7, matrix.get(2, 1));
    assertEquals(7, matrix.get(1f, 1f));
    assertEquals(0, matrix.get(0f, 0f));
    SensorMatrix copy = (SensorMatrix) matrix.clone();
    matrix.getArray()[5] = 8;
    assertNotSame(matrix, copy);
    assertEquals(7, copy.get(2, 1));
    assertEquals(3, copy.getWidth());
    assertEquals(2, copy.getHeight());
  }

  @Test
  void soccer_hasAField_andABall() {
    WorldFactory.setRoboSoccerEnvironment(environment);
    assertEquals(6, new World(environment).getStaticObjects().size());
    assertEquals(1, environment.list(BallAgent.class).size());
    assertNotNull(new WorldFactory());
  }

  @Test
  void view_withoutAWindow_isNobodysBusiness() {
    World world = new World(environment);
    world.changeViewPoint(World.VIEW_FROM_TOP, null);
    world.stopRendering();
    world.startRendering();
    world.renderOnce();
    JPanel panel = new JPanel();
    assertNull(robot.getUIPanel());
    robot.setUIPanel(panel);
    assertSame(panel, robot.getUIPanel());
    assertNotNull(new Geometry());
  }

  @Test
  void engine_comparesSpheres_withBoxes() {
    PhysicalEngine engine = new PhysicalEngine();
    BoundingSphere sphere = new BoundingSphere(new Point3d(1.2, 0.5, 0), 0.3);
    BoundingBox unit = new BoundingBox(new Point3d(0, 0, 0), new Point3d(1, 1, 1));
    Box box = new Box(new Vector3d(0.5, 0, 0.5), new Vector3f(1, 1, 1), environment);
    assertTrue(engine.intersect(sphere, unit));
    assertTrue(engine.intersect(sphere, box));
    sphere.setRadius(0.1);
    assertFalse(engine.intersect(sphere, unit));
    assertFalse(engine.intersect(sphere, box));
  }
}
