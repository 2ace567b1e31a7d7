package simbad.blindworld.wavechange;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import simbad.blindworld.design.Design;
import simbad.blindworld.effect.Vocabulary;
import simbad.blindworld.wave.WaveWorld;
import simbad.blindworld.wavesetup.Room;
import simbad.blindworld.wavesetup.User;
import simbad.blindworld.world.Chance;
import simbad.blindworld.world.Recording;

/** Every change, on a bench with a round and an edged thing that is taken for a robot. */
class EveryChangeTest {

  private static final int ROWS = 500;

  private record Ground(
      Room room,
      User.Calibration found,
      WaveWorld.Parts parts,
      Recording rows,
      List<Double> readings) {

    double[] plain() {
      return readings.stream().mapToDouble(Double::doubleValue).toArray();
    }
  }

  private static final Ground ground = ground(0);

  /** The first room from a seed on in which every change can happen and a third is heard. */
  private static Ground ground(int from) {
    for (int seed = from; ; seed++) {
      Chance random = new Chance(seed);
      Room room = Room.draw(random);
      boolean mixed =
          room.articles().stream().anyMatch(a -> a.isRound())
              && room.articles().stream().anyMatch(a -> !a.isRound());
      if (mixed) {
        User.Calibration found = new User(room, random.split()).calibrate(0.1);
        boolean uniform = found.scene().obstacles().stream().anyMatch(o -> o.shadow().isUniform());
        Recording rows =
            Design.draw("bench", random.split()).record(found.scene(), ROWS, random.split());
        WaveWorld.Parts parts = room.parts().with(found.counter());
        double[] plain = new WaveWorld(parts, List.of()).at(rows).read(1);
        if (uniform && Site.heard(plain).size() > plain.length / 4) {
          return new Ground(room, found, parts, rows, Arrays.stream(plain).boxed().toList());
        }
      }
    }
  }

  @BeforeAll
  static void everyChangeCanHappen() {
    for (String name : names()) {
      assertTrue(WaveVocabulary.applies(name, site(1, 0)), name);
    }
  }

  private static Site site(double size, long seed) {
    return new Site(
        ground.room,
        ground.parts,
        ground.found.scene(),
        ground.rows,
        true,
        Site.heard(ground.plain()),
        new Chance(seed),
        size);
  }

  static List<String> names() {
    List<String> names = new ArrayList<>(WaveVocabulary.names());
    names.addAll(WaveVocabulary.outside());
    return names;
  }

  private static double[] read(WaveEffect effect) {
    return new WaveWorld(ground.parts, List.of(effect.alteration())).at(ground.rows).read(1);
  }

  private static int heard(double[] readings) {
    return Site.heard(readings).size();
  }

  @Test
  void names_areOfTheVocabularyAndOutsideIt() {
    assertTrue(WaveVocabulary.names().size() >= 24, WaveVocabulary.names().toString());
    assertTrue(WaveVocabulary.outside().size() >= 8, WaveVocabulary.outside().toString());
    assertTrue(Vocabulary.contains("wave-hop"));
    assertFalse(Vocabulary.contains("wind"));
    assertEquals(names().size(), new HashSet<>(names()).size());
  }

  /** A change of four times the practical size changes readings, and may be called by its name. */
  @ParameterizedTest
  @MethodSource("names")
  void change_showsAndIsCalledByItsName(String name) {
    WaveEffect effect = WaveVocabulary.draw(name, site(4, 2));
    assertEquals(name, effect.name());
    assertTrue(effect.accept().contains(Set.of(name)), effect.accept().toString());
    assertFalse(effect.also().contains(Set.of(name)), effect.also().toString());
    assertNotEquals(Arrays.toString(ground.plain()), Arrays.toString(read(effect)));
    for (Set<String> names : effect.accept()) {
      assertTrue(
          names.equals(Set.of(name)) || Vocabulary.contains(names.iterator().next()),
          names.toString());
    }
  }

