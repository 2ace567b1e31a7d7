package simbad.blindworld.motion;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import simbad.blindworld.motion.Commands.Speeds;

class CommandsTest {

  private static final double NEAR = 1e-12;

  private static Commands told() {
    return new Commands(
        new double[] {0, 1, 1, 2.5},
        new double[] {0.2, -0.4, 0, 0.1},
        new double[] {0, 0.5, -0.25, 1});
  }

  private static double[] times(Commands commands) {
    return IntStream.range(0, commands.size()).mapToDouble(commands::timeS).toArray();
  }

  /** 0.3 m/s and 0.8 rad/s on a base of 0.25 m are rims of 0.2 and 0.4 m/s. */
  @Test
  void rims_areSpeedLessAndMoreHalfOfTheTurn() {
    Speeds speeds = new Speeds(0.3, 0.8);
    assertEquals(0.2, speeds.left(0.25), NEAR);
    assertEquals(0.4, speeds.right(0.25), NEAR);
    Speeds back = Speeds.ofRims(0.2, 0.4, 0.25);
    assertEquals(0.3, back.vMPerS(), NEAR);
    assertEquals(0.8, back.wRadPerS(), NEAR);
    Speeds squared = speeds.rims(0.25, r -> r * r);
    assertEquals((0.04 + 0.16) / 2, squared.vMPerS(), NEAR);
    assertEquals((0.16 - 0.04) / 0.25, squared.wRadPerS(), NEAR);
  }

  @Test
  void each_asksInTheOrderOfTime_andKeepsTheTimes() {
    List<Double> asked = new ArrayList<>();
    Commands changed =
        told()
            .each(
                s -> {
                  asked.add(s.vMPerS());
                  return new Speeds(s.wRadPerS(), s.vMPerS());
                });
    assertEquals(List.of(0.2, -0.4, 0.0, 0.1), asked);
    assertArrayEquals(times(told()), times(changed));
    assertEquals(new Speeds(0.5, -0.4), changed.at(1));
    assertEquals(new Speeds(1, 0.1), changed.at(3));
  }

  @Test
  void atTimes_neverOvertakesTheOneBefore() {
    Commands late = told().atTimes(new double[] {3, 2, 5, 4});
    assertArrayEquals(new double[] {3, 3, 5, 5}, times(late));
    assertEquals(told().at(3), late.at(3));
    assertArrayEquals(new double[] {0.5, 1.5, 1.5, 3}, times(told().later(0.5)), NEAR);
  }

  /**
   * Of 0.1, 0.2 and 0.4 m/s, and of 0.25, 0.5 and 1 rad/s: what stands still counts for nothing.
   */
  @Test
  void quantiles_areOfWhatMoves() {
    assertEquals(0.1, told().speedQuantile(0));
    assertEquals(0.1, told().speedQuantile(0.3));
    assertEquals(0.2, told().speedQuantile(0.5));
    assertEquals(0.4, told().speedQuantile(0.7));
    assertEquals(0.4, told().speedQuantile(1));
    assertEquals(0.25, told().turnQuantile(0.2));
    assertEquals(1, told().turnQuantile(1));
    Commands still = new Commands(new double[1], new double[] {1e-9}, new double[1]);
    assertEquals(0, still.speedQuantile(0.5));
    assertEquals(0, still.turnQuantile(1));
  }

  /** Before the first command it stands; 0.2 m/s for 1 s, then nothing, for 1.5 s. */
  @Test
  void means_areOverWhatIsHeld() {
    Commands.Means means = told().means();
    assertEquals(new Speeds(0, 0), means.over(-1, 0.5));
    assertEquals(0.2 * 0.25 / 0.75, means.over(-0.5, 0.75).vMPerS(), NEAR);
    Speeds across = means.over(0.25, 1.25);
    assertEquals(0.2 * 0.75 / 1.25, across.vMPerS(), NEAR);
    assertEquals(-0.25 * 0.5 / 1.25, across.wRadPerS(), NEAR);
    Speeds last = means.over(1.5, 2);
    assertEquals(0.1 * 1 / 2, last.vMPerS(), NEAR);
    assertEquals((-0.25 + 1) / 2, last.wRadPerS(), NEAR);
    assertEquals(0.1, means.over(3.5, 9).vMPerS(), NEAR);
  }

  @Test
  void arrays_areCopied_andColumnsAsLong() {
    double[] times = {0, 1};
    double[] two = {3, 4};
    Commands commands = new Commands(times, two, two);
    times[1] = 9;
    two[1] = 9;
    assertEquals(1, commands.timeS(1));
    assertEquals(new Speeds(4, 4), commands.at(1));
    double[] one = new double[1];
    assertThrows(IllegalArgumentException.class, () -> new Commands(times, one, two));
    double[] undefined = {0, Double.NaN};
    assertThrows(IllegalArgumentException.class, () -> new Commands(undefined, two, two));
  }
}
