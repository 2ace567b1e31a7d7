package simbad.blindworld.wavechange;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static simbad.blindworld.wavechange.WaveGround.BOX_TARGET;
import static simbad.blindworld.wavechange.WaveGround.MOUNT_M;
import static simbad.blindworld.wavechange.WaveGround.POLE_TARGET;
import static simbad.blindworld.wavechange.WaveGround.assertSounds;
import static simbad.blindworld.wavechange.WaveGround.draw;
import static simbad.blindworld.wavechange.WaveGround.number;

import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import simbad.blindworld.wave.FixedEcho;
import simbad.blindworld.wave.Mirrored;
import simbad.blindworld.wave.Outline;
import simbad.blindworld.wave.Reflector;
import simbad.blindworld.wave.Target;
import simbad.blindworld.wave.Upright;
import simbad.blindworld.world.FixedChance;
import simbad.blindworld.world.Point;

/** What happens to things around: each change sounds like a scene that is built by hand. */
class SceneChangesTest {

  private static final double NEAR = 1e-9;
  private static final List<Reflector> THINGS = List.of(BOX_TARGET, POLE_TARGET);

  /** Chance that takes the first obstacle, the box. */
  private static FixedChance box() {
    return new FixedChance(0.25);
  }

  @Test
  void turn_isOfAnEdgedOne() {
    WaveEffect effect = draw("obstacle-turn", 2, box());
    assertEquals(0, number(effect, "obstacle"));
    assertEquals(14, number(effect, "deg"), NEAR);
    assertSounds(List.of(BOX_TARGET.turned(Math.toRadians(14)), POLE_TARGET), effect);
    // A round one is drawn first, and another time until it is an edged one.
    WaveEffect back = draw("obstacle-turn", 1, new FixedChance(0.9, 0.9, 0.1).coins(false));
    assertEquals(0, number(back, "obstacle"));
    assertEquals(-7, number(back, "deg"), NEAR);
  }

  /** A quarter of a turn is down the page. */
  @Test
  void offset_isAnywhere() {
    WaveEffect effect = draw("obstacle-offset", 2, box());
    assertEquals(0, number(effect, "x"), NEAR);
    assertEquals(0.12, number(effect, "z"), NEAR);
    assertSounds(List.of(BOX_TARGET.moved(0, 0.12), POLE_TARGET), effect);
    WaveEffect pole = draw("obstacle-offset", 1);
    assertEquals(1, number(pole, "obstacle"));
    assertEquals(-0.06, number(pole, "x"), NEAR);
    Target moved = (Target) pole.alteration().reflectors(THINGS).get(1);
    assertEquals(1.94, moved.place().xM(), NEAR);
    assertEquals(0, moved.place().zM(), NEAR);
  }

  /** A board across x, so wide, with its middle at a place. */
  private static Target board(double xM, double widthM) {
    double half = widthM / 2;
    Outline outline =
        Outline.of(
            List.of(
                new Point(-0.005, -half),
                new Point(0.005, -half),
                new Point(0.005, half),
                new Point(-0.005, half)));
    return new Target(outline, new Upright(-MOUNT_M, 1 - MOUNT_M), new Point(xM, 0), 0);
  }

  /** Half of a turn from the pole is to its left, 0.95 m away, and the board faces the pole. */
  @Test
  void board_facesAnObstacle() {
    WaveEffect effect = draw("unmodelled-object", 1);
    assertEquals("board", effect.parameters().get("what"));
    assertEquals(0.4, number(effect, "width_m"), NEAR);
    assertEquals(2 - 0.95, number(effect, "x"), NEAR);
    assertEquals(0, number(effect, "z"), NEAR);
    assertSounds(List.of(BOX_TARGET, POLE_TARGET, board(1.05, 0.4)), effect);
    assertEquals(1.2, number(draw("unmodelled-object", 9), "width_m"), NEAR);
  }

  /** Besides, the echo of each obstacle comes by the board, between its two ends. */
  @Test
  void wideBoard_alsoMirrors() {
    WaveEffect effect = draw("multipath", 0.8);
    assertEquals(0.8, number(effect, "width_m"), NEAR);
    double x = 2 - 0.525;
    assertEquals(x, number(effect, "x"), NEAR);
    Point from = new Point(x, -0.4);
    Point to = new Point(x, 0.4);
    assertSounds(
        List.of(
            BOX_TARGET,
            POLE_TARGET,
            board(x, 0.8),
            new Mirrored(BOX_TARGET, from, to),
            new Mirrored(POLE_TARGET, from, to)),
        effect);
    assertEquals(
        List.of(
            Set.of("multipath"),
            Set.of("unmodelled-object"),
            Set.of("multipath", "unmodelled-object")),
        effect.accept());
    assertEquals(1.8, number(draw("multipath", 9), "width_m"), NEAR);
  }

  /** Half a decibel under the threshold at a practical size, and 6 dB more for each doubling. */
  @Test
  void floor_answersAtTheThreshold() {
    WaveEffect effect = draw("floor-echo", 1);
    FixedEcho echo = (FixedEcho) effect.alteration().reflectors(THINGS).get(2);
    assertEquals(new FixedEcho(0.825, -0.5, 2), echo);
    assertEquals(0.825, number(effect, "m"), NEAR);
    assertEquals(2, number(effect, "scatter_db"), NEAR);
    assertEquals(1.5, number(draw("floor-echo", 4), "excess_db"), NEAR);
  }

  /** Of the same cross-section as the round one of 3 cm: a side of sqrt(pi) times the radius. */
  @Test
  void squarePost_standsForARoundOne() {
    WaveEffect effect = draw("orientation-shadow", 1, new FixedChance(0.1, 0.9));
    double side = 0.03 * Math.sqrt(Math.PI);
    assertEquals(1, number(effect, "obstacle"), "the one that is believed the same all round");
    assertEquals(side, number(effect, "side_m"), NEAR);
    double half = side / 2;
    Outline square =
        Outline.of(
            List.of(
                new Point(-half, -half),
                new Point(half, -half),
                new Point(half, half),
                new Point(-half, half)));
    assertSounds(List.of(BOX_TARGET, POLE_TARGET.with(square)), effect);
  }

  /** What is no target stays as it is. */
  @Test
  void whatIsNoTarget_staysAsItIs() {
    FixedEcho echo = new FixedEcho(1, 2, 3);
    List<Reflector> others = List.of(echo, echo);
    assertEquals(others, draw("obstacle-offset", 1).alteration().reflectors(others));
    assertEquals(others, draw("obstacle-turn", 1, box()).alteration().reflectors(others));
    assertEquals(others, draw("orientation-shadow", 1).alteration().reflectors(others));
    assertEquals(others, draw("sway", 1).alteration().reflectors(others));
    assertEquals(others, draw("foam", 1, box()).alteration().reflectors(others));
  }
}
