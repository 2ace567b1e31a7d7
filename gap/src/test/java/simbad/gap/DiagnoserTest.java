package simbad.gap;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.gap.diagnosis.DataSet;
import simbad.gap.diagnosis.Diagnosis;
import simbad.gap.diagnosis.EffectFinding;
import simbad.gap.diagnosis.Verdict;
import simbad.gap.fixture.Worlds;
import simbad.sonar.effect.Definitions;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.ReadingsFile;
import simbad.sonar.format.SceneFile;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.Reading;
import simbad.sonar.sensing.ReadingRow;

/** Data sets whose truth is known: src/test/resources/practice/README.md. */
class DiagnoserTest {
  private static Optional<Diagnosis> soundSpeed = Optional.empty();

  private static DataSet practice(String id) throws URISyntaxException, DataFormatException {
    Path folder =
        Path.of(Objects.requireNonNull(DiagnoserTest.class.getResource("/practice/" + id)).toURI());
    Path reference = folder.resolve("reference.csv");
    return new DataSet(
        id,
        SceneFile.read(folder.resolve("scene.json")),
        ReadingsFile.read(folder.resolve("readings.csv")),
        Files.exists(reference) ? ReadingsFile.read(reference) : List.of());
  }

  private static Diagnosis diagnosed(String id, Effect... withheld) throws Exception {
    return new Diagnoser(1, Set.of(withheld)).diagnose(practice(id));
  }

  private static double fitted(Diagnosis diagnosis, Effect effect) {
    return finding(diagnosis, effect).parameters().get(0).value();
  }

  private static EffectFinding finding(Diagnosis diagnosis, Effect effect) {
    return diagnosis.effects().stream()
        .filter(finding -> finding.effect() == effect)
        .findFirst()
        .orElseThrow();
  }

  /** Of one world, made once: it takes seconds. */
  private static synchronized Diagnosis soundSpeed() throws Exception {
    if (soundSpeed.isEmpty()) {
      soundSpeed = Optional.of(diagnosed("p010"));
    }
    return soundSpeed.orElseThrow();
  }

  @Test
  void saysNoneWhereNothingWasPutIn() throws Exception {
    Diagnosis diagnosis = diagnosed("p005");
    assertEquals(Verdict.NONE, diagnosis.verdict());
    assertEquals(List.of(), diagnosis.explanation());
    assertEquals(0, diagnosis.gap().shrink(), 1e-9);
  }

  @Test
  void namesOneEffectAndItsSize() throws Exception {
    Diagnosis diagnosis = soundSpeed();
    assertEquals(Verdict.EXPLAINED, diagnosis.verdict());
    assertEquals(List.of(Effect.SOUND_SPEED), diagnosis.explanation());
    assertEquals(353.671, fitted(diagnosis, Effect.SOUND_SPEED), 0.5);
    assertEquals(Definitions.effects().size(), diagnosis.effects().size());
    assertTrue(diagnosis.gap().shrink() > 0.3, () -> "shrink " + diagnosis.gap());
    assertTrue(diagnosis.gap().shrinkCi95().low() > 0, () -> "interval " + diagnosis.gap());
  }

  @Test
  void namesTwoEffectsAtOnce() throws Exception {
    Diagnosis diagnosis = diagnosed("p012");
    assertEquals(Verdict.EXPLAINED, diagnosis.verdict());
    assertEquals(
        Set.of(Effect.BEAM_WIDTH, Effect.SOUND_SPEED), new TreeSet<>(diagnosis.explanation()));
    assertEquals(3.024, fitted(diagnosis, Effect.BEAM_WIDTH), 0.4);
  }

  @Test
  void calibratesOnTheReference() throws Exception {
    Diagnosis diagnosis = diagnosed("q004");
    assertEquals(Verdict.EXPLAINED, diagnosis.verdict());
    assertEquals(List.of(Effect.BEAM_WIDTH), diagnosis.explanation());
    assertFalse(diagnosis.calibration().forms().isEmpty());
  }

  @Test
  @Tag("full")
  void doesNotExplainWhatItsVocabularyLacks() throws Exception {
    Diagnosis diagnosis =
        diagnosed("p012", Effect.SOUND_SPEED, Effect.RANGE_OFFSET, Effect.MULTIPATH);
    assertFalse(diagnosis.explanation().contains(Effect.SOUND_SPEED));
    assertTrue(
        Set.of(Verdict.UNEXPLAINED, Verdict.PARTLY).contains(diagnosis.verdict()),
        "what stands in for it leaves a rest: " + diagnosis.verdict());
  }

