package simbad.scene3d;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import javax.vecmath.Color3f;
import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import simbad.kernel.geometry.Placement;
import simbad.kernel.render.Picture;
import simbad.kernel.render.PictureSource;
import simbad.kernel.render.SoftwareCamera;
import simbad.sim.Agent;
import simbad.sim.Arch;
import simbad.sim.BallAgent;
import simbad.sim.Box;
import simbad.sim.CherryAgent;
import simbad.sim.EnvironmentDescription;
import simbad.sim.KheperaRobot;
import simbad.sim.LampActuator;
import simbad.sim.Line;
import simbad.sim.RobotFactory;
import simbad.sim.Simulator;
import simbad.sim.Wall;
import simbad.sim.World;

/**
 * The two ways to take a picture show the same. Only pixels on edges may differ: by rounding, a
 * pixel's centre falls to one side here and to the other there.
 */
@Tag("display")
class BothCamerasTest {
  private static final int SIDE_PX = 100;

  /** Largest difference of a share of red, green or blue that counts as equal, of 255. */
  private static final int SAME_LEVELS = 2;

  /** How many of the 10,000 pixels may differ by more; at most 1 was measured with llvmpipe. */
  private static final int MOST_OFF = 20;

  /** Mean of the largest difference per pixel, of 255; at most 0.013 was measured. */
  private static final double MOST_MEAN = 0.2;

  private static final Path OUT = Path.of("target", "cameras");

  /** What there is to see, and from where. */
  private record Sight(
      String name, Placement worldFromEye, Consumer<EnvironmentDescription> content) {
    World world() {
      EnvironmentDescription environment = new EnvironmentDescription();
      content.accept(environment);
      World world = new World(environment);
      new Simulator(null, world, environment);
      return world;
    }

    @Override
    public String toString() {
      return name;
    }
  }

  static Stream<Sight> sights() {
    return Stream.of(
        new Sight("empty", Placement.at(0, 0.575, 0), e -> {}),
        new Sight(
            "boxes",
            Placement.at(0, 0.575, 0),
            e -> {
              e.add(box(e, 3, 0, -1));
              e.add(box(e, 4, 0, 0.6));
              e.add(box(e, 3.5, 1.2, 0));
            }),
        new Sight(
            "arches",
            Placement.at(0, 0.575, 0.3),
            e -> {
              e.add(new Arch(new Vector3d(5, 0, 0), e));
              Arch turned = new Arch(new Vector3d(8, 0, 1), e);
              turned.rotate90(1);
              e.add(turned);
            }),
        new Sight(
            "wall-at-an-angle",
            Placement.at(0, 0.575, 0),
            e -> {
              Wall wall = new Wall(new Vector3d(3, 0, 0), 12, 1.5f, e);
              wall.rotateY(0.7);
              e.add(wall);
            }),
        new Sight(
            "robots",
            Placement.at(0, 1, 0),
            e -> {
              e.add(new Agent(new Vector3d(2, 0, 0.4), "green"));
              Agent other = new Agent(new Vector3d(3, 0, -0.6), "purple");
              other.setColor(new Color3f(0.6f, 0.1f, 0.6f));
              e.add(other);
            }),
        new Sight(
            "balls",
            Placement.at(0, 0.575, 0),
            e -> {
              e.add(new BallAgent(new Vector3d(1.5, 0, 0.3), "ball", 0.25f));
              e.add(new CherryAgent(new Vector3d(1.2, 0, -0.2), "cherry", 0.1f));
            }),
        new Sight(
            "khepera",
            Placement.at(0, 0.05, 0),
            e -> e.add(new KheperaRobot(new Vector3d(0.2, 0, 0), "khepera"))),
        new Sight(
            "lamps",
            Placement.at(0, 0.8, 0),
            e -> {
              e.add(lamp(2, -0.5, true));
              e.add(lamp(2, 0.5, false));
            }),
        new Sight(
            "both-lights",
            Placement.at(0, 0.575, 0),
            e -> {
              e.light2IsOn = true;
              e.light2Color = new Color3f(1, 0.3f, 0.1f);
              e.light2SetPosition(2, 1.5, -1);
              e.add(box(e, 3, 0, 0));
              e.add(new Agent(new Vector3d(2, 0, 0.4), "green"));
            }),
        new Sight(
            "dark",
            Placement.at(0, 0.575, 0),
            e -> {
              e.light1IsOn = false;
              e.ambientLightColor = new Color3f(0.5f, 1, 0.2f);
              e.backgroundColor = e.darkgray;
              e.add(box(e, 3, 0, 0));
            }),
        new Sight(
            "near-clip",
            Placement.at(0, 0.3, 0),
            e -> {
              Box box = box(e, 0.015 + Math.sqrt(0.5), 0, 0);
              box.rotateY(Math.PI / 4);
              e.add(box);
            }),
        new Sight(
            "along-a-wall",
            Placement.at(-8, 0.575, 0),
            e -> {
              e.add(new Wall(new Vector3d(0, 0, 0.3), 18, 1, e));
              e.add(new Line(new Vector3d(-6, 0, -0.5), 2, e, new Color3f(0.7f, 0.4f, 0)));
            }),
        new Sight(
            "from-above",
            down(Placement.at(0, 4, 0)),
            e -> {
              e.add(box(e, 1, 0, 0));
              e.add(new Agent(new Vector3d(0, 0, 0.4), "green"));
            }));
  }

