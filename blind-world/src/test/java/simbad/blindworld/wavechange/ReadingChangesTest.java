package simbad.blindworld.wavechange;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static simbad.blindworld.wavechange.WaveGround.draw;
import static simbad.blindworld.wavechange.WaveGround.ear;
import static simbad.blindworld.wavechange.WaveGround.gear;
import static simbad.blindworld.wavechange.WaveGround.number;

import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.blindworld.effect.Effect;
import simbad.blindworld.effect.Vocabulary;
import simbad.blindworld.wave.Ear;
import simbad.blindworld.wave.WavePing;
import simbad.blindworld.world.FixedChance;
import simbad.blindworld.world.Pose;
import simbad.blindworld.world.Row;

/** What happens to poses, arrivals and reports, with chance that is told what to say. */
class ReadingChangesTest {

  private static final double NONE = Double.POSITIVE_INFINITY;
  private static final double NEAR = 1e-12;
  private static final WavePing PING = WaveGround.after(0);

  /** As in the worlds without waves. */
  @ParameterizedTest
  @CsvSource({
    "latency, seconds, ''",
    "odometry-scale, from the start, sound-speed",
    "heading-drift, in place, beam-misalignment",
  })
  void poses_areThoseOfTheOtherWorlds(String name, String form, String also) {
    WaveEffect effect = draw(name, 1);
    Effect other =
        Vocabulary.draw(name, form, WaveGround.site(new FixedChance(0.5), 1).circumstances());
    assertEquals(other.parameters(), effect.parameters());
    assertEquals(List.of(Set.of(name)), effect.accept());
    assertEquals(also.isEmpty() ? List.of() : List.of(Set.of(also)), effect.also());
    List<Pose> believed = WaveGround.ROUND.rows().stream().map(Row::pose).toList();
    List<Pose> moved = effect.alteration().poses(WaveGround.ROUND, believed);
    assertNotEquals(believed, moved);
    assertEquals(other.change().poses(WaveGround.ROUND, believed, new FixedChance(0.5)), moved);
  }

  private static boolean[] lost(WaveEffect effect, double... draws) {
    Ear ear = ear(effect);
    FixedChance chance = new FixedChance(draws);
    boolean[] lost = new boolean[draws.length];
    for (int i = 0; i < lost.length; i++) {
      double arrival = ear.arrivalS(0.01, WaveGround.ping(chance, i, i));
      assertTrue(arrival == 0.01 || arrival == NONE, "arrival " + arrival);
      lost[i] = arrival == NONE;
    }
    return lost;
  }

  /** Each ping by itself is lost in a fifth. */
  @Test
  void dropout_isSingle() {
    WaveEffect effect = draw("dropout", 1);
    assertEquals(0.2, number(effect, "share"), NEAR);
    assertEquals(1, number(effect, "mean_length"));
    assertArrayEquals(
        new boolean[] {true, false, true, false}, lost(effect, 0.19, 0.21, 0.19, 0.9));
    assertEquals(0.9, number(draw("dropout", 9), "share"), NEAR);
  }

  /**
   * Or in bursts of four pings: one ends with a chance of 1/4 and begins with one of 1/16, so that
   * a fifth is lost. The first ping is lost in a fifth.
   */
  @Test
  void dropout_isInBursts() {
    WaveEffect effect = draw("dropout", 1, new FixedChance(1.0 / 9).coins(false));
    assertEquals(4, number(effect, "mean_length"), NEAR);
    assertArrayEquals(
        new boolean[] {true, true, false, false, true, true, false},
        lost(effect, 0.19, 0.26, 0.24, 0.063, 0.062, 0.9, 0.1));
    assertArrayEquals(new boolean[] {false, false}, lost(effect, 0.21, 0.19));
    // Each track begins anew.
    Ear ear = ear(effect);
    ear.arrivalS(1, WaveGround.ping(new FixedChance(0.1), 0, 0));
    assertEquals(1, ear(effect).arrivalS(1, WaveGround.ping(new FixedChance(0.3), 1, 0)));
  }

