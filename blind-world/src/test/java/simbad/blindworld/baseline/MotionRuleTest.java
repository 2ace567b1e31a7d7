package simbad.blindworld.baseline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simbad.blindworld.file.Csv;
import simbad.blindworld.file.FormatException;
import simbad.blindworld.file.JsonObject;
import simbad.blindworld.motion.Commands;
import simbad.blindworld.motion.MotionChange;
import simbad.blindworld.motion.MotionChange.Stage;
import simbad.blindworld.motion.MotionWorld;
import simbad.blindworld.motion.Outing;
import simbad.blindworld.motion.Robot;
import simbad.blindworld.motion.Step;
import simbad.blindworld.motion.Track;
import simbad.blindworld.world.Chance;
import simbad.blindworld.world.Pose;

/** A rule that names one effect of motion by the line that fits best. */
class MotionRuleTest {

  private static final double LOG_S = 60;
  private static final Robot.Scatter TRACKER = new Robot.Scatter(0.002, 0.002);
  private static final Robot ROBOT = new Robot(0, 1, false, Robot.Beliefs.NONE, TRACKER, false);

  private static Outing outing() {
    Chance random = new Chance(4);
    double[] times = IntStream.range(0, 30).mapToDouble(i -> 2 * i).toArray();
    double[] v = random.doubles(30, 0.05, 0.5).toArray();
    double[] w = random.doubles(30, -0.8, 0.8).toArray();
    double[] frames = IntStream.rangeClosed(0, 120).mapToDouble(i -> i / 2.0).toArray();
    Commands commands = new Commands(times, v, w);
    return new Outing(List.of(new Outing.Run("r", commands, frames, LOG_S, new Pose(0, 0, 0))));
  }

  /** Writes a log of a robot that is changed. */
  private static void write(Path folder, Consumer<Step> change) throws IOException {
    Files.createDirectories(folder);
    Files.writeString(
        folder.resolve("robot.json"),
        String.format(
            Locale.ROOT,
            "{\"kinematics\": \"unicycle\", \"track_sigma_m\": 0.002, \"track_sigma_deg\": %s}",
            Math.toDegrees(0.002)));
    Outing outing = outing();
    MotionWorld world =
        new MotionWorld(
            ROBOT,
            new MotionWorld.Seeing(TRACKER, 0),
            List.of(MotionChange.steps(Stage.WHEEL, change)));
    Track track = world.drive(outing, 7);
    StringBuilder commands = new StringBuilder("run,t_s,v_m_s,w_rad_s\n");
    Commands told = outing.runs().get(0).commands();
    for (int i = 0; i < told.size(); i++) {
      commands.append(
          "r,%s,%s,%s\n".formatted(told.timeS(i), told.at(i).vMPerS(), told.at(i).wRadPerS()));
    }
    Files.writeString(folder.resolve("commands.csv"), commands);
    StringBuilder poses = new StringBuilder("run,t_s,x_m,z_m,heading_deg\n");
    for (int i = 0; i <= 120; i++) {
      poses.append(
          "r,%s,%s,%s,%s\n"
              .formatted(
                  i / 2.0, track.xM(0, i), track.zM(0, i), Math.toDegrees(track.headingRad(0, i))));
    }
    Files.writeString(folder.resolve("track.csv"), poses);
  }

  private static Optional<String> name(Path folder, Consumer<Step> change)
      throws IOException, FormatException {
    write(folder, change);
    return new MotionRule(folder).name(folder);
  }

  @Test
  void lineThatFits_hasItsName(@TempDir Path folder) throws IOException, FormatException {
    assertEquals(Optional.empty(), name(folder, step -> {}));
    assertEquals(Optional.of("speed-scale"), name(folder, step -> step.scale(1.1, 1)));
    assertEquals(Optional.of("speed-scale"), name(folder, step -> step.scale(0.9, 1)));
    assertEquals(Optional.of("turn-scale"), name(folder, step -> step.scale(1, 1.1)));
    assertEquals(Optional.of("turn-bias"), name(folder, step -> step.addTurn(0.03)));
    assertEquals(Optional.of("turn-bias"), name(folder, step -> step.addTurn(-0.03)));
    Chance random = new Chance(2);
    assertEquals(
        Optional.of("motion-noise"),
        name(
            folder,
            step -> {
              step.scale(1 + 1.5 * random.nextGaussian(), 1);
              step.addTurn(2 * random.nextGaussian());
            }));
  }

  /** The middle of what is predicted of the first half second is the arc that is told. */
  @Test
  void predictions_areTheNominalRobots(@TempDir Path folder) throws IOException, FormatException {
    write(folder, step -> step.scale(2, 2));
    Csv csv = Csv.parse("p", new MotionRule(folder).predictions(folder));
    assertEquals(120 + 117 + 111, csv.size());
    Commands.Speeds told = outing().runs().get(0).commands().at(0);
    assertEquals("0.5", csv.text(0, csv.column("horizon_s")));
    assertEquals(0.5 * told.vMPerS(), csv.number(0, csv.column("along_m_q50")), 0.005);
    assertEquals(
        Math.toDegrees(0.5 * told.wRadPerS()), csv.number(0, csv.column("turn_deg_q50")), 0.2);
  }

  @Test
  void logs_areAnswered(@TempDir Path folder) throws IOException, FormatException {
    write(folder.resolve("cases/a"), step -> {});
    write(folder.resolve("cases/b"), step -> step.scale(1.1, 1));
    write(folder.resolve("rows/b"), step -> {});
    Path out = folder.resolve("out");
    assertEquals(List.of(), Baseline.run(folder.resolve("cases"), folder.resolve("rows"), out));
    JsonObject a = JsonObject.read(out.resolve("a/diagnosis.json"));
    assertEquals("none", a.text("verdict"));
    assertEquals("slip", a.objects("effects").get(0).text("name"));
    JsonObject b = JsonObject.read(out.resolve("b/diagnosis.json"));
    assertEquals(List.of("speed-scale"), b.texts("explanation"));
    assertTrue(Files.exists(out.resolve("b/predictions.csv")));
    assertTrue(Files.notExists(out.resolve("a/predictions.csv")));
  }
}
