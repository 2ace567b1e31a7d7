package simbad.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.motion.effect.MotionForm;
import simbad.motion.effect.MotionForms;

class WayTest {
  private static final MotionRun CIRCLE =
      new MotionRun("a", List.of(new Command(0, 0.2, 0.5)), List.of());

  private static Displacement way(MotionRun run, MotionChain chain, double from, double to) {
    return Way.of(run, chain, 0, 20).between(from, to);
  }

  /**
   * 0.2 m/s at 0.5 rad/s is a circle of 0.4 m: half of it takes 2 pi seconds, 0.8 m to the left.
   */
  @Test
  void way_ofHeldCommands_isTheArc() {
    Displacement half = way(CIRCLE, MotionChain.EXACT, 1, 1 + 2 * Math.PI);
    assertEquals(0, half.alongM(), 1e-4);
    assertEquals(0.8, half.acrossM(), 1e-4);
    assertEquals(Math.PI, half.turnRad(), 1e-9);
  }

  @Test
  void neutralForms_changeNoBit() {
    Displacement exact = way(CIRCLE, MotionChain.EXACT, 0, 3);
    for (MotionForm form : MotionForms.ALL) {
      MotionChain chain = MotionChain.EXACT.with(form.neutral());
      assertEquals(exact, way(CIRCLE, chain, 0, 3), form.form());
    }
  }

  /** After a start, a lag of T costs T seconds of way: v T (1 - exp(-t / T)). */
  @Test
  void lag_costsItsTimeConstant() {
    MotionForm lag = MotionForms.find("actuation-lag: time constants").orElseThrow();
    MotionRun straight = new MotionRun("a", List.of(new Command(0, 1, 0)), List.of());
    MotionChain chain = MotionChain.EXACT.with(lag.change(0.3, 0));
    assertEquals(5 - 0.3 * (1 - Math.exp(-5 / 0.3)), way(straight, chain, 0, 5).alongM(), 1e-9);
  }

  @Test
  void latency_shiftsTheStart() {
    MotionForm late = MotionForms.find("actuation-latency").orElseThrow();
    MotionRun straight = new MotionRun("a", List.of(new Command(0, 1, 0)), List.of());
    MotionChain chain = MotionChain.EXACT.with(late.change(0.25));
    assertEquals(0.75, way(straight, chain, 0, 1).alongM(), 1e-9);
  }

  /**
   * A point 0.1 m before the centre of a robot that turns by a quarter goes 0.1 m back and left.
   */
  @Test
  void captureOffset_movesWithTheTurn() {
    MotionForm point = MotionForms.find("capture-offset: point").orElseThrow();
    MotionRun turning = new MotionRun("a", List.of(new Command(0, 0, Math.PI / 2)), List.of());
    Displacement seen = way(turning, MotionChain.EXACT.with(point.change(0.1, 0)), 0, 1);
    assertEquals(-0.1, seen.alongM(), 1e-9);
    assertEquals(0.1, seen.acrossM(), 1e-9);
  }

  /** At 0.5 m/s2 it takes 2 s to 1 m/s, in which it goes 1 m. */
  @Test
  void acceleration_isARamp() {
    MotionForm limit = MotionForms.find("actuation-lag: greatest acceleration").orElseThrow();
    MotionRun straight = new MotionRun("a", List.of(new Command(0, 1, 0)), List.of());
    MotionChain chain = MotionChain.EXACT.with(limit.change(0.5, 1000));
    assertEquals(1 + 3, way(straight, chain, 0, 5).alongM(), 1e-9);
  }

  /** Ten thousand steps by rotations end where the arc ends. */
  @Test
  void longWay_keepsItsDirection() {
    MotionRun circle = new MotionRun("a", List.of(new Command(0, 0.2, 0.5)), List.of());
    Displacement rounds = Way.of(circle, MotionChain.EXACT, 0, 210).between(0, 64 * Math.PI);
    assertEquals(0, rounds.alongM(), 1e-4);
    assertEquals(0, rounds.acrossM(), 1e-4);
  }

  @Test
  void repeatedCommands_changeNothing() {
    MotionRun twice =
        new MotionRun(
            "a",
            List.of(new Command(0, 0.2, 0.5), new Command(1, 0.2, 0.5), new Command(2, 0, 0)),
            List.of());
    assertEquals(2, twice.withoutRepeats().commands().size());
    assertEquals(
        way(twice, MotionChain.EXACT, 0, 3).alongM(),
        way(twice.withoutRepeats(), MotionChain.EXACT, 0, 3).alongM(),
        1e-12);
  }
}