  @Test
  void saysTheSameTwice() throws Exception {
    assertEquals(soundSpeed().fitted(), diagnosed("p010").fitted());
  }

  @Test
  void saysUndecidedOfTooFewRows() throws Exception {
    DataSet all = practice("p010");
    List<ReadingRow> one = all.readings().subList(0, 1);
    Diagnosis diagnosis =
        new Diagnoser(1, Set.of()).diagnose(new DataSet("one", all.setup(), one, List.of()));
    assertEquals(Verdict.UNDECIDED, diagnosis.verdict());
    assertEquals(List.of(), diagnosis.explanation());
    assertTrue(diagnosis.reason().startsWith("there are too few readings: 1,"), diagnosis.reason());
    assertTrue(Double.isInfinite(diagnosis.gap().shrinkCi95().low()), "nothing is known of it");
  }

  /** Stored with a wrong constant: the noise and the steps are scaled with the ranges. */
  @Test
  void namesSoundSpeedWhereAllReadingsAreTheSameShareOfTheTruth() throws Exception {
    for (double share : new double[] {0.64, 5}) {
      Diagnosis diagnosis = new Diagnoser(1, Set.of()).diagnose(multiplied("p005", share));
      assertEquals(Verdict.EXPLAINED, diagnosis.verdict(), () -> share + ": " + diagnosis.fitted());
      assertEquals(List.of(Effect.SOUND_SPEED), diagnosis.explanation());
      assertEquals(343 / share, fitted(diagnosis, Effect.SOUND_SPEED), 0.02 * 343 / share);
    }
  }

  /** Beyond all that is searched: it fits as well as can be, and explains nothing. */
  @Test
  void explainsNothingByAValueAtTheEndOfTheSearch() throws Exception {
    Diagnosis diagnosis = new Diagnoser(1, Set.of()).diagnose(multiplied("p005", 9));
    assertEquals(Verdict.UNEXPLAINED, diagnosis.verdict());
    assertEquals(Effect.SOUND_SPEED, diagnosis.atBound().get(0).effect());
    assertTrue(diagnosis.reason().contains("is at the end of the range that was searched"));
  }

  /** A cable that is off, a dead amplifier, a target that was taken away: all read the same. */
  @Test
  void saysUndecidedWhereNoPingHasAnEcho() throws Exception {
    DataSet heard = practice("p005");
    List<ReadingRow> silent = new ArrayList<>();
    for (ReadingRow row : heard.readings().subList(0, 300)) {
      silent.add(new ReadingRow(row.run(), row.sensor(), row.timeS(), row.pose(), NoEcho.NO_ECHO));
    }
    Diagnosis diagnosis =
        new Diagnoser(1, Set.of())
            .diagnose(new DataSet("silent", heard.setup(), silent, List.of()));
    assertEquals(Verdict.UNDECIDED, diagnosis.verdict());
    assertTrue(diagnosis.reason().contains("no ping of this log has an echo"), diagnosis.reason());
    assertTrue(diagnosis.gap().beforeCm() > 0, "the simulator hears something there");
  }

  @Test
  void pingsThatAreSecondsApartAreDiagnosed() throws Exception {
    DataSet quick = practice("p005");
    List<ReadingRow> slow = new ArrayList<>();
    for (ReadingRow row : quick.readings().subList(0, 300)) {
      slow.add(
          new ReadingRow(row.run(), row.sensor(), 50 * row.timeS(), row.pose(), row.reading()));
    }
    SensingSetup setup = Worlds.withUpdatePeriod(quick.setup(), 5);
    Diagnosis diagnosis =
        new Diagnoser(1, Set.of()).diagnose(new DataSet("slow", setup, slow, List.of()));
    assertEquals(Verdict.NONE, diagnosis.verdict());
  }

  private static DataSet multiplied(String id, double share) throws Exception {
    DataSet all = practice(id);
    List<ReadingRow> rows = new ArrayList<>();
    for (ReadingRow row : all.readings().subList(0, 500)) {
      Reading reading =
          row.reading() instanceof Echo echo ? new Echo(share * echo.rangeM()) : row.reading();
      rows.add(new ReadingRow(row.run(), row.sensor(), row.timeS(), row.pose(), reading));
    }
    return new DataSet(id, all.setup(), rows, List.of());
  }
}
