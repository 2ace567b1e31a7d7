package simbad.blindworld.wavechange;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.blindworld.wave.Alteration;
import simbad.blindworld.wave.FixedEcho;
import simbad.blindworld.wave.Gear;
import simbad.blindworld.wave.WaveWorld;
import simbad.blindworld.world.FixedChance;
import simbad.blindworld.world.Pose;
import simbad.blindworld.world.Recording;
import simbad.blindworld.world.Row;

/**
 * Which laws lose the same echoes, by odds of 100 to 1, which are 4.605 nats. Every row hears one
 * echo whose level over the threshold is known; a transducer's label says what a change makes of
 * it, in decibels. Heard and lost rows are so by 0.99.
 *
 * <p>A lost row costs a law that has it heard 0.01 ln(0.01/0.99) + 0.99 ln(0.99/0.01) = 4.503 nats.
 */
class RivalsTest {

  private static final String HEARD = "0";
  private static final String LOST = "-90";
  private static final Set<String> GAIN = Set.of("gain");
  private static final Set<String> ABSORPTION = Set.of("absorption");
  private static final Set<String> TIMEOUT = Set.of("early-timeout");

  /** The threshold is the same at all times, so that an echo's level is that of its peak. */
  private static final Gear FLAT =
      WaveGround.GEAR.with(new Gear.Receiver(0.004, 0.004, 1, 0.0005, 0.03, 0.0003));

  private static final WaveEffect BY_LABEL =
      WaveEffect.of(
          "by-label",
          Map.of(),
          new Alteration() {
            @Override
            public Gear gear(String sensor, Gear gear) {
              return gear.louder(Double.parseDouble(sensor));
            }
          });

  /** So many rows at a distance from the box, with a label. */
  private record Rows(int count, double distanceM, String label) {}

  private static List<Set<String>> rivals(String name, double excessDb, Rows... groups) {
    List<Row> rows = new ArrayList<>();
    for (Rows group : groups) {
      for (int i = 0; i < group.count; i++) {
        rows.add(new Row("r", group.label, rows.size(), new Pose(-group.distanceM, 0, 0)));
      }
    }
    // 233 whole periods after the trigger, so that no peak falls between two of them.
    FixedEcho echo = new FixedEcho(233 * 343.2 / 80_000, excessDb, 0);
    WaveWorld.Parts parts =
        new WaveWorld.Parts(FLAT, WaveGround.AIR, WaveGround.PARTS.counter(), 0, List.of(echo));
    Site site =
        new Site(
            WaveGround.ROOM,
            parts,
            WaveGround.SCENE,
            new Recording(rows),
            true,
            WaveGround.HEARD,
            new FixedChance(0.5),
            1);
    WaveEffect effect =
        new WaveEffect(name, Map.of(), BY_LABEL.alteration(), BY_LABEL.accept(), BY_LABEL.also());
    return Rivals.of(effect, site);
  }

  @Test
  void nothingChanged_isASmallChangeOfEach() {
    assertEquals(List.of(GAIN, ABSORPTION, TIMEOUT), rivals("x", 10, new Rows(50, 1, HEARD)));
  }

  @Test
  void ownName_isNoRival() {
    assertEquals(List.of(ABSORPTION, TIMEOUT), rivals("gain", 10, new Rows(5, 1, HEARD)));
    assertEquals(List.of(GAIN, TIMEOUT), rivals("absorption", 10, new Rows(5, 1, HEARD)));
    assertEquals(List.of(GAIN, ABSORPTION), rivals("early-timeout", 10, new Rows(5, 1, HEARD)));
  }

  /**
   * Half of the rows are lost and nothing tells them apart: the best gain hears a half of each, and
   * costs 0.99 ln(0.99/0.5) + 0.01 ln(0.01/0.5) = 0.637 nats a row. A time-out cannot hear a half.
   */
  @ParameterizedTest
  @CsvSource({"1, true, true", "2, true, false", "3, true, false", "4, false, false"})
  void lostRows_countByTheirOdds(int lost, boolean gain, boolean timeout) {
    List<Set<String>> same = rivals("x", 10, new Rows(lost, 1, LOST), new Rows(lost, 1, HEARD));
    assertEquals(gain, same.contains(GAIN));
    assertEquals(gain, same.contains(ABSORPTION));
    assertEquals(timeout, same.contains(TIMEOUT));
  }

