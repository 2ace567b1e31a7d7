package simbad.experiments.export;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleType;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Pose;
import simbad.sonar.model.DetectionRule;
import simbad.sonar.model.LevelModel;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.scene.TableDetection;
import simbad.sonar.sensing.Readings;
import simbad.sonar.sensing.Sensor;
import simbad.sonar.sensing.TransducerPoses;

/** The level model as a header, compiled and run, beside the model itself. */
class LevelHeaderTest {
  private static final SonarSpec SRF04 = Catalogue.srf04();

  private static final String READ_ALL =
      """
      #include <stdio.h>
      #include "sonar.h"
      int main(void) {
        int x, z;
        long h;
        while (scanf("%d %d %ld", &x, &z, &h) == 3) {
          sonar_pose at;
          at.x_mm = (int16_t)x;
          at.z_mm = (int16_t)z;
          at.heading_cdeg = (int16_t)h;
          printf("%d %.6f\\n", sonar_read(at),
              (double)sonar_read_m((float)x / 1000, (float)z / 1000, (float)((double)h * 1.7453292519943e-4)));
        }
        return 0;
      }
      """;

  @TempDir private Path folder = Path.of("");

  private static Scene scene(ObstacleType type) {
    return new Scene(
        List.of(
            new Obstacle(
                "post",
                Placement.IDENTITY,
                type.outline(),
                new TableDetection(type.thresholds().table()))));
  }

  private List<String> read(LevelHeader header, String compiler, List<int[]> poses)
      throws Exception {
    Files.writeString(folder.resolve("sonar.h"), header.text("test"));
    Files.writeString(folder.resolve("main.c"), READ_ALL);
    String trap = compiler.equals("clang") ? "-fsanitize-trap=undefined" : "-fno-sanitize-recover";
    Compilers.run(
        folder,
        "",
        (compiler
                + " -std=c99 -O2 -Wall -Wextra -Wconversion -Werror -pedantic -fsanitize=undefined "
                + trap
                + " main.c -o main -lm")
            .split(" ", -1));
    String input =
        poses.stream()
            .map(p -> p[0] + " " + p[1] + " " + p[2])
            .collect(Collectors.joining("\n", "", "\n"));
    return Compilers.run(folder, input, "./main").lines().toList();
  }

  /** What the model reads, metres; below 0 for no echo. */
  private static double[] expected(ObstacleType type, List<int[]> poses) {
    Sensor sensor = DetectionRule.LEVEL.bind(SRF04, scene(type), new SplittableRandom(1));
    TransducerPoses at = new TransducerPoses(1);
    Readings readings = new Readings(1);
    return poses.stream()
        .mapToDouble(
            pose -> {
              double heading = Math.toRadians(pose[2] / 100.0);
              at.setPosition(0, pose[0] / 1000.0, 0.15, pose[1] / 1000.0);
              at.setDirection(0, Math.cos(heading), 0, -Math.sin(heading));
              sensor.ping(at, 0, readings);
              return readings.isEcho(0) ? readings.rangeM(0) : -1;
            })
        .toArray();
  }

  /** By how many decibels the model's echo exceeds the threshold. */
  private static double excessDb(LevelModel model, int[] pose) {
    double heading = Math.toRadians(pose[2] / 100.0);
    return model.sight(0, Pose.of(pose[0] / 1000.0, pose[1] / 1000.0, heading)).excessDb();
  }

  @ParameterizedTest
  @CsvSource({"gcc, angle", "clang, angle", "gcc, square", "clang, round"})
  void readsWhatTheModelReads(String compiler, String name) throws Exception {
    Compilers.need(compiler);
    ObstacleType type = Catalogue.find(name).orElseThrow();
    LevelHeader header = new LevelHeader(type, SRF04, "sonar");
    List<int[]> poses = HeaderPoses.all(2.9, 11);
    List<String> lines = read(header, compiler, poses);
    IntegerLevel whole = header.inIntegers();
    double[] expected = expected(type, poses);
    LevelModel model = new LevelModel(SRF04, scene(type));
    int echoes = 0;
    for (int i = 0; i < lines.size(); i++) {
      String[] read = lines.get(i).split(" ", -1);
      int[] pose = poses.get(i);
      String where = Arrays.toString(pose);
      int mm = Integer.parseInt(read[0]);
      assertEquals(whole.readMm(pose[0], pose[1], pose[2]), mm, where);
      check(model, pose, expected[i], Double.parseDouble(read[1]), 0.05, 1e-4);
      // Whole numbers have the strength in steps of a degree, and it can be steep.
      check(model, pose, expected[i], mm < 0 ? -1 : mm / 1000.0, 1.5, 3e-3);
      echoes += expected[i] >= 0 ? 1 : 0;
    }
    assertEquals(39_366, lines.size());
    assertTrue(echoes > 250, echoes + " echoes");
  }

  /** The same echo but where its excess is nearly 0; the same range. */
  private static void check(
      LevelModel model, int[] pose, double expected, double read, double nearlyDb, double withinM) {
    String where = Arrays.toString(pose) + " expected " + expected + ", read " + read;
    if (expected >= 0 == read >= 0) {
      assertEquals(expected, read, expected < 0 ? 0 : withinM, where);
    } else {
      double excess = excessDb(model, pose);
      assertTrue(Math.abs(excess) < nearlyDb, where + ", excess " + excess + " dB");
    }
  }

  @Test
  void angles_areThoseOfTheCircle() {
    for (int degrees = 0; degrees < 360; degrees += 7) {
      int x = (int) Math.rint(9000 * Math.cos(Math.toRadians(degrees)));
      int y = (int) Math.rint(9000 * Math.sin(Math.toRadians(degrees)));
      double exact = Math.atan2(y, x) / (2 * Math.PI) * 65_536;
      double off = IntegerLevel.angleOf(x, y) - exact;
      assertEquals(0, off - 65_536 * Math.rint(off / 65_536), 6, degrees + " degrees");
    }
    assertEquals(0, IntegerLevel.angleOf(0, 0));
  }

  /** In whole numbers, without floats: the same sum of readings as in Java. */
  @Test
  void readsTheSameOnAnAtmega() throws Exception {
    Compilers.need("avr-gcc");
    Compilers.need("simavr");
    LevelHeader header = new LevelHeader(Catalogue.find("angle").orElseThrow(), SRF04, "sonar");
    Files.writeString(folder.resolve("sonar.h"), header.text("test"));
    IntegerLevel whole = header.inIntegers();
    String said = OnAChip.run(folder, "sonar");
    assertTrue(said.contains(OnAChip.sum(whole::readMm)), said);
  }

  @Test
  void whatDoesNotFit_isRefused() {
    ObstacleType type = Catalogue.find("angle").orElseThrow();
    assertThrows(
        IllegalArgumentException.class,
        () -> new LevelHeader(type, SRF04.withRange(0.03, 20), "sonar"));
    assertThrows(IllegalArgumentException.class, () -> new LevelHeader(type, SRF04, "1"));
  }
}
