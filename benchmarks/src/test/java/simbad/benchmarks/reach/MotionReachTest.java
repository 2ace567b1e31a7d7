package simbad.benchmarks.reach;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import simbad.motion.Command;
import simbad.motion.MotionRun;
import simbad.motion.Robot;
import simbad.motion.TrackPose;
import simbad.motion.forecast.Window;
import simbad.motion.forecast.Windows;
import simbad.motion.format.MotionData;

/** A robot that acts 0.2 s late and goes nine tenths of its way. */
class MotionReachTest {
  private static final double LATE_S = 0.2;
  private static final double SHARE = 0.9;
  private static final double STEP_S = 0.01;
  private static final int STEPS = 16_000;

  private static MotionRun drive() {
    SplittableRandom random = new SplittableRandom(3);
    List<Command> commands = new ArrayList<>();
    for (double t = 0; t < STEPS * STEP_S; t += 0.8 + random.nextDouble()) {
      commands.add(new Command(t, 0.05 + 0.2 * random.nextDouble(), random.nextDouble() - 0.5));
    }
    List<TrackPose> track = new ArrayList<>();
    double x = 0;
    double y = 0;
    double heading = 0;
    int at = -1;
    for (int i = 0; i < STEPS; i++) {
      double t = i * STEP_S;
      if (i % 5 == 0) {
        double scatter = 0.0005;
        track.add(
            new TrackPose(
                t,
                x + scatter * random.nextGaussian(),
                y + scatter * random.nextGaussian(),
                heading + scatter * random.nextGaussian()));
      }
      while (at + 1 < commands.size() && commands.get(at + 1).timeS() + LATE_S <= t + 1e-9) {
        at++;
      }
      double v = at < 0 ? 0 : SHARE * commands.get(at).speedMPerS();
      double w = at < 0 ? 0 : commands.get(at).turnRadPerS();
      x += v * STEP_S * Math.cos(heading + w * STEP_S / 2);
      y += v * STEP_S * Math.sin(heading + w * STEP_S / 2);
      heading += w * STEP_S;
    }
    return new MotionRun("a", commands, track);
  }

  /** Two tenths late and nine tenths of it is a weighted sum: what is left is the tracker's. */
  @Test
  void theFilter_followsWhatIsLateAndShort() {
    MotionRun run = drive();
    List<Window> windows = Windows.of(List.of(run), 0.5);
    LinearFilter filter = LinearFilter.fitted(run, windows.subList(0, 150), 0);
    double off = 0;
    double size = 0;
    for (Window window : windows.subList(150, windows.size())) {
      off += Math.abs(filter.off(window));
      size += Math.abs(window.way().alongM());
    }
    assertTrue(off < 0.02 * size, off + " of " + size);
  }

  @Test
  void theReport_saysNamesAndShares_ofBothHalves() {
    ByteArrayOutputStream text = new ByteArrayOutputStream();
    Robot robot = new Robot(false, 0, false, 0.0005, 0.0005, Robot.EXACT_UNICYCLE.motion());
    new MotionReach(new PrintStream(text, true, StandardCharsets.UTF_8))
        .report(new MotionData("own", robot, List.of(drive()), List.of()));
    String report = text.toString(StandardCharsets.UTF_8);
    for (String half : List.of("first half", "second half")) {
      assertTrue(report.contains("own, fitted on the " + half + ": explained"), report);
    }
    assertEquals(2, report.split("latency_s 0\\.(20|19)", -1).length - 1);
    assertEquals(2, report.split("speed_factor 0\\.(90|89)", -1).length - 1, report);
    assertTrue(report.contains("within 90 % forecasts:"), report);
  }
}
