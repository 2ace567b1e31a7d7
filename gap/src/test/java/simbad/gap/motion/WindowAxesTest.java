package simbad.gap.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import simbad.motion.Command;
import simbad.motion.Displacement;
import simbad.motion.MotionRun;
import simbad.motion.forecast.Window;

/** What windows are cut by, of two runs. */
class WindowAxesTest {
  private static final double EXACT = 1e-9;
  private static final WindowAxes AXES =
      new WindowAxes(
          List.of(
              new MotionRun("a", List.of(new Command(0, 0.4, 0)), List.of()),
              new MotionRun(
                  "b",
                  List.of(
                      new Command(0, -0.3, 0),
                      new Command(4, 0.1, 0),
                      new Command(6, -0.5, 0),
                      new Command(9, 0, 0)),
                  List.of())));

  private static Window window(int run, double startS) {
    return new Window(
        run, startS, 0.5, 7, 1.5, -2.5, new Displacement(0.2, 0.1, 0.25 + 2 * Math.PI));
  }

  private static double at(String axis, Window window) {
    return Objects.requireNonNull(AXES.byName().get(axis)).applyAsDouble(window);
  }

  /** In half a second 20 cm on, and a quarter radian beside a whole turn. */
  @Test
  void ratesAreWaysByTheSecond() {
    assertEquals(0.4, at("speed_m_s", window(0, 1)), EXACT);
    assertEquals(0.5, at("turn_rad_s", window(0, 1)), EXACT);
  }

  @Test
  void placesAndTimesAreTheWindows() {
    assertEquals(1, at("t_s", window(0, 1)), 0);
    assertEquals(1.5, at("x_m", window(0, 1)), 0);
    assertEquals(2.5, at("z_m", window(0, 1)), 0);
    assertEquals(Math.toDegrees(7 - 2 * Math.PI), at("heading_deg", window(0, 1)), EXACT);
  }

  /** From the last command before its end: at 4 s itself it acts already. */
  @Test
  void timeRunsFromTheLastChange() {
    assertEquals(3.4, at("since_change_s", window(1, 2.9)), EXACT);
    assertEquals(0, at("since_change_s", window(1, 3.5)), EXACT);
    assertEquals(1.9, at("since_change_s", window(1, 7.4)), EXACT);
    assertEquals(11.5, at("since_change_s", window(1, 20)), EXACT);
    assertEquals(20.5, at("since_change_s", window(0, 20)), EXACT);
  }

  /** Sizes count, not directions; what changed longer than half a second before does not. */
  @Test
  void aChangeOfSpeedIsThatOfItsSize() {
    assertEquals(-0.2, at("speed_change_m_s", window(1, 4.4)), EXACT);
    assertEquals(0, at("speed_change_m_s", window(1, 4.6)), 0);
    assertEquals(0.4, at("speed_change_m_s", window(1, 5.6)), EXACT);
    assertEquals(-0.5, at("speed_change_m_s", window(1, 8.6)), EXACT);
    assertEquals(0, at("speed_change_m_s", window(1, 0)), 0);
    assertEquals(0, at("speed_change_m_s", window(0, 0)), 0);
  }

  @Test
  void axesStandInAFixedOrder() {
    assertEquals(
        List.of(
            "speed_m_s",
            "turn_rad_s",
            "since_change_s",
            "speed_change_m_s",
            "t_s",
            "heading_deg",
            "x_m",
            "z_m"),
        List.copyOf(AXES.byName().keySet()));
  }
}
