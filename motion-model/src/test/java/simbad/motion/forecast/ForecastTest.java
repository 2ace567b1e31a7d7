package simbad.motion.forecast;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.motion.Command;
import simbad.motion.CommandUse;
import simbad.motion.MotionChain;
import simbad.motion.MotionRun;
import simbad.motion.Robot;
import simbad.motion.TrackPose;

/** Windows, what is asked in them, and how far a forecast may be off, in closed form. */
class ForecastTest {
  private static final double SPEED = 0.2;

  /** Straight along x at 0.2 m/s for 6 s, seen every 20 ms but between two times. */
  private static MotionRun straight(double holeFromS, double holeToS) {
    List<TrackPose> track = new ArrayList<>();
    for (int i = 0; i <= 300; i++) {
      double time = 0.02 * i;
      if (time <= holeFromS || time >= holeToS) {
        track.add(new TrackPose(time, SPEED * time, 0, 0));
      }
    }
    return new MotionRun("a", List.of(new Command(0, SPEED, 0)), track);
  }

  @Test
  void windows_beginAtEveryHalfSecond() {
    List<Window> windows = Windows.of(List.of(straight(9, 9)), 2);
    assertEquals(9, windows.size(), "from 0 s to 4 s");
    Window last = windows.get(8);
    assertEquals(4, last.startS());
    assertEquals(6, last.endS());
    assertEquals(2 * SPEED, last.way().alongM(), 1e-9);
    assertEquals(0, last.way().acrossM(), 1e-9);
  }

  /** From 1.9 s to 3.1 s nobody looked: no window of half a second ends or begins there. */
  @Test
  void windows_needTheTrackAtBothEnds() {
    List<Double> starts =
        Windows.of(List.of(straight(1.9, 3.1)), 0.5).stream().map(Window::startS).toList();
    assertEquals(List.of(0.0, 0.5, 1.0, 3.5, 4.0, 4.5, 5.0, 5.5), starts);
    MotionRun unseen = new MotionRun("b", List.of(new Command(0, SPEED, 0)), List.of());
    assertEquals(List.of(), Windows.of(List.of(unseen), 0.5));
  }

  /** A frame 15 ms from the half second is near enough where nothing stands on its other side. */
  @Test
  void windows_takeAFrameThatIsNear() {
    List<Command> commands = List.of(new Command(0, SPEED, 0));
    assertEquals(1, Windows.of(List.of(new MotionRun("a", commands, pair(0.015))), 0.5).size());
    assertEquals(0, Windows.of(List.of(new MotionRun("a", commands, pair(0.03))), 0.5).size());
  }

  private static List<TrackPose> pair(double lateS) {
    return List.of(new TrackPose(lateS, 0, 0, 0), new TrackPose(0.5 + lateS, 0.1, 0, 0));
  }

  /** 0.2 m/s for a second; a change of 0.2 m/s counts as the way of 0.3 s. */
  @Test
  void exertion_isWayAndChange() {
    MotionRun run =
        new MotionRun("a", List.of(new Command(0, SPEED, 0), new Command(3, SPEED, 1)), List.of());
    Exertion asked = Exertion.of(run);
    assertEquals(0.2, asked.between(1, 2), 1e-12);
    assertEquals(0.2 + 0.3 * 0.2, asked.between(0, 1), 1e-12, "it starts");
    assertEquals(0.2 + 0.5 * 0.1 + 0.3 * 0.1, asked.between(2.5, 3.5), 1e-12, "it turns from 3 s");
    assertEquals(0, asked.between(-3, -2), "before the first command");
  }

  @Test
  void score_isTwiceTheMeanPinballLoss() {
    double[] sure = new double[PinballLoss.QUANTILES];
    // Levels 0.05 to 0.95 are 0.5 in the mean.
    assertEquals(1, PinballLoss.crps(sure, 1), 1e-12);
    assertEquals(1, PinballLoss.crps(sure, -1), 1e-12);
    assertEquals(0, PinballLoss.crps(sure, 0));
  }

  /** Of 0 to 98 the quantile at level p is 100 p - 1. */
  @Test
  void quantiles_areThoseOfANextValue() {
    double[] values = new double[99];
    for (int i = 0; i < values.length; i++) {
      values[i] = values.length - 1 - i;
    }
    double[] quantiles = Spread.quantiles(values);
    assertEquals(4, quantiles[0], 1e-9);
    assertEquals(49, quantiles[9], 1e-9);
    assertEquals(94, quantiles[18], 1e-9);
    assertArrayEquals(new double[PinballLoss.QUANTILES], Spread.quantiles(new double[0]));
  }

