package simbad.blindworld.motion;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import simbad.blindworld.world.Pose;

/** Runs, their frames at half seconds, and the windows between those. */
class OutingTest {

  private static final Pose START = new Pose(1, 2, 0.5);
  private static final Commands NONE = commands();

  private static Commands commands(double... timesS) {
    return new Commands(timesS, new double[timesS.length], new double[timesS.length]);
  }

  private static Outing.Run run(String name, Commands commands, double endS, double... framesS) {
    return new Outing.Run(name, commands, framesS, endS, START);
  }

  private static double[] frames(Outing.Run run) {
    return IntStream.range(0, run.frames()).mapToDouble(run::frameS).toArray();
  }

  @Test
  void run_beginsWithTheFirstCommandOrFrame() {
    assertEquals(0.2, run("a", commands(0.2, 1), 9, 0.3).beginS());
    assertEquals(0.1, run("a", commands(0.2, 1), 9, 0.1).beginS());
    assertEquals(0.7, run("a", NONE, 9, 0.7, 0.8).beginS());
    assertEquals(0, run("a", commands(2), 9).beginS());
    assertEquals(-2, run("a", commands(-2), 9).beginS());
  }

  @Test
  void run_saysWhatItIs() {
    Commands commands = commands(0);
    double[] times = {0, 1};
    Outing.Run run = new Outing.Run("a", commands, times, 9, START);
    times[1] = 5;
    assertEquals("a", run.name());
    assertSame(commands, run.commands());
    assertEquals(9, run.endS());
    assertEquals(START, run.start());
    assertArrayEquals(new double[] {0, 1}, frames(run));
  }

  /** From 0.5 to 3 s and from 0 to 4 s. */
  @Test
  void duration_isThatOfAllRuns() {
    assertEquals(
        6.5, new Outing(List.of(run("a", NONE, 3, 0.5), run("b", NONE, 4, 0))).durationS());
  }

  /** Within a fiftieth of a second of a half second, before it and after it. */
  @Test
  void atBeats_keepsFramesNearHalfSeconds() {
    Outing.Run run =
        run("a", commands(0), 2, 0, 0.02, 0.03, 0.25, 0.47, 0.48, 0.5, 0.53, 0.98, 1.021, 1.5);
    Outing.Run thin = new Outing(List.of(run)).atBeats().runs().get(0);
    assertArrayEquals(new double[] {0, 0.02, 0.48, 0.5, 0.98, 1.5}, frames(thin));
    assertEquals("a", thin.name());
    assertEquals(2, thin.endS());
    assertEquals(START, thin.start());
    assertSame(run.commands(), thin.commands());
  }

  private static List<Windows.Window> windows(Outing.Run... runs) {
    Windows windows = Windows.of(new Outing(List.of(runs)));
    return IntStream.range(0, windows.size()).mapToObj(windows::at).toList();
  }

  /** The three horizons are 0.5, 2 and 5 s, with the indices 0 to 2. */
  @Test
  void windows_areInTheOrderOfRunsTimesAndHorizons() {
    List<Windows.Window> expected =
        List.of(
            new Windows.Window(0, 0.5, 1, 0, 1),
            new Windows.Window(0, 0.5, 2, 0, 2),
            new Windows.Window(1, 0, 0, 0, 1),
            new Windows.Window(1, 0, 1, 0, 2));
    assertEquals(
        expected,
        windows(run("a", NONE, 6, 0.5, 2.5, 5.5), run("b", NONE, 3, 0, 0.5, 2), run("c", NONE, 1)));
    Windows windows = Windows.of(new Outing(List.of(run("a", NONE, 1), run("b", NONE, 1, 0, 0.5))));
    assertEquals("b", windows.run(0));
    assertEquals(0.5, windows.at(0).horizonS());
  }

  /** Of two frames near a moment the nearer one counts, on either side of it. */
  @Test
  void window_takesTheNearestFrame() {
    assertEquals(
        List.of(new Windows.Window(0, 0, 0, 0, 2)), windows(run("a", NONE, 1, 0, 0.485, 0.505)));
    assertEquals(
        List.of(new Windows.Window(0, 0, 0, 0, 1)), windows(run("a", NONE, 1, 0, 0.495, 0.515)));
    assertEquals(
        List.of(new Windows.Window(0, 0.5, 0, 1, 2)),
        windows(run("a", NONE, 2, 0.48, 0.51, 1.02)),
        "a run that begins a little late or ends a little late");
  }

  @Test
  void frameThatIsTooFar_endsNoWindow() {
    assertEquals(List.of(), windows(run("a", NONE, 1, 0, 0.522)));
    assertEquals(List.of(), windows(run("a", NONE, 1, 0.03, 0.5)));
    assertEquals(1, windows(run("a", NONE, 1, 0.02, 0.48)).size());
  }

  /** 3 m to the right and 4 m down the page, as seen by one that looks along a third direction. */
  @Test
  void displacement_isInTheFrameOfItsBeginning() {
    Windows windows = Windows.of(new Outing(List.of(run("a", NONE, 1, 0, 0.5))));
    double h = 0.4;
    Track track = Track.of(List.<double[][]>of(new double[][] {{1, 4}, {2, 6}, {h, 0.7}}));
    double[] moved = windows.displacements(track)[0];
    assertEquals(3 * Math.cos(h) - 4 * Math.sin(h), moved[0], 1e-12);
    assertEquals(-3 * Math.sin(h) - 4 * Math.cos(h), moved[1], 1e-12);
    assertEquals(Math.toDegrees(0.3), moved[2], 1e-12);
  }

  /** A heading that jumps by whole turns goes on from the frame before. */
  @Test
  void track_isACopyByRuns_unwrapped() {
    double[][] first = {{1, 2, 3}, {4, 5, 6}, {6, 0.1, -6}};
    Track track = Track.of(List.of(first, new double[][] {{7}, {8}, {-3}}));
    first[0][1] = 99;
    assertEquals(2, track.size());
    assertEquals(2, track.xM(0, 1));
    assertEquals(6, track.zM(0, 2));
    assertEquals(8, track.zM(1, 0));
    assertEquals(-3, track.headingRad(1, 0));
    assertEquals(6, track.headingRad(0, 0));
    assertEquals(0.1 + 2 * Math.PI, track.headingRad(0, 1), 1e-12);
    assertEquals(-6 + 4 * Math.PI, track.headingRad(0, 2), 1e-12);
    assertEquals(6, first[2][0]);
    assertEquals(0.1, first[2][1]);
  }
}
