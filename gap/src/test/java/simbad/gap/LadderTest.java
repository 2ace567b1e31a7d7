package simbad.gap;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.definition.Effect;
import simbad.gap.audit.Audit;
import simbad.gap.audit.AuditCheck;
import simbad.gap.audit.AuditFinding;
import simbad.gap.audit.Severity;
import simbad.gap.diagnosis.DataSet;
import simbad.gap.diagnosis.Diagnosis;
import simbad.gap.diagnosis.EffectFinding;
import simbad.gap.diagnosis.FittedParameter;
import simbad.gap.diagnosis.Interval;
import simbad.gap.diagnosis.Verdict;
import simbad.gap.fixture.Ladders;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.Reading;
import simbad.sonar.sensing.ReadingRow;

/**
 * Faults that people report of their ranges, on a board at ten distances with a tape that is 2 mm
 * off at each: named, and the tape's errors not taken for a wall, a turn or a shift.
 */
class LadderTest {
  private static Diagnosis diagnose(List<ReadingRow> rows) {
    return new Diagnoser(1, Set.of())
        .diagnose(new DataSet("ladder", Ladders.BOARD, rows, List.of()));
  }

  private static Diagnosis explained(Ladders.Fault fault, Effect... by) {
    Diagnosis diagnosis = diagnose(Ladders.read(fault, 1));
    assertEquals(Verdict.EXPLAINED, diagnosis.verdict(), diagnosis.reason());
    assertEquals(Set.of(by), Set.copyOf(diagnosis.explanation()));
    return diagnosis;
  }

  private static double value(Diagnosis diagnosis, Effect effect, String parameter) {
    return parameter(diagnosis, effect, parameter).value();
  }

  private static FittedParameter parameter(Diagnosis diagnosis, Effect effect, String parameter) {
    EffectFinding finding =
        diagnosis.effects().stream().filter(f -> f.effect() == effect).findFirst().orElseThrow();
    return finding.parameters().stream()
        .filter(p -> p.name().equals(parameter))
        .findFirst()
        .orElseThrow();
  }