  /** The same chance draws the same change. */
  @ParameterizedTest
  @MethodSource("names")
  void sameSeed_drawsTheSame(String name) {
    WaveEffect one = WaveVocabulary.draw(name, site(1, 5));
    WaveEffect other = WaveVocabulary.draw(name, site(1, 5));
    assertEquals(one.parameters(), other.parameters());
    // An unsorted map's order is another one in each process.
    List<String> keys = List.copyOf(one.parameters().keySet());
    assertEquals(keys.stream().sorted().toList(), keys);
    assertEquals(one.accept(), other.accept());
    assertEquals(Arrays.toString(read(one)), Arrays.toString(read(other)));
  }

  /** What weakens echoes or drops them leaves fewer, whatever the seed. */
  @ParameterizedTest
  @CsvSource({"early-timeout", "dead-zone", "dropout", "wet-membrane", "supply-voltage"})
  void whatLosesEchoes_leavesFewer(String name) {
    for (int seed = 0; seed < 3; seed++) {
      int left = heard(read(WaveVocabulary.draw(name, site(2, seed))));
      assertTrue(left < heard(ground.plain()), name + ": " + left + " of " + heard(ground.plain()));
    }
  }

  private static double number(WaveEffect effect, String name) {
    return Double.parseDouble(String.valueOf(effect.parameters().get(name)));
  }

  @Test
  void sizeOfAGain_isItsDecibels() {
    WaveEffect gain = WaveVocabulary.draw("gain", site(2, 1));
    assertEquals(7, Math.abs(number(gain, "db")), 1e-9);
    WaveEffect offset = WaveVocabulary.draw("range-offset", site(1, 1));
    double m = number(offset, "m");
    double[] longer = read(offset);
    double step = ground.found.counter().resolutionM();
    for (int row = 0; row < longer.length; row++) {
      if (ground.readings.get(row) < Double.POSITIVE_INFINITY) {
        assertEquals(Math.max(0, ground.readings.get(row) + m), longer[row], step + 1e-9);
      }
    }
  }

  /** Warmer air by so many kelvin is faster by c/2T each, and every range shorter by that. */
  @Test
  void warmAir_scalesRanges() {
    WaveEffect warm = WaveVocabulary.draw("sound-speed", site(1, 3));
    double before = ground.parts.air().soundSpeedMPerS();
    double factor = before / number(warm, "c");
    double[] readings = read(warm);
    double sum = 0;
    double plain = 0;
    for (int row = 0; row < readings.length; row++) {
      if (Math.max(readings[row], ground.readings.get(row)) < Double.POSITIVE_INFINITY
          && Math.abs(readings[row] / ground.readings.get(row) - 1) < 0.1) {
        sum += readings[row];
        plain += ground.readings.get(row);
      }
    }
    assertEquals(factor, sum / plain, 0.012);
  }

  /** A change of a hundredth changes no more rows than other noise does. */
  @Test
  void smallGain_losesNextToNothing() {
    WaveEffect small = WaveVocabulary.draw("gain", site(0.01, 1));
    double[] readings = read(small);
    double[] noise = new WaveWorld(ground.parts, List.of()).at(ground.rows).read(2);
    int differ = differing(readings);
    int byNoise = differing(noise);
    assertTrue(
        differ < byNoise + 4 * Math.sqrt(byNoise), differ + " rows differ, by noise " + byNoise);
    assertTrue(byNoise < 0.1 * readings.length, byNoise + " rows differ by noise");
  }

  private static int differing(double[] readings) {
    int differ = 0;
    for (int row = 0; row < readings.length; row++) {
      differ += Math.abs(heardOr(readings[row]) - heardOr(ground.readings.get(row))) > 0.05 ? 1 : 0;
    }
    return differ;
  }

  private static double heardOr(double reading) {
    return Math.min(9, reading);
  }
}
