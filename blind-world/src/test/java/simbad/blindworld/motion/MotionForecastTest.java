package simbad.blindworld.motion;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import simbad.blindworld.motion.MotionChange.Stage;
import simbad.blindworld.world.Pose;

class MotionForecastTest {

  private static final double NEAR = 1e-9;
  private static final Commands NONE = new Commands(new double[1], new double[1], new double[1]);

  private static Outing outing(double... framesS) {
    return new Outing(
        List.of(
            new Outing.Run("r", NONE, framesS, framesS[framesS.length - 1], new Pose(0, 0, 0))));
  }

  private static double[] point(double value) {
    double[] point = new double[MotionForecast.LEVELS];
    Arrays.fill(point, value);
    return point;
  }

  private static MotionForecast points(double[]... windows) {
    return new MotionForecast(
        Arrays.stream(windows)
            .map(w -> Arrays.stream(w).mapToObj(MotionForecastTest::point).toArray(double[][]::new))
            .toArray(double[][][]::new));
  }

  /**
   * Repeats that go 0, 1, 2 and 3 m/s for half a second. Each of four sorted values stands for the
   * middle of its quarter; a quantile lies between the middles beside it, or on the outermost one.
   */
  @Test
  void quantiles_lieBetweenTheMiddlesOfTheRepeats() {
    int[] repeat = {-1};
    MotionChange faster =
        MotionChange.acting(
            Stage.WHEEL,
            random -> {
              repeat[0]++;
              return MotionChange.moving(step -> step.set(repeat[0], repeat[0]));
            });
    Robot robot = new Robot(0, 1, false, Robot.Beliefs.NONE, Robot.Scatter.NONE, false);
    MotionWorld world =
        new MotionWorld(robot, new MotionWorld.Seeing(Robot.Scatter.NONE, 0), List.of(faster));
    MotionForecast forecast = MotionForecast.of(world, outing(0, 0.3, 0.5), 4, 1);
    assertEquals(1, forecast.size());
    double[] turn = forecast.of(0, 2);
    double[] expected =
        IntStream.rangeClosed(1, 19)
            .mapToDouble(q -> Math.toDegrees(0.5 * Math.max(0, Math.min(3, 4 * q / 20.0 - 0.5))))
            .toArray();
    assertArrayEquals(expected, turn, 1e-6);
    turn[0] = 99;
    assertEquals(0, forecast.of(0, 2)[0], NEAR, "a copy");
  }

  /** Levels are 0.05 to 0.95; under by 1 on the upper ten costs 0.05 + ... + 0.5. */
  @Test
  void loss_weighsEachLevelByItsSide() {
    assertEquals(0.05, MotionForecast.level(0), NEAR);
    assertEquals(0.95, MotionForecast.level(18), NEAR);
    double[] stairs = point(0);
    Arrays.fill(stairs, 9, 19, 1);
    MotionForecast forecast = new MotionForecast(new double[][][] {{stairs, point(0), point(0)}});
    assertEquals(2 * 0.05 * 55 / 19, forecast.loss(0, 0, 0), NEAR);
    // Over by 1 on the lower nine.
    assertEquals(2 * 0.05 * 45 / 19, forecast.loss(0, 0, 1), NEAR);
  }

  /** Windows from 0 to 0.5, 0 to 2 and 1.5 to 2 s; none of 5 s. */
  @Test
  void losses_areMeansByHorizonAndComponent() {
    Windows windows = Windows.of(outing(0, 0.5, 1.5, 2));
    assertEquals(3, windows.size());
    MotionForecast forecast =
        points(new double[] {0, 1, 2}, new double[] {3, 4, 5}, new double[] {6, 7, 8});
    double[][] shown = {{0.5, 1, 2}, {3, 4.25, 3}, {6.25, 8, 8}};
    assertArrayEquals(
        new double[] {(0.5 + 0.25) / 2, 0.5, 0, 0, 0.25, 2, 0, 0, 0},
        forecast.losses(windows, shown),
        NEAR);
    assertEquals(9, MotionForecast.FIGURES);
  }

  /** What is nothing with the nominal one is left out. */
  @Test
  void gap_isTheMeanInUnitsOfTheNominal() {
    assertEquals((3 + 0.5) / 2, MotionForecast.gap(new double[] {6, 7, 2}, new double[] {2, 0, 4}));
    assertEquals(0, MotionForecast.gap(new double[] {6}, new double[] {0}));
  }

  @Test
  void csv_hasALineForEachWindow() {
    MotionForecast forecast = points(new double[] {0.1234567, -1, 2.5});
    List<String> lines = forecast.csv(Windows.of(outing(0.5, 1))).lines().toList();
    assertEquals(2, lines.size());
    String[] header = lines.get(0).split(",", -1);
    String[] fields = lines.get(1).split(",", -1);
    assertEquals(3 + 3 * 19, header.length);
    assertEquals(List.of("run", "t_s", "horizon_s", "along_m_q05"), List.of(header).subList(0, 4));
    assertEquals("across_m_q05", header[22]);
    assertEquals("turn_deg_q95", header[59]);
    assertEquals(header.length, fields.length);
    assertEquals(List.of("r", "0.500", "0.5", "0.12346"), List.of(fields).subList(0, 4));
    assertEquals("-1.00000", fields[22]);
    assertEquals("2.5000", fields[59]);
    assertEquals(lines.get(0) + "\n", MotionForecast.header());
    assertEquals("turn_deg_q50", MotionForecast.column("turn_deg", 9));
  }

  @Test
  void undefinedQuantiles_areRefused() {
    assertThrows(IllegalArgumentException.class, () -> points(new double[] {0, Double.NaN, 0}));
  }
}
