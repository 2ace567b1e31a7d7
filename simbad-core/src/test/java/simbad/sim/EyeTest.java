package simbad.sim;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.Objects;
import java.util.concurrent.CompletableFuture;
import javax.swing.JPanel;
import javax.vecmath.Color3f;
import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import simbad.kernel.geometry.Placement;
import simbad.kernel.render.Picture;

/** Cameras and light sensors as programs use them. */
class EyeTest {
  private static final int BLACK = 0xff000000;
  private static final double EPS = 1e-6;

  private final EnvironmentDescription environment = new EnvironmentDescription();
  private final Agent robot = new Agent(new Vector3d(), "robot");

  private Simulator start() {
    environment.add(robot);
    Simulator simulator = new Simulator(null, new World(environment), environment);
    simulator.initBehaviors();
    return simulator;
  }

  private static void step(Simulator simulator, int steps) {
    for (int i = 0; i < steps; i++) {
      simulator.simulateOneStep();
    }
  }

  private Agent addRobotAhead() {
    Agent other = new Agent(new Vector3d(2, 0, 0), "other");
    other.setColor(new Color3f(0, 0, 1));
    environment.add(other);
    return other;
  }

  private static int[] image(Eye eye) {
    BufferedImage image = eye.createCompatibleImage();
    eye.copyVisionImage(image);
    return image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
  }

  private static boolean seesBlue(Eye eye) {
    return Arrays.stream(image(eye)).anyMatch(p -> (p & 0xff) > (p >> 8 & 0xff) + 20);
  }

  @Test
  void camera_isBlackUntilItsFirstUpdate_andAfterAReset() {
    CameraSensor camera = RobotFactory.addCameraSensor(robot);
    Simulator simulator = start();
    assertEquals(10_000, Arrays.stream(image(camera)).filter(p -> p == BLACK).count());
    step(simulator, 1);
    assertEquals(0, Arrays.stream(image(camera)).filter(p -> p == BLACK).count());
    simulator.resetSimulation();
    assertEquals(10_000, Arrays.stream(image(camera)).filter(p -> p == BLACK).count());
  }

  /** The image is that of the step: what stands ahead at the step's start, and 3 times a second. */
  @Test
  void camera_seesTheWorldOfItsStep() {
    CameraSensor camera = RobotFactory.addCameraSensor(robot);
    Agent other = addRobotAhead();
    Simulator simulator = start();
    step(simulator, 1);
    assertTrue(seesBlue(camera));
    camera.setUpdateOnEachFrame(true);
    other.moveToPosition(0, 5);
    step(simulator, 1);
    assertFalse(seesBlue(camera));
    other.moveToPosition(2, 0);
    assertFalse(seesBlue(camera));
    step(simulator, 1);
    assertTrue(seesBlue(camera));
    other.detach();
    step(simulator, 1);
    assertFalse(seesBlue(camera));
  }

  @Test
  void camera_updatesThreeTimesASecond() {
    CameraSensor camera = RobotFactory.addCameraSensor(robot);
    assertEquals(3, camera.getUpdatePerSecond());
    Agent other = addRobotAhead();
    Simulator simulator = start();
    step(simulator, 13);
    int[] old = image(camera);
    other.detach();
    assertArrayEquals(old, image(camera));
    step(simulator, 1);
    assertFalse(Arrays.equals(old, image(camera)));
  }

  @Test
  void camera_sitsOnTopAndDoesNotSeeItsNose() {
    environment.showAxis(false);
    CameraSensor camera = RobotFactory.addCameraSensor(robot);
    assertEquals("Camera", camera.getName());
    step(start(), 1);
    Placement place = new Placement();
    camera.placeInWorld(place);
    assertEquals(0.575, place.yM(), EPS);
    // The floor and what is behind it are gray, the nose is red and the rim green.
    for (int pixel : image(camera)) {
      assertEquals(pixel >> 16 & 0xff, pixel >> 8 & 0xff, Integer.toHexString(pixel));
    }
  }

  @Test
  void matrix_isTheMeanOfTheImagesColours() {
    CameraSensor camera = RobotFactory.addCameraSensor(robot);
    addRobotAhead();
    step(start(), 1);
    SensorMatrix matrix = camera.createCompatibleSensorMatrix();
    camera.copyVisionImage(matrix);
    assertEquals(100, matrix.getWidth());
    assertEquals(100, matrix.getHeight());
    int[] pixels = image(camera);
    for (int i = 0; i < pixels.length; i++) {
      int sum = (pixels[i] >> 16 & 0xff) + (pixels[i] >> 8 & 0xff) + (pixels[i] & 0xff);
      assertEquals(sum / 765f, matrix.get(i % 100, i / 100), EPS);
    }
    assertEquals(0.8f, matrix.get(0.5f, 0f), EPS);
  }

