package simbad.blindworld.wavechange;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static simbad.blindworld.wavechange.WaveGround.AIR;
import static simbad.blindworld.wavechange.WaveGround.SOUND_M_PER_S;
import static simbad.blindworld.wavechange.WaveGround.draw;
import static simbad.blindworld.wavechange.WaveGround.ear;
import static simbad.blindworld.wavechange.WaveGround.gear;
import static simbad.blindworld.wavechange.WaveGround.number;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.blindworld.wave.Air;
import simbad.blindworld.wave.WavePing;
import simbad.blindworld.world.FixedChance;

/** What happens to air, sonar and timer. */
class SonarChangesTest {

  private static final double NEAR = 1e-9;
  private static final WavePing PING = WaveGround.after(0);

  private static FixedChance down() {
    return new FixedChance(0.5).coins(false);
  }

  /** 11 kelvin warmer or colder, from -35 to 65 degrees at most. */
  @Test
  void temperature_changesSpeedAndAbsorption() {
    WaveEffect warmer = draw("sound-speed", 1);
    assertEquals(11, number(warmer, "kelvin"), NEAR);
    assertEquals(343.2 * Math.sqrt(304.15 / 293.15), number(warmer, "c"), NEAR);
    assertEquals(new Air(31, 50, 101.325).absorptionDbPerM(40_000), number(warmer, "alpha"), NEAR);
    assertEquals(31, warmer.alteration().air(AIR).temperatureC(), NEAR);
    assertEquals(-22, number(draw("sound-speed", 2, down()), "kelvin"), NEAR);
    assertEquals(45, number(draw("sound-speed", 9), "kelvin"), NEAR);
    assertEquals(-55, number(draw("sound-speed", 9, down()), "kelvin"), NEAR);
    assertEquals(
        List.of(
            Set.of("sound-speed"),
            Set.of("sound-speed", "gain"),
            Set.of("sound-speed", "absorption")),
        warmer.accept());
    assertEquals(List.of(Set.of("odometry-scale")), warmer.also());
  }

  /** Of all humidities in steps of a half it is the one that comes nearest to 0.5 dB/m. */
  @ParameterizedTest
  @ValueSource(doubles = {0.2, 1, 9})
  void humidity_isTheNearestToItsSize(double size) {
    WaveEffect effect = draw("absorption", size);
    double before = AIR.absorptionDbPerM(40_000);
    assertEquals(before, number(effect, "before"), NEAR);
    double percent = number(effect, "rh");
    double alpha = AIR.withHumidity(percent).absorptionDbPerM(40_000);
    assertEquals(alpha, number(effect, "alpha"), NEAR);
    assertEquals(percent, effect.alteration().air(AIR).humidityPercent());
    double misses = Math.abs(Math.abs(alpha - before) - 0.5 * size);
    for (int half = 4; half <= 198; half++) {
      double other = AIR.withHumidity(half / 2.0).absorptionDbPerM(40_000);
      assertTrue(
          Math.abs(Math.abs(other - before) - 0.5 * size) >= misses - NEAR, half / 2.0 + " %");
    }
  }

  /** Each name that loses echoes is right, near, or the change's own, and never two of them. */
  @ParameterizedTest
  @ValueSource(strings = {"gain", "absorption", "early-timeout"})
  void whatLosesEchoes_isCalledByEveryName(String name) {
    WaveEffect effect = draw(name, 1);
    Set<Set<String>> all = new HashSet<>(effect.accept());
    all.addAll(effect.also());
    assertEquals(Set.of(Set.of("gain"), Set.of("absorption"), Set.of("early-timeout")), all);
    assertEquals(3, effect.accept().size() + effect.also().size());
    assertTrue(effect.accept().contains(Set.of(name)));
  }

  /** Fainter in seven of ten. */
  @Test
  void amplifier_isFainterMoreOften() {
    WaveEffect fainter = draw("gain", 2, new FixedChance(0.69));
    assertEquals(-7, number(fainter, "db"), NEAR);
    assertEquals(-7, gear(fainter).levelDb(), NEAR);
    assertEquals(3.5, gear(draw("gain", 1, new FixedChance(0.71))).levelDb(), NEAR);
  }

  /** The quantile 0.78 of what is heard is the last distance from which an echo is waited for. */
  @Test
  void timeout_isTheTimeOfADistance() {
    WaveEffect effect = draw("early-timeout", 1);
    assertEquals(1.7, number(effect, "m"));
    assertEquals(2 * 1.7 / SOUND_M_PER_S, gear(effect).receiver().timeoutS(), NEAR);
    assertEquals(0.0005, gear(effect).receiver().armS());
  }