  /** The far ones are lost: by 2 dB a metre more of the way, or after a time. */
  @Test
  void farRowsLost_areOfTheAirOrTheTime() {
    List<Set<String>> same = rivals("x", 10, new Rows(20, 0.5, HEARD), new Rows(20, 1.5, LOST));
    assertEquals(List.of(ABSORPTION, TIMEOUT), same);
  }

  @Test
  void nearRowsLost_areOfNoneOfThem() {
    assertEquals(List.of(), rivals("x", 10, new Rows(20, 0.5, LOST), new Rows(20, 1.5, HEARD)));
  }

  /** All of them fainter by the same, whatever the distance: a gain. */
  @Test
  void fainterEverywhere_isAGain() {
    List<Set<String>> same = rivals("x", 4, new Rows(20, 0.3, "-4"), new Rows(20, 2.5, "-4"));
    assertEquals(List.of(GAIN), same);
  }

  /**
   * A logistic of 0.7 dB over 1.7: at 0.4524 dB under the threshold a quarter is heard. A time-out
   * loses all of them, 0.25 ln 25 + 0.75 ln(0.75/0.99) = 0.597 nats a row: 4.18 for seven.
   */
  @ParameterizedTest
  @CsvSource({"7, true", "8, false"})
  void chance_isALogisticOfTheLevel(int count, boolean same) {
    double quarter = 0.7 / 1.7 * Math.log(3);
    String label = Double.toString(-10 - quarter);
    assertEquals(same, rivals("x", 10, new Rows(count, 1, label)).contains(TIMEOUT));
  }

  /** At the threshold a half is heard: 0.5 ln 50 + 0.5 ln(0.5/0.99) = 1.614 nats a row. */
  @ParameterizedTest
  @CsvSource({"2, true", "3, false"})
  void atTheThreshold_aHalfIsHeard(int count, boolean same) {
    assertEquals(same, rivals("x", 10, new Rows(count, 1, "-10")).contains(TIMEOUT));
  }

  /** A gain of 20 dB less at most: of 25 dB nothing is lost by it, of 15 dB all. */
  @Test
  void gains_endAtTwentyDecibels() {
    assertFalse(rivals("x", 25, new Rows(3, 1, LOST)).contains(GAIN));
    assertTrue(rivals("x", 15, new Rows(3, 1, LOST)).contains(GAIN));
    // 15 dB more at most: from 5 dB under the threshold it is heard, from 17 dB not.
    assertTrue(rivals("x", -5, new Rows(3, 1, "9")).contains(GAIN));
    assertFalse(rivals("x", -17, new Rows(3, 1, "30")).contains(GAIN));
  }

  /** 8 dB a metre at most, out and back: 16 dB over a metre. And 3 dB a metre less. */
  @Test
  void absorptions_endAtEightDecibels() {
    assertTrue(rivals("x", 14, new Rows(3, 1, LOST)).contains(ABSORPTION));
    assertFalse(rivals("x", 18, new Rows(3, 1, LOST)).contains(ABSORPTION));
    assertTrue(rivals("x", -5, new Rows(3, 1, "9")).contains(ABSORPTION));
    assertFalse(rivals("x", -5, new Rows(3, 0.6, "9")).contains(ABSORPTION));
  }

  /** From 0.2 to 4 m. */
  @Test
  void timeouts_endWhereRangesDo() {
    assertTrue(rivals("x", 10, new Rows(3, 0.25, LOST)).contains(TIMEOUT));
    assertFalse(rivals("x", 10, new Rows(3, 0.15, LOST)).contains(TIMEOUT));
    assertTrue(rivals("x", 10, new Rows(3, 3.95, HEARD)).contains(TIMEOUT));
    assertFalse(rivals("x", 10, new Rows(3, 4.05, HEARD)).contains(TIMEOUT));
  }

  /** Rows of more than 6 dB under the threshold before and after say nothing. */
  @Test
  void silentRows_sayNothing() {
    List<Set<String>> all = List.of(GAIN, ABSORPTION, TIMEOUT);
    assertEquals(all, rivals("x", -7, new Rows(900, 1, HEARD)));
    assertEquals(all, rivals("x", -7, new Rows(900, 1, "0.9")));
  }
}
