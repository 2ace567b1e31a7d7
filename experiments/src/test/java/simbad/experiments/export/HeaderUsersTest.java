package simbad.experiments.export;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.URL;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleType;
import simbad.sonar.frame.Placement;
import simbad.sonar.scene.SonarSpec;

/**
 * The programs of {@code export/} that use a header, compiled against stand-ins for the libraries
 * that they are meant for: their frames are turned as the simulator turns them.
 */
class HeaderUsersTest {
  private static final Path PROGRAMS = Path.of("..", "export");
  private static final SonarSpec SRF04 = Catalogue.srf04();
  private static final ObstacleType ANGLE = Catalogue.find("angle").orElseThrow();
  private static final int POSES = 500;

  /** Where the obstacle is: x, y to the left, yaw. */
  private static final double[] OBSTACLE = {1.5, -0.75, 0.6};

  /** Where the sensor is on the robot of ROS, in the same way. */
  private static final double[] MOUNT = {0.1, -0.05, 0.8};

  /** Floats, and the node's position before the header's. */
  private static final double TOLERANCE_M = 2e-4;

  @TempDir private Path folder = Path.of("");

  @BeforeEach
  void writesTheHeader() throws Exception {
    String header = new SonarHeader(ANGLE, SRF04, "sonar").text("test");
    Files.writeString(folder.resolve("sonar.h"), header);
  }

  @Test
  void nodeOfRosReadsWhatTheRuleReads() throws Exception {
    Compilers.need("g++");
    compile("g++", "-std=c++17", "ros2/sonar_node.cpp");
    List<double[]> robots = robots(3);
    String output =
        Compilers.run(
            folder,
            lines(robots, HeaderUsersTest::quaternion) + "nan 0 0 1\n",
            "./user",
            "obstacle_x",
            text(OBSTACLE[0]),
            "obstacle_y",
            text(OBSTACLE[1]),
            "obstacle_yaw",
            text(OBSTACLE[2]),
            "sensor_x",
            text(MOUNT[0]),
            "sensor_y",
            text(MOUNT[1]),
            "sensor_yaw",
            text(MOUNT[2]));
    List<String> published = output.lines().toList();

    assertEquals(POSES + 1, published.size());
    assertEquals("sonar 501 0 0.959931 0.030000 6.000000 nan", published.get(POSES));
    List<Double> read = published.stream().limit(POSES).map(HeaderUsersTest::range).toList();
    assertReadings(robots.stream().map(HeaderUsersTest::mounted).toList(), read);
  }

  /** The stand-in for Webots sends what the emitter got to the stream of errors. */
  @Test
  void controllerOfWebotsReadsWhatTheRuleReads() throws Exception {
    Compilers.need("gcc");
    compile("gcc", "-std=c99", "webots/sonar_controller.c", "webots/world.c");
    List<double[]> robots = robots(4);
    String output =
        Compilers.run(
            folder,
            lines(List.of(OBSTACLE), HeaderUsersTest::direction)
                + lines(robots, HeaderUsersTest::direction)
                + "nan 0 1 0\n",
            "./user");
    List<String> printed = output.lines().filter(line -> !line.startsWith("sent")).toList();
    List<Double> sent =
        output.lines().filter(line -> line.startsWith("sent")).map(HeaderUsersTest::range).toList();

    assertEquals("none", printed.get(POSES), "no number is no place");
    assertReadings(robots, sent.subList(0, POSES));
    for (int i = 0; i < POSES; i++) {
      double metres = sent.get(i);
      String line = metres < 0 ? "none" : String.format(Locale.ROOT, "%.4f", metres);
      assertEquals(line, printed.get(i));
    }
  }

  private void compile(String compiler, String standard, String program, String... more)
      throws Exception {
    URL stubs = HeaderUsersTest.class.getResource("stubs");
    Path standIns = Path.of(String.valueOf(stubs).replaceFirst("^file:", ""));
    List<String> command =
        new ArrayList<>(List.of(compiler, standard, "-Wall", "-Wextra", "-Werror", "-pedantic"));
    command.addAll(List.of("-I.", "-I" + standIns));
    command.add(PROGRAMS.resolve(program).toAbsolutePath().toString());
    for (String source : more) {
      command.add(standIns.resolve(source).toString());
    }
    command.addAll(List.of("-o", "user", "-lm"));
    Compilers.run(folder, "", command.toArray(String[]::new));
  }

  /** Round the obstacle, most of them looking about at it. */
  private static List<double[]> robots(long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    List<double[]> poses = new ArrayList<>();
    for (int i = 0; i < POSES; i++) {
      double bearing = random.nextDouble(-Math.PI, Math.PI);
      double away = random.nextDouble(0.2, 2);
      double yaw = bearing + Math.PI + random.nextDouble(-1.4, 1.4);
      poses.add(
          new double[] {
            OBSTACLE[0] + away * Math.cos(bearing), OBSTACLE[1] + away * Math.sin(bearing), yaw
          });
    }
    return poses;
  }

  private static double[] mounted(double[] robot) {
    double cos = Math.cos(robot[2]);
    double sin = Math.sin(robot[2]);
    return new double[] {
      robot[0] + cos * MOUNT[0] - sin * MOUNT[1],
      robot[1] + sin * MOUNT[0] + cos * MOUNT[1],
      robot[2] + MOUNT[2]
    };
  }

  /** The simulator's z points the other way than y. */
  private static void assertReadings(List<double[]> sensors, List<Double> read) {
    Placement placement = new Placement(OBSTACLE[0], -OBSTACLE[1], OBSTACLE[2]);
    RuleInMetres rule = new RuleInMetres(ANGLE, SRF04, placement);
    int echoes = 0;
    assertEquals(sensors.size(), read.size());
    for (int i = 0; i < sensors.size(); i++) {
      double[] sensor = sensors.get(i);
      double expected = rule.readM(sensor[0], -sensor[1], sensor[2]);
      boolean heard = read.get(i) >= 0 && read.get(i) < Double.POSITIVE_INFINITY;
      assertEquals(expected >= 0, heard, "pose " + i);
      if (heard) {
        echoes++;
        assertEquals(expected, read.get(i), TOLERANCE_M, "pose " + i);
      }
    }
    // A tenth at least is heard and a tenth is not, or nothing was shown.
    assertTrue(echoes > POSES / 10 && echoes < POSES * 9 / 10, "echoes " + echoes);
  }

  private static String lines(List<double[]> poses, Function<double[], String> line) {
    return poses.stream().map(line).collect(Collectors.joining("\n", "", "\n"));
  }

  private static String quaternion(double[] pose) {
    return place(pose) + text(Math.sin(pose[2] / 2)) + " " + text(Math.cos(pose[2] / 2));
  }

  private static String direction(double[] pose) {
    return place(pose) + text(Math.cos(pose[2])) + " " + text(Math.sin(pose[2]));
  }

  private static String place(double[] pose) {
    return text(pose[0]) + " " + text(pose[1]) + " ";
  }

  private static String text(double value) {
    return Double.toString(value);
  }

  /** The last word of a line. */
  private static double range(String line) {
    String word = line.substring(line.lastIndexOf(' ') + 1);
    return word.equals("inf") ? Double.POSITIVE_INFINITY : Double.parseDouble(word);
  }
}