  /**
   * The other sonar's clock has a period of 0.125 s, begun at a tenth of it: it is heard 12.5 ms
   * after pings at whole periods. It is listened to from 0.5 to 20 ms.
   */
  @Test
  void crosstalk_isAnotherSonarsClock() {
    WaveEffect effect = draw("crosstalk", 1);
    assertEquals(0.125, number(effect, "period_s"), NEAR);
    assertEquals(0.5, number(effect, "chance"), NEAR);
    Ear ear = ear(effect);
    FixedChance chance = new FixedChance(0.1, 0.49, 0.49, 0.51, 0.49, 0.49, 0.49, 0.49);
    assertEquals(0.0125, ear.arrivalS(NONE, WaveGround.ping(chance, 0, 0)), NEAR);
    assertEquals(0.0125, ear.arrivalS(0.015, WaveGround.ping(chance, 1, 0.125)), NEAR);
    assertEquals(NONE, ear.arrivalS(NONE, WaveGround.ping(chance, 2, 0.25)), "not by chance");
    assertEquals(0.005, ear.arrivalS(0.005, WaveGround.ping(chance, 3, 0.25)), "the first counts");
    // 2.5 ms later in its own time it comes after 10 ms.
    assertEquals(0.01, ear.arrivalS(NONE, WaveGround.ping(chance, 4, 0.1275)), NEAR);
    assertEquals(NONE, ear.arrivalS(NONE, WaveGround.ping(chance, 5, 0.0121)), "armed");
    assertEquals(NONE, ear.arrivalS(NONE, WaveGround.ping(chance, 6, 0.1161)), "open");
    assertEquals(1, number(draw("crosstalk", 9), "chance"));
  }

  /** A clock that goes by 2 per cent wrong is off by as much of the time. */
  @Test
  void crosstalk_drifts() {
    FixedChance fast = new FixedChance(0.5, 1 - 1e-15);
    Ear ear = ear(draw("crosstalk", 1, fast));
    FixedChance chance = new FixedChance(0.1, 0.2, 0.2);
    assertEquals(0.0125, ear.arrivalS(NONE, WaveGround.ping(chance, 0, 0)), NEAR);
    // After 0.125 s of ours it is 2.5 ms further.
    assertEquals(0.01, ear.arrivalS(NONE, WaveGround.ping(chance, 1, 0.125)), NEAR);
  }

  /** The threshold is ten standard deviations; now 3.6, or 3.6 / 2^0.1 for twice the size. */
  @Test
  void crosstalk_isAHiss() {
    WaveEffect effect = draw("crosstalk", 1, new FixedChance(0.5).coins(false));
    assertEquals(10 / 3.6, number(effect, "noise_times"), NEAR);
    assertEquals(0.0004 * 10 / 3.6, gear(effect).receiver().noise(), NEAR);
    WaveEffect twice = draw("crosstalk", 2, new FixedChance(0.5).coins(false));
    assertEquals(10 / 3.6 * Math.pow(2, 0.1), number(twice, "noise_times"), NEAR);
    WaveEffect least = draw("crosstalk", 1e-9, new FixedChance(0.5).coins(false));
    assertEquals(1, number(least, "noise_times"), "never less noise than there was");
  }

  private static double[] report(WaveEffect effect, double... readings) {
    Ear ear = ear(effect);
    double[] reported = new double[readings.length];
    for (int i = 0; i < reported.length; i++) {
      reported[i] = ear.reportedM(readings[i], PING);
    }
    return reported;
  }

  /** For two misses; after those nothing is held until the next echo. */
  @Test
  void staleReading_isTheLastEcho() {
    WaveEffect effect = draw("stale-reading", 0.5);
    assertEquals(2, number(effect, "n"));
    assertArrayEquals(
        new double[] {NONE, 1, 1, 1, NONE, NONE, 2, 2, 3, 3, 3, NONE},
        report(effect, NONE, 1, NONE, NONE, NONE, NONE, 2, NONE, 3, NONE, NONE, NONE));
    assertEquals(4, number(draw("stale-reading", 1), "n"));
    assertEquals(1, number(draw("stale-reading", 0.01), "n"));
  }

  /** The quantile 0.22 of what is heard, and 0.7 at most. */
  @Test
  void nearClamp_isTheLeastThatIsReported() {
    WaveEffect effect = draw("near-clamp", 1);
    assertEquals(1.2, number(effect, "m"));
    assertArrayEquals(new double[] {1.2, 1.2, 1.3, NONE}, report(effect, 0.5, 1.2, 1.3, NONE));
    assertEquals(1.7, number(draw("near-clamp", 9), "m"));
  }

  @Test
  void noEcho_isSaidByANumber() {
    assertArrayEquals(new double[] {1.5, 0}, report(draw("no-echo-code", 1), 1.5, NONE));
    WaveEffect most = draw("no-echo-code", 1, new FixedChance(0.5).coins(false));
    assertEquals(4, number(most, "m"));
    assertArrayEquals(new double[] {1.5, 4}, report(most, 1.5, NONE));
    // Where a no-echo counts as the greatest range anyhow, only nought is another code.
    Site alike =
        new Site(
            WaveGround.ROOM,
            WaveGround.PARTS,
            WaveGround.scene(4),
            WaveGround.ROUND,
            true,
            WaveGround.HEARD,
            new FixedChance(0.5).coins(false),
            1);
    assertEquals(0, number(WaveVocabulary.draw("no-echo-code", alike), "m"));
  }
}