  @Test
  void clean_isNone() {
    assertEquals(Verdict.NONE, diagnose(Ladders.read((range, lot) -> range, 1)).verdict());
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.2, 1 / 2.54, 0.5, 0.64, 0.97, 2, 2.54, 5})
  void factor_isSoundSpeed(double factor) {
    Diagnosis diagnosis = explained((range, lot) -> factor * range, Effect.SOUND_SPEED);
    double speed = value(diagnosis, Effect.SOUND_SPEED, "sound_speed_m_s");
    assertEquals(343 / factor, speed, 0.005 * 343 / factor);
  }

  /** The commonest fault of all: a scale and a datum. */
  @Test
  void scaleAndOffset_areBothNamed() {
    Diagnosis diagnosis =
        explained((range, lot) -> 0.985 * range - 0.009, Effect.SOUND_SPEED, Effect.RANGE_OFFSET);
    assertEquals(343 / 0.985, value(diagnosis, Effect.SOUND_SPEED, "sound_speed_m_s"), 2);
    assertEquals(-0.009, value(diagnosis, Effect.RANGE_OFFSET, "offset_m"), 0.003);
  }

  /** Steps of a millimetre under 3 mm of noise say nothing: no value follows their beat. */
  @Test
  void intervals_holdScaleAndOffset_whereRangesComeInFineSteps() {
    SensingSetup fine = Ladders.board(0.001, Ladders.TAPE_M, 0);
    int held = 0;
    int named = 0;
    for (int seed = 1; seed <= 6; seed++) {
      List<ReadingRow> rows = Ladders.read((range, lot) -> steps(0.985 * range - 0.009), seed);
      Diagnosis diagnosis =
          new Diagnoser(1, Set.of()).diagnose(new DataSet("ladder", fine, rows, List.of()));
      if (diagnosis.explanation().size() == 2) {
        named += 2;
        // What reads in steps stands for the range at a step's start: half a step more.
        held += holds(diagnosis, Effect.SOUND_SPEED, "sound_speed_m_s", 343 / 0.985);
        held += holds(diagnosis, Effect.RANGE_OFFSET, "offset_m", -0.0085);
      }
    }
    assertTrue(named >= 8, named + " values are named");
    assertTrue(held >= named - 1, held + " of " + named + " are held");
  }

  /**
   * In whole centimetres a datum of 9 mm is too little to be named, but it bends the scale: the
   * scale's interval holds what it is beside a datum.
   */
  @Test
  void intervalOfAScale_allowsForADatum_thatIsNotNamed() {
    SensingSetup coarse = Ladders.board(0.01, Ladders.TAPE_M, 0);
    int held = 0;
    for (int seed = 1; seed <= 6; seed++) {
      List<ReadingRow> rows =
          Ladders.read((range, lot) -> 0.01 * Math.floor(100 * (0.985 * range - 0.009)), seed);
      Diagnosis diagnosis =
          new Diagnoser(1, Set.of()).diagnose(new DataSet("ladder", coarse, rows, List.of()));
      assertTrue(diagnosis.explanation().contains(Effect.SOUND_SPEED), diagnosis.reason());
      held += holds(diagnosis, Effect.SOUND_SPEED, "sound_speed_m_s", 343 / 0.985);
    }
    assertTrue(held >= 5, held + " of 6 are held");
  }

  private static int holds(Diagnosis diagnosis, Effect effect, String parameter, double truth) {
    Interval found = parameter(diagnosis, effect, parameter).ci95();
    return found.low() <= truth && truth <= found.high() ? 1 : 0;
  }

  @Test
  void numberForNoEcho_isACode() {
    Diagnosis zero = explained((range, lot) -> lot < 0.15 ? 0 : range, Effect.NO_ECHO_CODE);
    assertEquals(0, value(zero, Effect.NO_ECHO_CODE, "code_m"), 1e-3);
    Diagnosis most = explained((range, lot) -> lot < 0.15 ? 4 : range, Effect.NO_ECHO_CODE);
    assertEquals(4, value(most, Effect.NO_ECHO_CODE, "code_m"), 1e-3);
  }

  @Test
  void overflow_isAWrap() {
    Diagnosis diagnosis = explained((range, lot) -> range % 1.28, Effect.WRAP);
    assertEquals(1.28, value(diagnosis, Effect.WRAP, "modulus_m"), 0.01);
  }

  @Test
  void aMetreMoreNowAndThen_isMultipath() {
    Diagnosis diagnosis =
        explained((range, lot) -> lot < 0.1 ? range + 1 : range, Effect.MULTIPATH);
    assertEquals(1, value(diagnosis, Effect.MULTIPATH, "extra_m"), 0.01);
  }

  private static Diagnosis ofNarrowLadder(Ladders.Fault fault) {
    double[] distances = IntStream.rangeClosed(1, 18).mapToDouble(i -> 0.11 * i).toArray();
    return diagnose(Ladders.untimed(Ladders.read(fault, distances, 12, Ladders.TAPE_M, 1)));
  }

  /** One in eight is 20 cm too short: hardly a quantile of the gap shows it. */
  @Test
  void crosstalkThatKeepsItsDistance_isNeitherNoneNorExplained() {
    Diagnosis diagnosis =
        ofNarrowLadder((range, lot) -> lot < 0.12 && range > 0.25 ? range - 0.2 : range);
    assertEquals(
        Verdict.UNDECIDED, diagnosis.verdict(), diagnosis.explanation() + diagnosis.reason());
  }

  /** Beside a scale that is named, readings that lost their first digit are said to be left. */
  @Test
  void lostDigits_areNotExplained() {
    Diagnosis diagnosis =
        ofNarrowLadder((range, lot) -> lot < 0.08 && range > 1 ? range % 1 : 0.97 * range);
    assertEquals(Verdict.PARTLY, diagnosis.verdict(), diagnosis.explanation() + diagnosis.reason());
    assertEquals(List.of(Effect.SOUND_SPEED), diagnosis.explanation());
  }

  /** When each reading was taken tells nothing of what neither remembers nor drifts. */
  @Test
  void orderOfTime_changesNoName() {
    List<ReadingRow> rows = Ladders.read((range, lot) -> 0.985 * range - 0.009, 1);
    Diagnosis diagnosis = diagnose(Ladders.dealtAnew(rows, 9));
    assertEquals(Verdict.EXPLAINED, diagnosis.verdict());
    assertEquals(
        Set.of(Effect.SOUND_SPEED, Effect.RANGE_OFFSET), Set.copyOf(diagnosis.explanation()));
  }

  /** A tape that was misread once is no object beside the board, and no other placement's fault. */
  @Test
  void misreadTape_isSaid_andLeftOut() {
    List<ReadingRow> rows =
        Ladders.read((range, lot) -> Math.abs(range - 1) < 0.05 ? range - 0.09 : range, 1);
    List<AuditFinding> found = audit(rows);
    assertEquals(List.of(AuditCheck.MISPLACED), found.stream().map(AuditFinding::check).toList());
    assertEquals(Ladders.READ, found.get(0).rows().size());
    assertTrue(
        found.get(0).what().matches(".*at 1 m, are [89].. cm too short.*"), found.get(0).what());
    Diagnosis diagnosis =
        new Diagnoser(1, Set.of())
            .diagnose(new DataSet("ladder", Ladders.BOARD, rows, List.of()), found);
    assertEquals(Verdict.UNDECIDED, diagnosis.verdict(), diagnosis.reason());
    assertTrue(diagnosis.reason().contains("16 of 160 readings"), diagnosis.reason());
  }

  @Test
  void offsetOfAHandsBreadth_isFound() {
    Diagnosis diagnosis = explained((range, lot) -> range + 0.15, Effect.RANGE_OFFSET);
    assertEquals(0.15, value(diagnosis, Effect.RANGE_OFFSET, "offset_m"), 0.005);
  }

  /** Something without a name beside it: the factor stays named, and the rest is said. */
  @Test
  void factorBesideARest_isPartly() {
    Diagnosis diagnosis =
        diagnose(
            Ladders.read(
                (range, lot) -> 0.8 * range + (range > 1.2 ? 0.25 * Math.sin(9 * range) : 0), 1));
    assertEquals(Verdict.PARTLY, diagnosis.verdict(), diagnosis.reason());
    assertTrue(diagnosis.explanation().contains(Effect.SOUND_SPEED));
    assertTrue(diagnosis.gap().afterCm() < diagnosis.gap().beforeCm());
    assertTrue(diagnosis.unknownProbability() > 0.5, "what is left is something");
  }

  private static List<AuditFinding> audit(List<ReadingRow> rows) {
    return Audit.of(Ladders.BOARD, rows, List.of());
  }

  /** At one place what is held is not far off, but it is the same to the last digit. */
  @Test
  void heldReadings_areFoundByTheAudit() {
    List<ReadingRow> clean = Ladders.read((range, lot) -> range, 1);
    assertEquals(List.of(), audit(clean));
    List<ReadingRow> held = new ArrayList<>(clean);
    for (int i = 3; i < held.size(); i += 5) {
      ReadingRow row = held.get(i);
      Reading before = held.get(i - 1).reading();
      held.set(i, new ReadingRow(row.run(), row.sensor(), row.timeS(), row.pose(), before));
    }
    assertEquals(List.of(AuditCheck.HELD), audit(held).stream().map(AuditFinding::check).toList());
  }

  /** Scatter of two values, as where an echo crosses one wave earlier or later. */
  @Test
  void twoValues_areNotHeld() {
    List<ReadingRow> rows =
        Ladders.read((range, lot) -> Math.rint(100 * range) / 100 + (lot < 0.4 ? 0.0043 : 0), 1);
    assertTrue(
        audit(rows).stream().noneMatch(finding -> finding.check() == AuditCheck.HELD),
        audit(rows).toString());
  }

  /** Without times the order of rows means nothing: nothing is held, doubled or out of time. */
  @Test
  void rowsWithoutTimes_areNotJudgedByTheirOrder() {
    assertEquals(List.of(), audit(Ladders.untimed(Ladders.read((range, lot) -> steps(range), 1))));
    List<AuditFinding> zeros =
        audit(Ladders.untimed(Ladders.read((range, lot) -> lot < 0.1 ? 0 : steps(range), 1)));
    assertEquals(List.of(AuditCheck.NO_ECHO_CODE), zeros.stream().map(f -> f.check()).toList());
  }

  private static double steps(double rangeM) {
    return Math.rint(1e3 * rangeM) / 1e3;
  }

  @Test
  void oneNumberForAll_isRefused() {
    List<AuditFinding> found = audit(Ladders.read((range, lot) -> 0.5, 1));
    assertEquals(Severity.REFUSE, found.get(0).severity(), found.toString());
  }
}
