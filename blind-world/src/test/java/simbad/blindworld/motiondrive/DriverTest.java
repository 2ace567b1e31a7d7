package simbad.blindworld.motiondrive;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import simbad.blindworld.motion.Commands.Speeds;
import simbad.blindworld.world.Chance;
import simbad.blindworld.world.FixedChance;

/** What drivers say next. */
class DriverTest {

  private static final double NEAR = 1e-9;
  private static final Driver.Limits LIMITS = new Driver.Limits(0.5, 2);
  private static final double STEP_S = 0.05;

  private static List<Speeds> told(Driver.Kind kind, long seed, int count) {
    Driver driver = Driver.draw(kind, LIMITS, new Chance(seed));
    List<Speeds> told = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      told.add(driver.next(i * STEP_S));
    }
    return told;
  }

  @Test
  void limits_areNotExceeded() {
    assertEquals(new Speeds(0.25, -1), LIMITS.of(0.5, -0.5));
    assertEquals(new Speeds(0.5, -2), LIMITS.of(7, -7));
    assertEquals(new Speeds(-0.5, 2), LIMITS.of(-7, 7));
  }

  @ParameterizedTest
  @EnumSource
  void everyDriver_drivesWithinItsLimits(Driver.Kind kind) {
    double most = 0;
    double turned = 0;
    for (Speeds speeds : told(kind, 3, 4000)) {
      assertTrue(Math.abs(speeds.vMPerS()) <= 0.5 + NEAR, speeds.toString());
      assertTrue(Math.abs(speeds.wRadPerS()) <= 2 + NEAR, speeds.toString());
      most = Math.max(most, Math.abs(speeds.vMPerS()));
      turned = Math.max(turned, Math.abs(speeds.wRadPerS()));
    }
    assertTrue(most > 0.15, kind + " goes " + most);
    assertTrue(turned > 0.3, kind + " turns " + turned);
    assertEquals(kind.name().toLowerCase(java.util.Locale.ROOT).replace('_', '-'), kind.word());
  }

  /** A piece of 3 s is begun a second late; the next begins where it ends. */
  @Test
  void pieces_followEachOther() {
    int[] made = {0};
    Driver.Pieces pieces =
        new Driver.Pieces(
            LIMITS, new FixedChance(0.5), random -> new Driver.Piece(0.1 * ++made[0], 0, 3));
    double[] times = {0, 1.99, 2, 4.9, 5.1, 8, 20, 20.04};
    int[] which = {1, 1, 2, 2, 3, 4, 5, 5};
    for (int i = 0; i < times.length; i++) {
      assertEquals(0.05 * which[i], pieces.next(times[i]).vMPerS(), NEAR, "at " + times[i]);
    }
    int[] count = {0};
    Driver.Pieces brief =
        new Driver.Pieces(
            LIMITS,
            new FixedChance(0.5),
            random -> {
              count[0]++;
              return new Driver.Piece(0, 0, 0);
            });
    brief.next(0);
    brief.next(0.04);
    assertEquals(1, count[0], "no piece is shorter than a twentieth of a second");
    brief.next(0.05);
    assertEquals(2, count[0]);
  }

  /** Of nextInt(4) and nextInt(8) by a half it turns by nothing and goes on at 0.15 + 0.425. */
  @Test
  void arcs_areDrawnInTheirRanges() {
    Driver arcs = Driver.draw(Driver.Kind.ARCS, LIMITS, new FixedChance(0.5));
    assertEquals(0.5 * 0.575, arcs.next(0).vMPerS(), NEAR);
    assertEquals(0, arcs.next(0).wRadPerS(), NEAR);
    Driver back = Driver.draw(Driver.Kind.ARCS, LIMITS, new FixedChance(0.1));
    assertEquals(0, back.next(0).wRadPerS());
    assertEquals(0.5 * -0.56, back.next(0).vMPerS(), NEAR);
    Driver quick = Driver.draw(Driver.Kind.ARCS, LIMITS, new FixedChance(0.9));
    assertEquals(1.6, quick.next(0).wRadPerS(), NEAR);
    assertEquals(0.5 * 0.915, quick.next(0).vMPerS(), NEAR);
  }

  /** 20 to the power of minus a half, forward and left. */
  @Test
  void creeping_isOverAFactorOfTwenty() {
    Driver creep = Driver.draw(Driver.Kind.CREEP, LIMITS, new FixedChance(0.5));
    assertEquals(0.5 / Math.sqrt(20), creep.next(0).vMPerS(), NEAR);
    assertEquals(2 / Math.sqrt(20), creep.next(0).wRadPerS(), NEAR);
    Driver right = Driver.draw(Driver.Kind.CREEP, LIMITS, new FixedChance(0.5).coins(false));
    assertEquals(-2 / Math.sqrt(20), right.next(0).wRadPerS(), NEAR);
    Driver back = Driver.draw(Driver.Kind.CREEP, LIMITS, new FixedChance(0.1));
    assertEquals(-0.5 * Math.pow(20, -0.1), back.next(0).vMPerS(), NEAR);
    assertEquals(0, back.next(0).wRadPerS(), "straight by chance");
  }

  private static void assertPiece(double v, double w, double whileS, Driver.Piece piece) {
    assertEquals(v, piece.v(), NEAR);
    assertEquals(w, piece.w(), NEAR);
    assertEquals(whileS, piece.whileS(), NEAR);
  }

  private static Driver.Piece make(Driver.Maker maker, double chance) {
    return maker.make(new FixedChance(chance));
  }

  @Test
  void stopAndGo_goesAndStops() {
    Driver.StopAndGo maker = new Driver.StopAndGo();
    assertPiece(0.65, 0, 1.9, make(maker, 0.5));
    assertPiece(0, 0, 0.4 + 1.4 * 0.5, make(maker, 0.5));
    Driver.Piece back = make(maker, 0.1);
    assertEquals(-0.5, back.v());
    assertEquals(-0.3 + 0.06, back.w(), NEAR);
    Driver.Piece spot = make(maker, 0.1);
    assertEquals(0, spot.v());
    assertEquals(-0.8, spot.w(), NEAR);
    assertEquals(0.51, spot.whileS(), NEAR);
    assertTrue(make(maker, 0.9).v() > 0.9);
  }

  /** A corner is a right angle: w times the limit for so long. */
  @Test
  void squares_haveRightAngles() {
    Driver.Squares squares = new Driver.Squares(LIMITS, new FixedChance(0.5));
    int hands = 0;
    double last = 1;
    for (int i = 0; i < 64; i++) {
      Driver.Piece piece = make(squares, 0.5);
      if (i % 2 == 0) {
        assertPiece(0.7, 0, 4, piece);
      } else {
        assertEquals(0, piece.v());
        assertEquals(Math.PI / 2, Math.abs(piece.w()) * 2 * piece.whileS(), NEAR);
        hands += piece.w() * last < 0 ? 1 : 0;
        last = piece.w();
      }
    }
    assertEquals(4, hands, "every sixteen pieces the other way round");
    assertPiece(-0.35, 0, 4, make(squares, 0.1));
  }

  @Test
  void shuttle_goesForthAndBack() {
    Driver.Shuttle shuttle = new Driver.Shuttle();
    assertPiece(-0.65, 0, 2.5, make(shuttle, 0.5));
    assertPiece(0.65, 0, 2.5, make(shuttle, 0.5));
    assertEquals(-0.4 + 0.08, make(shuttle, 0.1).w(), NEAR);
  }

  /** Noise that says 1 makes 1 at first and k + sqrt(1 - k^2) a step later; T is 1.9 s. */
  @Test
  void wandering_isAboutAMean() {
    Driver driver =
        Driver.draw(Driver.Kind.WANDER, LIMITS, new FixedChance(0.5).gaussian(1, -1, 1, -1));
    double k = Math.exp(-10);
    double first = Math.sqrt(1 - k * k);
    assertEquals(0.5 * (0.5 + 0.25 * first), driver.next(3).vMPerS(), NEAR);
    double keep = Math.exp(-0.1 / 1.9);
    double second = keep * first + Math.sqrt(1 - keep * keep);
    Speeds now = driver.next(3.1);
    assertEquals(0.5 * (0.5 + 0.25 * second), now.vMPerS(), NEAR);
    assertEquals(2 * -0.45 * second, now.wRadPerS(), NEAR);
  }

  /** A hand of 0.225 s goes from the first stick to the next by exp(-dt / T). */
  @Test
  void joystick_takesAWhile() {
    // The hand, then pieces: not to the stop, at 0.25; turning; for 1.5 s; then all the way.
    FixedChance chance = new FixedChance(0.5, 0.5, 0.5, 0.5, 0.95, 0.5, 0.1, 0.1, 0.5);
    Driver driver = Driver.draw(Driver.Kind.JOYSTICK, LIMITS, chance);
    Speeds first = driver.next(0);
    assertEquals(0.125, first.vMPerS(), NEAR);
    assertEquals(2 * 0.99, first.wRadPerS(), NEAR);
    double keep = Math.exp(-0.5 / 0.225);
    Speeds second = driver.next(0.5);
    // The stop is at 1; of turning nothing is wanted any more.
    assertEquals(0.5 * (1 + keep * (0.25 - 1)), second.vMPerS(), NEAR);
    assertEquals(2 * keep * 0.99, second.wRadPerS(), NEAR);
    assertEquals(0, driver.next(1.4).wRadPerS(), "a stick in the middle is not played with");
  }

  /** At 0.65 of the limit, with a swing of 0.525 times 0.75 that changes sides each half period. */
  @Test
  void edge_isHunted() {
    Driver hard = Driver.draw(Driver.Kind.EDGE, LIMITS, new FixedChance(0.5));
    double swing = 2 * 0.75 * 0.525;
    assertEquals(0.325, hard.next(0.1).vMPerS(), NEAR);
    assertEquals(swing, hard.next(0.1).wRadPerS(), NEAR);
    assertEquals(-swing, hard.next(1).wRadPerS(), NEAR);
    Driver soft = Driver.draw(Driver.Kind.EDGE, LIMITS, new FixedChance(0.5).coins(false));
    assertEquals(swing * Math.sin(2 * Math.PI * 0.1 / 1.8), soft.next(0.1).wRadPerS(), NEAR);
    Driver corner = Driver.draw(Driver.Kind.EDGE, LIMITS, new FixedChance(0.1));
    assertEquals(1.8, corner.next(1).wRadPerS(), NEAR);
    assertEquals(0.5 * 0.45 * 0.5, corner.next(1).vMPerS(), NEAR);
  }

  @Test
  void slalom_swings() {
    Driver driver = Driver.draw(Driver.Kind.SLALOM, LIMITS, new FixedChance(0.5));
    double period = 3.75;
    assertEquals(0.325, driver.next(0).vMPerS(), NEAR);
    assertEquals(0, driver.next(0).wRadPerS(), NEAR);
    assertEquals(1.3, driver.next(period / 4).wRadPerS(), NEAR);
    assertEquals(-1.3, driver.next(3 * period / 4).wRadPerS(), NEAR);
    assertEquals(9, Driver.kinds().size());
  }
}
