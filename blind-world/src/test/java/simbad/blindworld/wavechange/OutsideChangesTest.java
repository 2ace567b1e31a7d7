package simbad.blindworld.wavechange;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static simbad.blindworld.wavechange.WaveGround.BOX_TARGET;
import static simbad.blindworld.wavechange.WaveGround.CORNERS;
import static simbad.blindworld.wavechange.WaveGround.POLE_TARGET;
import static simbad.blindworld.wavechange.WaveGround.after;
import static simbad.blindworld.wavechange.WaveGround.assertSounds;
import static simbad.blindworld.wavechange.WaveGround.draw;
import static simbad.blindworld.wavechange.WaveGround.ear;
import static simbad.blindworld.wavechange.WaveGround.gear;
import static simbad.blindworld.wavechange.WaveGround.number;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import simbad.blindworld.wave.Outline;
import simbad.blindworld.wave.Reflector;
import simbad.blindworld.wave.Swaying;
import simbad.blindworld.world.FixedChance;

/** What no name of the vocabulary means. */
class OutsideChangesTest {

  private static final double NEAR = 1e-9;
  private static final List<Set<String>> FADING =
      List.of(Set.of("gain"), Set.of("dropout"), Set.of("absorption"));

  private static FixedChance down() {
    return new FixedChance(0.5).coins(false);
  }

  private static double louderDb(WaveEffect effect, double share) {
    assertEquals(0, effect.alteration().headroomDb(), "never louder than before");
    return ear(effect).louderDb(after(share));
  }

  /** Two scatters that know nothing of each other add by their squares. */
  @Test
  void wind_scattersBesideTheAir() {
    WaveEffect effect = draw("wind", 1);
    assertEquals(4, number(effect, "scatter_db"), NEAR);
    assertEquals(5, effect.alteration().scatterDb(3), NEAR);
    assertEquals(15, number(draw("wind", 9), "scatter_db"), NEAR);
    assertEquals(List.of(Set.of("dropout")), effect.also());
  }

  /** Twice over the log it is wet and dries in 0.275 of the whole. */
  @Test
  void wetMembrane_driesAndComesAgain() {
    WaveEffect effect = draw("wet-membrane", 1);
    assertEquals(2, number(effect, "times"));
    assertEquals(0.275, number(effect, "dries_in"), NEAR);
    assertEquals(-7, louderDb(effect, 0), NEAR);
    assertEquals(-7 * Math.exp(-0.8 / 0.275), louderDb(effect, 0.4), NEAR);
    assertEquals(-7, louderDb(effect, 0.5), NEAR);
    assertEquals(-7 * Math.exp(-0.2 / 0.275), louderDb(effect, 0.6), NEAR);
    assertEquals(FADING, effect.also());
    assertEquals(List.of(Set.of("wet-membrane")), effect.accept());
  }

  @Test
  void supply_fallsByAPower() {
    WaveEffect effect = draw("supply-voltage", 2);
    assertEquals(14, number(effect, "db"), NEAR);
    assertEquals(2.75, number(effect, "power"), NEAR);
    assertEquals(0, louderDb(effect, 0), NEAR);
    assertEquals(-14 * Math.pow(0.5, 2.75), louderDb(effect, 0.5), NEAR);
    assertEquals(FADING, effect.also());
  }

  /** 3.25 waves over the log between nothing and 5 dB. */
  @Test
  void transmitter_fadesInWaves() {
    WaveEffect effect = draw("fading-transmitter", 1);
    assertEquals(3.25, number(effect, "waves"), NEAR);
    assertEquals(-2.5, louderDb(effect, 0), NEAR);
    assertEquals(-5, louderDb(effect, 1 / 13.0), NEAR);
    assertEquals(0, louderDb(effect, 3 / 13.0), NEAR);
  }

  /** Of 8 cycles 0.55 are 4.4; never all of them, and never none. */
  @Test
  void shortBurst_hasFewerCycles() {
    WaveEffect effect = draw("short-burst", 1);
    assertEquals(8, number(effect, "before"));
    assertEquals(4, number(effect, "cycles"));
    assertEquals(4, gear(effect).burst().cycles());
    assertEquals(7, number(draw("short-burst", 0.01), "cycles"));
    assertEquals(1, number(draw("short-burst", 9), "cycles"));
  }

  @Test
  void carrier_isAnotherOne() {
    WaveEffect effect = draw("carrier-shift", 1, down());
    assertEquals(40_000, number(effect, "before"));
    assertEquals(38_800, number(effect, "hz"), NEAR);
    assertEquals(38_800, gear(effect).burst().frequencyHz(), NEAR);
    assertEquals(52_000, number(draw("carrier-shift", 99), "hz"), NEAR);
    assertEquals(28_000, number(draw("carrier-shift", 99, down()), "hz"), NEAR);
  }

