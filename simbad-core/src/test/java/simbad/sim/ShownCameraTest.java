package simbad.sim;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.reflect.InvocationTargetException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import javax.vecmath.Vector3d;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import simbad.kernel.geometry.Placement;
import simbad.kernel.render.Picture;
import simbad.kernel.render.SoftwareCamera;

/** Cameras of a world that a window shows meanwhile. */
@Tag("display")
class ShownCameraTest {
  private static final int STEPS = 300;
  private static final int SAME_LEVELS = 2;
  private static final int MOST_OFF = 20;

  private final EnvironmentDescription environment = new EnvironmentDescription();
  private final CountDownLatch stepped = new CountDownLatch(STEPS);
  private final Agent robot =
      new Agent(new Vector3d(), "robot") {
        @Override
        protected void performBehavior() {
          setRotationalVelocity(0.3);
          stepped.countDown();
        }
      };
  private final CameraSensor camera = RobotFactory.addCameraSensor(robot);

  @AfterEach
  void forget() {
    System.clearProperty(CameraKind.PROPERTY);
  }

  /** Runs at full speed while the window draws; then both pictures of the last pose are taken. */
  private Picture runAndTakePlainPicture() throws InterruptedException, InvocationTargetException {
    camera.setUpdateOnEachFrame(true);
    RobotFactory.addLightSensorLeft(robot).setUpdateOnEachFrame(true);
    environment.add(robot);
    environment.add(new Arch(new Vector3d(3, 0, 0), environment));
    World world = new World(environment);
    Simulator simulator = new Simulator(null, world, environment);
    JFrame frame = new JFrame();
    SwingUtilities.invokeAndWait(() -> show(frame, world));
    simulator.startBackgroundMode();
    boolean done = stepped.await(60, TimeUnit.SECONDS);
    simulator.stopBackgroundMode();
    assertTrue(done, "steps left: " + stepped.getCount());
    camera.update();
    Placement worldFromEye = new Placement();
    camera.placeInWorld(worldFromEye);
    Picture plain = new Picture(100, 100);
    new SoftwareCamera(world.getStage()).take(worldFromEye, plain);
    SwingUtilities.invokeAndWait(frame::dispose);
    world.dispose();
    return plain;
  }

  private static void show(JFrame frame, World world) {
    frame.add(world.getCanvas3D());
    frame.setSize(300, 200);
    frame.setVisible(true);
  }

  @Test
  void camera_byJava3d_seesWhatTheSoftwareSees() throws Exception {
    Picture plain = runAndTakePlainPicture();
    int off = 0;
    for (int i = 0; i < plain.argb().length; i++) {
      off += difference(plain.argb()[i], camera.picture().argb()[i]) > SAME_LEVELS ? 1 : 0;
    }
    assertTrue(off <= MOST_OFF, "pixels off: " + off);
    assertEquals(plain.luminance(), camera.picture().luminance(), 0.002);
  }

  private static int difference(int one, int other) {
    int most = 0;
    for (int shift = 0; shift < 24; shift += 8) {
      most = Math.max(most, Math.abs((one >> shift & 0xff) - (other >> shift & 0xff)));
    }
    return most;
  }

  @Test
  void camera_bySoftware_isExactlyThat() throws Exception {
    System.setProperty(CameraKind.PROPERTY, "software");
    assertArrayEquals(runAndTakePlainPicture().argb(), camera.picture().argb());
  }
}
