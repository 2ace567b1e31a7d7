package simbad.sim;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.reflect.InvocationTargetException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import javax.vecmath.Vector3d;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import simbad.kernel.geometry.Placement;
import simbad.kernel.render.Picture;
import simbad.kernel.render.SoftwareCamera;

/** Cameras of a world that a window shows meanwhile; robots turn, and each step has its picture. */
@Tag("display")
class ShownCameraTest {
  private static final int STEPS = 100;
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
  private final JFrame frame = new JFrame();
  private World world = new World(environment);
  private Simulator simulator = new Simulator(null, world, environment);

  @BeforeEach
  void show() throws InterruptedException, InvocationTargetException {
    camera.setUpdateOnEachFrame(true);
    RobotFactory.addLightSensorLeft(robot).setUpdateOnEachFrame(true);
    environment.add(robot);
    environment.add(new Arch(new Vector3d(3, 0, 0), environment));
    world = new World(environment);
    simulator = new Simulator(null, world, environment);
    SwingUtilities.invokeAndWait(() -> show(frame, world));
  }

  @AfterEach
  void close() throws InterruptedException, InvocationTargetException {
    System.clearProperty(CameraKind.PROPERTY);
    SwingUtilities.invokeAndWait(frame::dispose);
    world.dispose();
  }

  private static void show(JFrame frame, World world) {
    frame.add(world.getCanvas3D());
    frame.setSize(300, 200);
    frame.setVisible(true);
  }

  /** What the camera should see now. */
  private Picture plainPicture() {
    Placement worldFromEye = new Placement();
    camera.placeInWorld(worldFromEye);
    Picture plain = new Picture(100, 100);
    new SoftwareCamera(world.getStage()).take(worldFromEye, plain);
    return plain;
  }

  /** The window draws meanwhile, and must not get in between a move and its picture. */
  @Test
  void camera_byJava3d_seesEachStepAsTheSoftwareDoes() {
    for (int step = 0; step < STEPS; step++) {
      Picture plain = plainPicture();
      simulator.simulateOneStep();
      int off = 0;
      for (int i = 0; i < plain.argb().length; i++) {
        off += difference(plain.argb()[i], camera.picture().argb()[i]) > SAME_LEVELS ? 1 : 0;
      }
      assertTrue(off <= MOST_OFF, "step " + step + ", pixels off: " + off);
    }
  }

  private static int difference(int one, int other) {
    int most = 0;
    for (int shift = 0; shift < 24; shift += 8) {
      most = Math.max(most, Math.abs((one >> shift & 0xff) - (other >> shift & 0xff)));
    }
    return most;
  }

  @Test
  void camera_bySoftware_isExactlyThat() {
    System.setProperty(CameraKind.PROPERTY, "software");
    Picture plain = plainPicture();
    simulator.simulateOneStep();
    assertArrayEquals(plain.argb(), camera.picture().argb());
  }

  /** Java 3D draws the window and takes pictures at once, on threads that wait for each other. */
  @Test
  void cameras_atFullSpeed_goOn() throws InterruptedException {
    simulator.startBackgroundMode();
    boolean done = stepped.await(120, TimeUnit.SECONDS);
    simulator.stopBackgroundMode();
    simulator.lock();
    simulator.unlock();
    assertTrue(done, "steps left: " + stepped.getCount());
  }
}