  @Test
  void copy_intoAnotherSize_isRefused() {
    CameraSensor camera = RobotFactory.addCameraSensor(robot);
    assertEquals(100, camera.getImageWidth());
    assertEquals(100, camera.getImageHeight());
    BufferedImage small = new BufferedImage(99, 100, BufferedImage.TYPE_INT_RGB);
    checkRefused("image = 99 x 100 is not 100 x 100", () -> camera.copyVisionImage(small));
    SensorMatrix large = new SensorMatrix(100, 101);
    checkRefused("matrix = 100 x 101 is not 100 x 100", () -> camera.copyVisionImage(large));
  }

  private static void checkRefused(String message, Runnable call) {
    assertEquals(message, assertThrows(IllegalArgumentException.class, call::run).getMessage());
  }

  @Test
  void eye_outsideAWorld_staysBlack() {
    LightSensor sensor = RobotFactory.addLightSensor(robot);
    sensor.update();
    assertEquals(0, sensor.getAverageLuminance());
    assertEquals(0, sensor.getLux());
  }

  /** By default the lamp is far away at +z: it lights the body's right side, heading along +x. */
  @Test
  void sideSensors_seeTheirSideOfTheBody() {
    LightSensor left = RobotFactory.addLightSensorLeft(robot);
    LightSensor right = RobotFactory.addLightSensorRight(robot);
    assertEquals("Light Sensor left", left.getName());
    assertEquals("Light Sensor right", right.getName());
    Simulator simulator = start();
    step(simulator, 1);
    // In the shade there is the light from everywhere, of which a robot reflects 0.2.
    assertEquals(0.2, left.getAverageLuminance(), 0.01);
    assertEquals(0.58, right.getAverageLuminance(), 0.02);
    simulator.resetSimulation();
    assertEquals(0, left.getAverageLuminance());
  }

  @Test
  void sideSensors_sitHalfAMetreOffTheBody() {
    Placement place = new Placement();
    RobotFactory.addLightSensorLeft(robot).placeInWorld(place);
    assertEquals(0.8 * Math.sqrt(0.5), place.xM(), EPS);
    assertEquals(-0.8 * Math.sqrt(0.5), place.zM(), EPS);
    assertEquals(Math.PI / 4, place.headingRad(), EPS);
    RobotFactory.addLightSensorRight(robot).placeInWorld(place);
    assertEquals(0.8 * Math.sqrt(0.5), place.zM(), EPS);
    assertEquals(-Math.PI / 4, place.headingRad(), EPS);
    RobotFactory.addLightSensor(robot).placeInWorld(place);
    assertEquals(0.25, place.yM(), EPS);
    assertEquals(-Math.PI / 2, place.headingRad(), EPS);
  }

  /** A white wall fills the view of a sensor that faces away from it; the lamp is at the sensor. */
  @Test
  void luminance_ofAWallBehind_followsTheFormula() {
    environment.light1SetPosition(2, 0.5, 0);
    environment.showAxis(false);
    environment.setWorldSize(0.1f);
    environment.add(new Box(new Vector3d(-3, -49.5, 0), new Vector3f(2, 100, 100), environment));
    Vector3d ahead = new Vector3d(2, 0.25, 0);
    LightSensor sensor = RobotFactory.addLightSensor(robot, ahead, 0, "rear");
    assertEquals("Light Sensor rear", sensor.getName());
    step(start(), 1);
    double light = 4 / Math.sqrt(16 + 2 * 50 * 50) / 0.5;
    long red = Math.round(255 * 0.8 * (0.3 + light));
    assertTrue(sensor.getAverageLuminance() < 0.2);
    robot.detach();
    sensor.update();
    assertEquals(0.299 * red / 255, sensor.getAverageLuminance(), EPS);
  }

