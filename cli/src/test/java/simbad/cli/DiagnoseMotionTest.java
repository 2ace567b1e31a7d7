package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.motion.Command;
import simbad.motion.MotionChain;
import simbad.motion.MotionRun;
import simbad.motion.Robot;
import simbad.motion.TrackPose;
import simbad.motion.format.MotionData;
import simbad.motion.format.MotionFolder;

/** The log of a robot whose ways are all 10 % shorter than it was told. */
class DiagnoseMotionTest {
  private static final double SHARE = 0.9;
  private static final double SIGMA_M = 0.001;
  private static final int STEPS = 1200;
  private static final double STEP_S = 0.1;

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  @BeforeEach
  void write() throws IOException {
    SplittableRandom random = new SplittableRandom(1);
    List<Command> commands = new ArrayList<>();
    List<TrackPose> track = new ArrayList<>();
    Command command = new Command(0, 0, 0);
    double x = 0;
    double y = 0;
    double heading = 0;
    for (int i = 0; i < STEPS; i++) {
      track.add(
          new TrackPose(
              i * STEP_S,
              x + SIGMA_M * random.nextGaussian(),
              y + SIGMA_M * random.nextGaussian(),
              Math.IEEEremainder(heading + SIGMA_M * random.nextGaussian(), 2 * Math.PI)));
      if (i % 20 == 0) {
        command =
            new Command(
                i * STEP_S, 0.1 + 0.2 * random.nextDouble(), 1.5 * random.nextDouble() - 0.75);
        commands.add(command);
      }
      // A step is a part of a circle; its chord has the direction of its middle.
      double turn = command.turnRadPerS() * STEP_S;
      double chord =
          SHARE * command.speedMPerS() * STEP_S * (turn == 0 ? 1 : Math.sin(turn / 2) / (turn / 2));
      x += chord * Math.cos(heading + turn / 2);
      y += chord * Math.sin(heading + turn / 2);
      heading += turn;
    }
    Robot robot = new Robot(false, 0, false, SIGMA_M, SIGMA_M, MotionChain.EXACT);
    MotionRun run = new MotionRun("a", commands, track);
    new MotionFolder(folder.resolve("short-ways"))
        .write(new MotionData("short-ways", robot, List.of(run), List.of()));
  }

  private Shell diagnose(String... options) {
    List<String> words =
        new ArrayList<>(
            List.of(
                "diagnose",
                folder.resolve("short-ways").toString(),
                "--out",
                folder.resolve("out").toString()));
    words.addAll(List.of(options));
    return Shell.simbad(words.toArray(String[]::new));
  }

  @Test
  void shortWays_areNamed_andTheirModelDrivesARobot() throws IOException {
    Shell shell = diagnose("--json");
    assertEquals(0, shell.status(), shell.err());
    JsonNode line = new ObjectMapper().readTree(shell.out());
    assertEquals("explained", line.get("verdict").asText(), shell.out());
    assertEquals("speed-scale", line.get("explanation").get(0).asText());
    assertEquals(1, line.get("explanation").size());
    assertTrue(line.get("shrink").asDouble() > 0.5, shell.out());
    Path out = Path.of(line.get("folder").asText());
    JsonNode form =
        new ObjectMapper().readTree(out.resolve("motion.json").toFile()).get("forms").get(0);
    assertEquals(SHARE, form.get("parameters").get("speed_factor").asDouble(), 0.005);
    Shell driven =
        Shell.simbad(
            "run",
            "round",
            "--sensor",
            "shadow",
            "--robot",
            "diagnosed:" + out,
            "--out",
            folder.resolve("driven").toString());
    assertEquals(0, driven.status(), driven.err());
    assertTrue(driven.out().contains("from moving alone"), driven.out());
  }

  @Test
  void theLine_saysVerdictAndEffect() {
    Shell shell = diagnose();
    assertEquals(0, shell.status(), shell.err());
    String line = shell.out().lines().findFirst().orElseThrow();
    assertTrue(line.startsWith("short-ways: explained; "), shell.out());
    assertTrue(line.contains("speed-scale"), shell.out());
  }

  @ParameterizedTest
  @ValueSource(strings = {"--audit-only", "--corrected=scene.json"})
  void whatAMotionFolderHasNot_isSaid(String option) {
    Shell shell = diagnose(option);
    assertEquals(2, shell.status());
    assertTrue(shell.err().contains("short-ways is a motion folder, which has no"), shell.err());
    assertFalse(Files.exists(folder.resolve("out/short-ways")));
  }
}