  private static Box box(EnvironmentDescription environment, double x, double y, double z) {
    return new Box(new Vector3d(x, y, z), new Vector3f(1, 1, 1), environment);
  }

  private static Agent lamp(double x, double z, boolean on) {
    Agent carrier = new Agent(new Vector3d(x, 0, z), "carrier");
    LampActuator lamp = RobotFactory.addLamp(carrier);
    lamp.setOn(on);
    return carrier;
  }

  private static Placement down(Placement eye) {
    eye.turnAboutZ(-1.2);
    return eye;
  }

  @ParameterizedTest
  @MethodSource("sights")
  void pictures_areTheSame(Sight sight) throws IOException {
    World world = sight.world();
    OffscreenCamera display = OffscreenCamera.open(world.getStage());
    try {
      Picture plain = take(new SoftwareCamera(world.getStage()), sight.worldFromEye);
      Picture java3d = take(display, sight.worldFromEye);
      write(sight.name, plain, java3d);
      checkSame(plain, java3d);
      assertEquals(plain.luminance(), java3d.luminance(), 0.002);
    } finally {
      display.dispose();
    }
  }

  private static Picture take(PictureSource source, Placement worldFromEye) {
    Picture picture = new Picture(SIDE_PX, SIDE_PX);
    source.take(worldFromEye, picture);
    return picture;
  }

  private static void checkSame(Picture plain, Picture java3d) {
    int off = 0;
    long sum = 0;
    for (int i = 0; i < SIDE_PX * SIDE_PX; i++) {
      int difference = difference(plain.argb()[i], java3d.argb()[i]);
      sum += difference;
      off += difference > SAME_LEVELS ? 1 : 0;
    }
    String measured = "pixels off: " + off + ", mean difference: " + sum / 1e4;
    assertTrue(off <= MOST_OFF && sum / 1e4 <= MOST_MEAN, measured);
  }

  private static int difference(int one, int other) {
    int most = 0;
    for (int shift = 0; shift < 24; shift += 8) {
      most = Math.max(most, Math.abs((one >> shift & 0xff) - (other >> shift & 0xff)));
    }
    return most;
  }

  /** Leaves both pictures side by side, for people to look at. */
  private static void write(String name, Picture left, Picture right) throws IOException {
    BufferedImage both = new BufferedImage(2 * SIDE_PX, SIDE_PX, BufferedImage.TYPE_INT_RGB);
    both.setRGB(0, 0, SIDE_PX, SIDE_PX, left.argb(), 0, SIDE_PX);
    both.setRGB(SIDE_PX, 0, SIDE_PX, SIDE_PX, right.argb(), 0, SIDE_PX);
    Files.createDirectories(OUT);
    ImageIO.write(both, "png", OUT.resolve(name + ".png").toFile());
  }

  /** What changes between two pictures is in the second one: moves, colours, lamps, comings. */
  @Test
  void pictures_followTheStageAtOnce() {
    EnvironmentDescription environment = new EnvironmentDescription();
    Agent robot = new Agent(new Vector3d(3, 0, 0), "robot");
    environment.add(robot);
    World world = new World(environment);
    new Simulator(null, world, environment);
    OffscreenCamera display = OffscreenCamera.open(world.getStage());
    SoftwareCamera plain = new SoftwareCamera(world.getStage());
    Placement eye = Placement.at(0, 0.575, 0);
    Runnable check = () -> checkSame(take(plain, eye), take(display, eye));
    for (int i = 0; i < 50; i++) {
      robot.translateTo(new Vector3d(-0.01, 0, 0.01));
      robot.rotateY(0.1);
      check.run();
    }
    robot.setColor(new Color3f(0.8f, 0.8f, 0));
    check.run();
    LampActuator lamp = RobotFactory.addLamp(robot);
    check.run();
    lamp.setOn(true);
    check.run();
    robot.detach();
    check.run();
    robot.attach();
    check.run();
    world.addObjectToPickableSceneBranch(box(environment, 3, 0, -0.5));
    check.run();
    display.dispose();
  }

  @Test
  void pictures_ofSeveralSizes_takeTurns() {
    Sight boxes = sights().skip(1).findFirst().orElseThrow();
    World world = boxes.world();
    OffscreenCamera display = OffscreenCamera.open(world.getStage());
    Picture large = new Picture(SIDE_PX, SIDE_PX);
    Picture wide = new Picture(60, 20);
    Placement eye = boxes.worldFromEye;
    display.take(eye, large);
    int[] first = large.argb().clone();
    display.take(eye, wide);
    assertFalse(Arrays.stream(wide.argb()).allMatch(p -> p == 0xff000000));
    large.clear();
    display.take(eye, large);
    assertArrayEquals(first, large.argb());
    display.dispose();
  }
}