  /**
   * The mean over the lamps that are on, whatever is in between, at the height of the sensor alone.
   */
  @Test
  void lux_isTheLampsByTheirDistanceSquared() {
    environment.light1SetPosition(0, 0.5, -4);
    environment.light2IsOn = true;
    environment.light2Color = new Color3f(0, 1, 0);
    environment.light2SetPosition(2, 0.5, 0);
    environment.add(new Box(new Vector3d(0, 0, -2), new Vector3f(1, 1, 1), environment));
    LightSensor sensor = RobotFactory.addLightSensor(robot);
    start();
    double far = 0.25 / (16 + 0.0625);
    double near = 0.25 / (4 + 0.0625);
    assertEquals((far + near) / 2, sensor.getLux(), EPS);
    World world = Objects.requireNonNull(robot.world);
    world.getLight1().setEnable(false);
    assertEquals(near, sensor.getLux(), EPS);
    robot.moveToPosition(2, 0);
    assertEquals(1, sensor.getLux(), EPS);
    world.getLight2().setEnable(false);
    assertEquals(0, sensor.getLux(), EPS);
  }

  /** As the window does that paints the image while Java 3D waits for the window. */
  @Test
  @Timeout(60)
  void imageOfTheStepBefore_canBeReadWhileTheNextIsTaken() {
    CameraSensor camera = RobotFactory.addCameraSensor(robot);
    BufferedImage image = camera.createCompatibleImage();
    World slow =
        new World(environment) {
          @Override
          void takePicture(Placement worldFromEye, Picture picture) {
            picture.argb()[0] = 0xff00ff00;
            CompletableFuture.runAsync(() -> camera.copyVisionImage(image)).join();
          }
        };
    camera.setWorld(slow);
    camera.update();
    assertEquals(0xff000000, image.getRGB(0, 0));
    camera.copyVisionImage(image);
    assertEquals(0xff00ff00, image.getRGB(0, 0));
  }

  /** The robot looks along -z: what is on its left is at -x of its middle. */
  @Test
  void place_isKnownOnTheRobotAndInTheWorld() {
    Vector3d onRobot = new Vector3d(0.1, 0.2, -0.4);
    LightSensor sensor = RobotFactory.addLightSensor(robot, onRobot, 0, "left");
    assertEquals(onRobot, sensor.position);
    start();
    robot.moveToPosition(3, 2);
    robot.rotateY(Math.PI / 2);
    Point3d expected = new Point3d(3 - 0.4, 0.2, 2 - 0.1);
    assertEquals(0, expected.distance(LightSensor.getGlobalCoords(robot, onRobot)), EPS);
    assertEquals(0, expected.distance(sensor.getPosition()), EPS);
  }

  @Test
  void runs_ofTheSameProgram_giveTheSameBytes() {
    int[][] images = new int[2][];
    for (int run = 0; run < 2; run++) {
      EyeTest fresh = new EyeTest();
      CameraSensor camera = RobotFactory.addCameraSensor(fresh.robot);
      fresh.addRobotAhead();
      fresh.environment.add(new Arch(new Vector3d(5, 0, 1), fresh.environment));
      Simulator simulator = fresh.start();
      fresh.robot.setTranslationalVelocity(0.4);
      fresh.robot.setRotationalVelocity(0.2);
      step(simulator, 40);
      images[run] = image(camera);
      assertEquals(BLACK, images[run][0] & BLACK);
    }
    assertArrayEquals(images[0], images[1]);
  }

  @Test
  void panels_paintWhatIsSeen() {
    CameraSensor camera = RobotFactory.addCameraSensor(robot);
    LightSensor light = RobotFactory.addLightSensor(robot);
    JPanel picture = camera.createInspectorPanel();
    JPanel bar = light.createInspectorPanel();
    int dark = paint(bar, 20, 10);
    paint(picture, 50, 50);
    step(start(), 1);
    assertEquals(image(camera)[45 * 100 + 45], paint(picture, 50, 50));
    assertNotEquals(dark, paint(bar, 20, 10));
  }

  private static int paint(JPanel panel, int x, int y) {
    panel.setSize(panel.getPreferredSize());
    BufferedImage image =
        new BufferedImage(panel.getWidth(), panel.getHeight(), BufferedImage.TYPE_INT_ARGB);
    panel.paint(image.getGraphics());
    return image.getRGB(x, y);
  }

  @Test
  void world_disposed_takesPicturesAgain() {
    CameraSensor camera = RobotFactory.addCameraSensor(robot);
    step(start(), 1);
    int[] before = image(camera);
    robot.world.dispose();
    robot.world.dispose();
    camera.update();
    assertArrayEquals(before, image(camera));
  }
}