  /** Two classes: what stands is exact, what is asked much is off by 1 to 60. */
  @Test
  void spread_isLearntByExertion() {
    double[] exertions = new double[120];
    double[][] residuals = new double[120][3];
    for (int i = 60; i < exertions.length; i++) {
      exertions[i] = 1 + i;
      residuals[i] = new double[] {i - 59, 0, -1};
    }
    Spread spread = Spread.of(exertions, residuals);
    assertEquals(2, spread.quantiles().length);
    assertEquals(0, spread.at(0, 0)[18]);
    assertEquals(30.5, spread.at(100, 0)[9], 1e-9);
    assertEquals(-1, spread.at(100, 2)[0]);
    assertThrows(
        IllegalArgumentException.class, () -> new Spread(new double[2], new double[1][3][19]));
  }

  /** A tracker of 2 mm at both ends: 1.645 times root 2 times 2 mm at the ends of 90 %. */
  @Test
  void believed_scattersByItsTrackerAlone() {
    Robot robot = new Robot(false, 0, false, 0.002, 0.01, MotionChain.EXACT);
    List<MotionForecast.Row> rows = MotionForecast.believed(robot).of(List.of(straight(9, 9)));
    MotionForecast.Row first = rows.get(0);
    assertEquals(0.5, first.horizonS());
    assertEquals(SPEED * 0.5, first.quantiles()[0][9], 1e-9);
    double half = first.quantiles()[0][18] - first.quantiles()[0][9];
    assertEquals(1.6448536 * Math.sqrt(2) * 0.002, half, 1e-9);
    assertEquals(half, first.quantiles()[0][9] - first.quantiles()[0][0], 1e-12);
    assertEquals(5 * half, first.quantiles()[2][18], 1e-9, "0.01 rad");
    for (int i = 1; i < rows.size(); i++) {
      double before = 100 * rows.get(i - 1).startS() + rows.get(i - 1).horizonS();
      assertTrue(before < 100 * rows.get(i).startS() + rows.get(i).horizonS());
    }
  }

  @Test
  void commandUse_knowsSizes() {
    MotionRun run =
        new MotionRun(
            "a",
            List.of(new Command(0, 0.1, 0), new Command(1, -0.1, 1), new Command(2, 0.3, 1)),
            List.of());
    CommandUse use = CommandUse.of(List.of(run), 0.2);
    assertArrayEquals(new double[] {0.1, 0.3}, use.speeds(), 1e-12);
    assertArrayEquals(new double[] {1}, use.turns(), 1e-12);
    // Left and right rims: 0.1, 0.1; -0.2, 0; 0.2, 0.4.
    assertArrayEquals(new double[] {0.1, 0.2, 0.4}, use.rims(), 1e-9);
    assertArrayEquals(new double[0], CommandUse.of(List.of(run), 0).rims());
    assertArrayEquals(new double[] {0.05, 0.2}, CommandUse.between(use.speeds(), 5), 1e-12);
    assertArrayEquals(new double[] {0.1, 0.95 * 0.3}, CommandUse.among(use.speeds(), 5), 1e-12);
    assertArrayEquals(new double[0], CommandUse.among(new double[0], 5));
    assertArrayEquals(new double[] {0.48, 0.24}, CommandUse.falling(use.speeds(), 0.5, 2), 1e-12);
  }

  /**
   * Even residuals up to 1, in the second half twice as large. The second half is foretold to reach
   * 0.9, where four in five of it, and so nine in ten of all, are within 1.6.
   */
  @Test
  void anotherDrive_scattersAsHalvesDiffer() {
    double[] exertions = new double[402];
    double[][] residuals = new double[402][3];
    for (int i = 0; i < 402; i++) {
      double even = i * 80 % 201 / 100.0 - 1;
      residuals[i][0] = i < 201 ? even : 2 * even;
      residuals[i][1] = even;
    }
    Spread own = Spread.of(exertions, residuals);
    Spread another = Spread.ofAnother(exertions, residuals);
    int last = PinballLoss.QUANTILES - 1;
    assertEquals(1.6 / 0.9, another.at(0, 0)[last] / own.at(0, 0)[last], 0.05);
    // Halves that do not differ leave all as it is.
    assertEquals(own.at(0, 1)[last], another.at(0, 1)[last], 0.03);
    assertEquals(0, another.at(0, 2)[last]);
  }
}
