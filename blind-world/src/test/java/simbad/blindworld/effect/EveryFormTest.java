package simbad.blindworld.effect;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import simbad.blindworld.design.Design;
import simbad.blindworld.design.Scenes;
import simbad.blindworld.world.Chance;
import simbad.blindworld.world.Obstacle;
import simbad.blindworld.world.Recording;
import simbad.blindworld.world.Scene;
import simbad.blindworld.world.Setup;
import simbad.blindworld.world.World;

/** Every form of every effect: at size 0 it changes no reading, at a practical size it does. */
class EveryFormTest {

  private static final int ROWS = 2000;
  private static final long SEED = 77;
  private static final double PLAIN_SHARE = 0.004;
  private static final String STALE = "previous-ping";

  private static Scene scene = drawScene(0);
  private static Recording recording = new Recording(List.of());
  private static Recording fast = new Recording(List.of());
  private static Recording placed = new Recording(List.of());

  /**
   * A robot with several sonars before a uniform obstacle and one with a table, and echoes enough.
   */
  @BeforeAll
  static void findRecordings() {
    for (int from = 0; !hasARecording(); from++) {
      if (from == 100) {
        throw new IllegalStateException("no recording fits");
      }
      scene = drawScene(from);
    }
    findAFastRecording();
    Chance random = new Chance(1);
    placed = Design.placed(random).record(scene, ROWS, random);
  }

  private static boolean hasARecording() {
    for (int seed = 0; seed < 50; seed++) {
      Chance random = new Chance(seed);
      Design design = Design.draw("run", random);
      recording = design.record(scene, ROWS, random);
      Circumstances c = circumstances(1, 1);
      if (c.severalSensors()
          && c.echoShare() > 0.15
          && recording.longestS() > 15
          && hearsTwoAtOnce()) {
        return true;
      }
    }
    return false;
  }

  /** Pings that follow each other so fast that one may hear the one before. */
  private static void findAFastRecording() {
    for (int seed = 0; seed < 500; seed++) {
      Chance random = new Chance(seed);
      fast = Design.draw("run", random).record(scene, ROWS, random);
      Circumstances c = new Circumstances(scene, fast, true, new Chance(1), 1);
      if (c.echoShare() > 0.15 && Vocabulary.applies(STALE, c)) {
        return;
      }
    }
    throw new IllegalStateException("no fast recording fits");
  }

  private static Recording recording(String effect) {
    if (Vocabulary.needsPlacements(effect)) {
      return placed;
    }
    return effect.equals(STALE) ? fast : recording;
  }

  private static boolean hearsTwoAtOnce() {
    Effect second = Vocabulary.draw("second-echo", circumstances(1, 1));
    return !Arrays.equals(read(List.of()), read(List.of(second)));
  }

  private static Scene drawScene(int from) {
    for (int seed = from; ; seed++) {
      Scene drawn = Scenes.draw(new Chance(seed), 0.1);
      List<Obstacle> obstacles = drawn.obstacles();
      boolean mixed =
          obstacles.size() > 1
              && obstacles.stream().anyMatch(o -> o.shadow().isUniform())
              && obstacles.stream().anyMatch(o -> !o.shadow().isUniform());
      if (mixed) {
        return drawn;
      }
    }
  }

  private static Circumstances circumstances(long seed, double strength) {
    return new Circumstances(scene, recording, true, new Chance(seed), strength);
  }

  static Stream<List<String>> forms() {
    List<String> names = new ArrayList<>(Vocabulary.names());
    names.addAll(Vocabulary.further());
    names.addAll(Vocabulary.outside());
    return names.stream()
        .flatMap(name -> Vocabulary.forms(name).stream().map(label -> List.of(name, label)));
  }

  private static double[] read(List<Effect> effects) {
    return read(recording, effects);
  }

  private static double[] read(Recording rows, List<Effect> effects) {
    return new World(
            scene, Setup.nominal(scene.sensor()), effects.stream().map(Effect::change).toList())
        .at(rows)
        .read(SEED);
  }

  private static Circumstances circumstances(List<String> form, long seed, double strength) {
    Recording rows = recording(form.get(0));
    boolean driven = !Vocabulary.needsPlacements(form.get(0));
    return new Circumstances(scene, rows, driven, new Chance(seed), strength);
  }

  @ParameterizedTest
  @MethodSource("forms")
  void atSizeZero_everyReadingIsAsWithout(List<String> form) {
    Effect effect = Vocabulary.draw(form.get(0), form.get(1), circumstances(form, 3, 0));
    Recording rows = recording(form.get(0));
    assertArrayEquals(read(rows, List.of()), read(rows, List.of(effect)), 1e-9);
  }

  @ParameterizedTest
  @MethodSource("forms")
  void atAPracticalSize_readingsDiffer(List<String> form) {
    Recording rows = recording(form.get(0));
    double[] plain = read(rows, List.of());
    double most = 0;
    // A place or a direction drawn by chance may leave a drive alone: the best of a few draws.
    for (int seed = 0; seed < 12 && most <= PLAIN_SHARE; seed++) {
      Effect effect = Vocabulary.draw(form.get(0), form.get(1), circumstances(form, seed, 1.5));
      double[] changed = read(rows, List.of(effect));
      int differ = 0;
      for (int i = 0; i < plain.length; i++) {
        differ += plain[i] == changed[i] ? 0 : 1;
      }
      most = Math.max(most, (double) differ / plain.length);
    }
    assertTrue(most > PLAIN_SHARE, form + ": " + most + " of the readings differ");
  }

  /** Sound goes 43 m there and back in a quarter of a second; no sonar here reaches 11 m. */
  @Test
  void previousPing_needsPingsThatFollowFast() {
    boolean slow = false;
    for (int seed = 0; seed < 60; seed++) {
      Chance random = new Chance(seed);
      Design design = Design.draw("bench", random);
      Recording bench = design.record(scene, 200, random);
      boolean applies =
          Vocabulary.applies(STALE, new Circumstances(scene, bench, false, random, 1));
      slow |= design.periodS() >= 0.25;
      if (design.periodS() >= 0.25) {
        assertTrue(!applies, "at " + design.periodS() + " s");
      } else if (design.periodS() <= 0.05) {
        assertTrue(applies, "at " + design.periodS() + " s");
      }
    }
    assertTrue(slow, "no slow bench was drawn");
  }

  @Test
  void vocabulary_isTheFormats() {
    assertEquals(26, Vocabulary.names().size());
    assertTrue(Vocabulary.outside().size() >= 12, Vocabulary.outside().toString());
    for (String name : Vocabulary.names()) {
      assertTrue(Vocabulary.forms(name).size() >= 2, name + " comes in one form only");
    }
  }

  @Test
  void fairPairs_actAtDifferentStages() {
    assertTrue(Vocabulary.isFairPair("gain", "latency"));
    assertTrue(!Vocabulary.isFairPair("gain", "absorption"));
    assertTrue(!Vocabulary.isFairPair("gain-swing", "gain"));
  }
}
