package simbad.gap;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.gap.audit.Audit;
import simbad.gap.audit.AuditFinding;
import simbad.gap.audit.NumbersForNoEcho;
import simbad.gap.diagnosis.DataSet;
import simbad.gap.diagnosis.Diagnosis;
import simbad.gap.diagnosis.Verdict;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.Worlds;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;

/** A driver that writes 4 m, which no echo counts as, where nothing was heard. */
class SilentNumbersTest {
  private static final SensingSetup SETUP = Worlds.POST;
  private static final int ROWS = 700;

  /** Half of these poses are nearer than the threshold of 1.5 m. */
  private static List<ReadingRow> read(Hypothesis truth) {
    return Worlds.read(Worlds.poses(ROWS, 0.3, 2.7, 11), truth, 12);
  }

  private static List<ReadingRow> written(List<ReadingRow> rows, double numberM) {
    List<ReadingRow> written = new ArrayList<>();
    for (ReadingRow row : rows) {
      boolean silent = row.reading() instanceof NoEcho;
      written.add(silent ? row.reading(new Echo(numberM)) : row);
    }
    return written;
  }

  private static List<AuditFinding> audit(List<ReadingRow> rows) {
    return Audit.of(SETUP, rows, List.of());
  }

  private static Set<Integer> numbers(List<ReadingRow> rows) {
    return NumbersForNoEcho.rows(SETUP, rows, audit(rows), AuditFinding.File.READINGS);
  }

  private static Diagnosis diagnosis(List<ReadingRow> rows) {
    return new Diagnoser(1, Set.of())
        .diagnose(new DataSet("log", SETUP, rows, List.of()), audit(rows));
  }

  /** They are no gap: it was "unexplained", since nothing that made one was found. */
  @Test
  void logThatReadsThem_isAsOneWithoutEchoesThere() {
    List<ReadingRow> rows = read(Hypothesis.NONE);
    long silent = rows.stream().filter(row -> row.reading() instanceof NoEcho).count();
    Diagnosis diagnosis = diagnosis(written(rows, 4));
    assertEquals(Verdict.UNDECIDED, diagnosis.verdict(), diagnosis.reason());
    assertTrue(
        diagnosis.reason().startsWith(silent + " of " + ROWS + " readings are a number"),
        diagnosis.reason());
    assertEquals(diagnosis(rows).gap().beforeCm(), diagnosis.gap().beforeCm(), 1e-12);
  }

  @Test
  void effectBesideThem_isNamedAsWithout() {
    List<ReadingRow> rows = read(Worlds.effect(Effect.RANGE_OFFSET, "constant", 0.06));
    Diagnosis plain = diagnosis(rows);
    assertEquals(List.of(Effect.RANGE_OFFSET), plain.explanation());
    Diagnosis numbered = diagnosis(written(rows, 4));
    assertEquals(plain.verdict(), numbered.verdict());
    assertEquals(plain.explanation(), numbered.explanation());
    assertEquals(plain.gap(), numbered.gap());
  }

  /** Another number makes a gap, and what should be heard and is lost does. */
  @Test
  void otherNumbers_andLostEchoes_areLeftToTheEffects() {
    List<ReadingRow> rows = read(Hypothesis.NONE);
    List<ReadingRow> nought = written(rows, 0);
    assertEquals(Set.of(), numbers(nought));
    assertEquals(Set.of(), numbers(rows));
    List<ReadingRow> lost = new ArrayList<>();
    List<ReadingRow> near = Worlds.read(Worlds.poses(ROWS, 0.3, 1.2, 13), Hypothesis.NONE, 14);
    for (int i = 0; i < near.size(); i++) {
      lost.add(i % 5 == 0 ? near.get(i).reading(new Echo(4)) : near.get(i));
    }
    assertTrue(!audit(lost).isEmpty(), "the audit finds it");
    assertEquals(Set.of(), numbers(lost));
  }

  /** What the driver wrote while the simulation was trusted belongs to the set-up. */
  @Test
  void numbersThatTheReferenceHasToo_areNone() {
    List<ReadingRow> rows = read(Hypothesis.NONE);
    List<ReadingRow> before = Worlds.read(Worlds.poses(ROWS, 0.3, 2.7, 15), Hypothesis.NONE, 16);
    Diagnosis plain = diagnosis(rows, before);
    assertEquals(Verdict.NONE, plain.verdict(), plain.reason());
    Diagnosis numbered = diagnosis(written(rows, 4), written(before, 4));
    assertEquals(Verdict.NONE, numbered.verdict(), numbered.reason());
    assertEquals(plain.gap(), numbered.gap());
    assertEquals(
        Verdict.UNDECIDED, diagnosis(written(rows, 4), before).verdict(), "the driver is new");
  }

  private static Diagnosis diagnosis(List<ReadingRow> rows, List<ReadingRow> before) {
    return new Diagnoser(1, Set.of())
        .diagnose(new DataSet("log", SETUP, rows, before), Audit.of(SETUP, rows, before));
  }
}
