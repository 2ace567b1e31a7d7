package simbad.experiments.export;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleType;
import simbad.sonar.scene.SonarSpec;

/** The header, compiled by real compilers and run, beside the same rule in Java. */
class HeaderInCTest {
  private static final SonarSpec SRF04 = Catalogue.srf04();
  private static final double REACH_M = 2.9;

  /** What differs where so little decides is rounding. */
  private static final double EDGE_M = 1e-4;

  private static final String READ_ALL =
      """
      #include <stdio.h>
      #include "sonar.h"
      int main(void) {
        int x, z;
        long h;
        while (scanf("%d %d %ld", &x, &z, &h) == 3) {
          post_pose at;
          at.x_mm = (int16_t)x;
          at.z_mm = (int16_t)z;
          at.heading_cdeg = (int16_t)h;
          printf("%d %.6f\\n", post_read(at),
              (double)post_read_m((float)x / 1000, (float)z / 1000, (float)((double)h * 1.7453292519943e-4)));
        }
        return 0;
      }
      """;

  @TempDir private Path folder = Path.of("");

  private SonarHeader write(ObstacleType type) throws Exception {
    SonarHeader header = new SonarHeader(type, SRF04, "post");
    Files.writeString(folder.resolve("sonar.h"), header.text("test"));
    return header;
  }

  private static ObstacleType type(String name) {
    return Catalogue.find(name).orElseThrow();
  }

  @ParameterizedTest
  @CsvSource({"gcc, angle", "clang, angle", "gcc, square", "clang, round"})
  void readsWhatJavaReads(String compiler, String name) throws Exception {
    Compilers.need(compiler);
    ObstacleType type = type(name);
    IntegerSonar sonar = write(type).inIntegers();
    Files.writeString(folder.resolve("main.c"), READ_ALL);
    Compilers.run(
        folder,
        "",
        compiler,
        "-std=c99",
        "-O2",
        "-Wall",
        "-Wextra",
        "-Wconversion",
        "-Werror",
        "-pedantic",
        "-fsanitize=undefined",
        // Of clang a trap: its library for messages is a package that Debian only recommends.
        compiler.equals("clang") ? "-fsanitize-trap=undefined" : "-fno-sanitize-recover",
        "main.c",
        "-o",
        "main",
        "-lm");
    List<int[]> poses = HeaderPoses.all(REACH_M, 11);
    String input =
        poses.stream()
            .map(p -> p[0] + " " + p[1] + " " + p[2])
            .collect(Collectors.joining("\n", "", "\n"));
    List<String> lines = Compilers.run(folder, input, "./main").lines().toList();

    assertEquals(39_366, lines.size());
    RuleInMetres rule = new RuleInMetres(type, SRF04);
    for (int i = 0; i < lines.size(); i++) {
      String[] read = lines.get(i).split(" ", -1);
      int[] pose = poses.get(i);
      String where = Arrays.toString(pose);
      assertEquals(sonar.readMm(pose[0], pose[1], pose[2]), Integer.parseInt(read[0]), where);
      assertFloat(rule, pose, Double.parseDouble(read[1]));
    }
  }

  private static void assertFloat(RuleInMetres rule, int[] pose, double read) {
    double expected = rule.readM(pose);
    if (expected >= 0 == read >= 0) {
      assertEquals(expected, read, expected < 0 ? 0 : EDGE_M, Arrays.toString(pose));
    } else {
      assertTrue(isAtAnEdge(rule, pose, expected >= 0), Arrays.toString(pose));
    }
  }

  private static boolean isAtAnEdge(RuleInMetres rule, int[] pose, boolean heard) {
    double heading = Math.toRadians(pose[2] / 100.0);
    return IntStream.range(0, 16)
        .mapToDouble(i -> i * Math.PI / 8)
        .anyMatch(
            a ->
                rule.readM(
                            pose[0] / 1000.0 + EDGE_M * Math.cos(a),
                            pose[1] / 1000.0 + EDGE_M * Math.sin(a),
                            heading)
                        >= 0
                    != heard);
  }

  @Test
  void readsTheSameOnAnAtmega() throws Exception {
    Compilers.need("avr-gcc");
    Compilers.need("simavr");
    IntegerSonar sonar = write(type("angle")).inIntegers();
    String said = OnAChip.run(folder, "post");
    assertTrue(said.contains(OnAChip.sum(sonar::readMm)), said);
  }

  /** Code, table, corners and sines: the difference to a program without them. */
  @Test
  void takesLittleFlash() throws Exception {
    Compilers.need("avr-gcc");
    write(type("angle"));
    String read =
        "#define POST_INTEGER_ONLY\n#include \"sonar.h\"\n"
            + "volatile post_pose at;\nvolatile int16_t mm;\n"
            + "int main(void) { post_pose own = {at.x_mm, at.z_mm, at.heading_cdeg};"
            + " mm = READ; return 0; }\n";
    int with = flash(read.replace("READ", "post_read(own)"));
    int without = flash(read.replace("READ", "own.x_mm"));

    assertTrue(with - without <= 2048, with - without + " bytes");
  }

  private int flash(String source) throws Exception {
    Files.writeString(folder.resolve("size.c"), source);
    Compilers.run(
        folder, "", "avr-gcc", "-std=c99", "-Os", "-mmcu=atmega328p", "size.c", "-o", "size.elf");
    String last =
        Compilers.run(folder, "", "avr-size", "size.elf").lines().skip(1).findFirst().orElseThrow();
    String[] sizes = last.trim().split("\\s+", -1);
    return Integer.parseInt(sizes[0]) + Integer.parseInt(sizes[1]);
  }
}