  @Test
  void ringing_isTheTimeOfADistance() {
    WaveEffect effect = draw("dead-zone", 1);
    assertEquals(1.2, number(effect, "m"));
    assertEquals(2 * 1.2 / SOUND_M_PER_S, gear(effect).receiver().armS(), NEAR);
    assertEquals(0.02, gear(effect).receiver().timeoutS());
    assertEquals(1.7, number(draw("dead-zone", 9), "m"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"beam-width", "beam-pattern"})
  void membrane_isWiderOrNarrower(String name) {
    WaveEffect effect = draw(name, 2);
    double times = Math.exp(0.6);
    assertEquals(times, number(effect, "ka_times"), NEAR);
    assertEquals(0.008 * times, gear(effect).pistons().senderRadiusM(), NEAR);
    assertEquals(0.008 * times, gear(effect).pistons().receiverRadiusM(), NEAR);
    assertEquals(Math.exp(-0.3), number(draw(name, 1, down()), "ka_times"), NEAR);
    assertEquals(3, number(draw(name, 9), "ka_times"), NEAR);
    assertEquals(0.3, number(draw(name, 9, down()), "ka_times"), NEAR);
    Set<String> both = Set.of("beam-width", "beam-pattern");
    Set<Set<String>> accept = Set.of(Set.of("beam-width"), Set.of("beam-pattern"), both);
    assertEquals(accept, new HashSet<>(effect.accept()));
  }

  @Test
  void bump_turnsBothPistons() {
    WaveEffect effect = draw("beam-misalignment", 2, down());
    assertEquals(-14, number(effect, "deg"), NEAR);
    assertEquals(Math.toRadians(-14), gear(effect).pistons().axisRad(), NEAR);
    assertEquals(0, gear(effect).pistons().receiverAxisRad());
  }

  @Test
  void timer_addsToRanges() {
    WaveEffect effect = draw("range-offset", 2);
    assertEquals(0.07, number(effect, "m"), NEAR);
    assertEquals(1.07, ear(effect).rangeM(1, PING), NEAR);
    assertEquals(-0.035, number(draw("range-offset", 1, down()), "m"), NEAR);
  }

  @Test
  void jitter_scattersRanges() {
    WaveEffect effect = draw("range-noise", 2);
    assertEquals(0.05, number(effect, "m"), NEAR);
    WavePing far = WaveGround.ping(new FixedChance(0.5).gaussian(-2), 0, 0);
    assertEquals(0.9, ear(effect).rangeM(1, far), NEAR);
  }

  /** The recording is 2 s long; it warms up with a constant of 0.35 of that. */
  @Test
  void warmUp_driftsToItsEnd() {
    WaveEffect effect = draw("range-drift", 1);
    assertEquals(0.06, number(effect, "m"), NEAR);
    assertEquals(0.7, number(effect, "time_s"), NEAR);
    assertEquals(1, ear(effect).rangeM(1, PING), NEAR);
    double later = ear(effect).rangeM(1, WaveGround.ping(new FixedChance(0.5), 0, 0.7));
    assertEquals(1 + 0.06 * (1 - Math.exp(-1)), later, NEAR);
    assertEquals(List.of(Set.of("range-offset")), effect.also());
  }

  /** None to five periods of 25 microseconds. */
  @Test
  void hops_areWholePeriods() {
    WaveEffect effect = draw("wave-hop", 1);
    assertEquals(5, number(effect, "most"));
    for (int hops = 0; hops <= 5; hops++) {
      WavePing ping = WaveGround.ping(new FixedChance((hops + 0.5) / 6), 0, 0);
      assertEquals(0.01 + hops * 25e-6, ear(effect).arrivalS(0.01, ping), NEAR);
    }
    assertEquals(1, number(draw("wave-hop", 0.01), "most"));
    assertEquals(
        List.of(
            Set.of("wave-hop"),
            Set.of("wave-hop", "range-offset"),
            Set.of("range-noise", "range-offset")),
        effect.accept());
  }

  /** 4.5 cm are 5 of the fine steps of 1 cm, by the range before any step; a whole step is kept. */
  @Test
  void coarseSteps_areWholeFineOnes() {
    WaveEffect effect = draw("coarse-resolution", 1);
    assertEquals(0.05, number(effect, "m"), NEAR);
    assertEquals(1.05, ear(effect).steppedM(1.09, 1.099, PING), NEAR);
    assertEquals(1.05, ear(effect).steppedM(9, 21 * 0.05, PING), NEAR);
    assertEquals(0.01, number(draw("coarse-resolution", 0.01), "m"), NEAR);
  }
}