  /** Where a name loses the same echoes it may stand alone or with what is found later. */
  @Test
  void weakerBurst_isCalledByWhatLosesTheSameEchoes() {
    for (String name : List.of("short-burst", "carrier-shift")) {
      WaveEffect effect = draw(name, 1);
      List<Set<String>> expected = new ArrayList<>(List.of(Set.of(name)));
      for (Set<String> rival : Rivals.of(effect, WaveGround.site(new FixedChance(0.5), 1))) {
        String only = rival.iterator().next();
        expected.add(rival);
        expected.add(Set.of(only, "range-offset"));
        expected.add(Set.of(only, "range-walk"));
      }
      assertEquals(expected, effect.accept());
      assertEquals(expected.size() > 1 ? List.of() : List.of(Set.of("gain")), effect.also(), name);
    }
  }

  /**
   * Two Gaussians exp(-(ka sin)^2 / 8) that are turned by 18 degrees against each other look 9
   * degrees aside and hear 20 lg of exp(-(ka sin 9)^2 / 4) less: 1.8 dB.
   */
  @Test
  void receiverThatIsTurned_isFainterAndLooksAside() {
    WaveEffect effect = draw("receiver-turned", 1, down());
    double ka = 2 * Math.PI * 40_000 / 343.2 * 0.008;
    double aside = ka * Math.sin(Math.toRadians(9));
    double loss = -20 * Math.log10(Math.exp(-aside * aside / 4));
    assertEquals(-18, number(effect, "deg"), NEAR);
    assertEquals(loss, number(effect, "loss_db"), NEAR);
    assertEquals(Math.toRadians(-18), gear(effect).pistons().receiverAxisRad(), NEAR);
    assertEquals(0, gear(effect).pistons().axisRad());
    Set<String> both = Set.of("beam-misalignment", "gain");
    assertEquals(List.of(Set.of("receiver-turned"), both), effect.accept());
    assertEquals(List.of(Set.of("beam-misalignment")), effect.also());
    WaveEffect small = draw("receiver-turned", 0.5);
    assertTrue(number(small, "loss_db") < 1);
    assertEquals(
        List.of(Set.of("receiver-turned"), both, Set.of("beam-misalignment")), small.accept());
    assertEquals(List.of(), small.also());
    // Behind it there is nothing more to lose.
    assertEquals(
        -20 * Math.log10(Math.exp(-ka * ka / 4)),
        number(draw("receiver-turned", 20), "loss_db"),
        NEAR);
  }

  /**
   * Foam looks to -36 degrees and covers 48 to each side: of the box's faces, at 180, 90, 0 and -90
   * degrees, that is the third one.
   */
  @Test
  void foam_coversTheFacesOnItsSide() {
    WaveEffect effect = draw("foam", 1, new FixedChance(0.9, 0.4));
    assertEquals(0, number(effect, "obstacle"), "an edged one");
    assertEquals(10, number(effect, "db"), NEAR);
    WaveEffect foam = draw("foam", 1, new FixedChance(0.4));
    assertEquals(-36, number(foam, "centre"), NEAR);
    assertEquals(48, number(foam, "half"), NEAR);
    double left = Math.pow(10, -0.5);
    Outline covered = Outline.covered(CORNERS, List.of(1.0, 1.0, left, 1.0));
    assertSounds(List.of(BOX_TARGET.with(covered), POLE_TARGET), foam);
    assertEquals(60, number(draw("foam", 9, new FixedChance(0.4)), "db"), NEAR);
    assertEquals(List.of(Set.of("obstacle-turn"), Set.of("gain")), foam.also());
  }

  /** By chance of 0.25 the box swings down the page. */
  @Test
  void sway_isAlongADirection() {
    WaveEffect effect = draw("sway", 2, new FixedChance(0.25));
    List<Reflector> things = effect.alteration().reflectors(List.of(BOX_TARGET, POLE_TARGET));
    Swaying swaying = (Swaying) things.get(0);
    assertEquals(0, swaying.swingXM(), NEAR);
    assertEquals(0.1, swaying.swingZM(), NEAR);
    assertEquals(1.3 + 7.7 / 4, swaying.periodS(), NEAR);
    assertEquals(swaying.periodS(), number(effect, "period_s"), NEAR);
    assertEquals(0.1, number(effect, "m"), NEAR);
    assertEquals(POLE_TARGET, things.get(1));
  }
}
