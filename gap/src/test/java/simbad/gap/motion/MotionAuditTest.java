package simbad.gap.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.gap.audit.AuditFinding;
import simbad.gap.audit.Severity;
import simbad.motion.Command;
import simbad.motion.MotionRun;
import simbad.motion.TrackPose;
import simbad.motion.format.MotionRow;

class MotionAuditTest {
  private static final MotionRun RUN = new Drives(3).data().runs().get(0);

  private static <T> List<MotionRow<T>> rows(List<T> values) {
    List<MotionRow<T>> rows = new ArrayList<>();
    values.forEach(value -> rows.add(new MotionRow<>(rows.size(), value)));
    return rows;
  }

  private static List<AuditFinding> audit(List<TrackPose> track) {
    return MotionAudit.of(Map.of("a", rows(RUN.commands())), Map.of("a", rows(track)), true);
  }

  private static List<AuditFinding> audit(UnaryOperator<TrackPose> change) {
    return audit(RUN.track().stream().map(change).toList());
  }

  @Test
  void soundLog_hasNoFinding() {
    assertEquals(List.of(), audit(pose -> pose));
  }

  private static Arguments wrong(String word, String suggestion, UnaryOperator<TrackPose> change) {
    return Arguments.of(word, suggestion, change);
  }

  static Stream<Arguments> impossible() {
    return Stream.of(
        wrong("track-unit", "by 1000", p -> pose(p, 1000, 1000, 1)),
        wrong("track-unit", "by 100", p -> pose(p, 100, 100, 1)),
        wrong("track-heading", "57.29578", p -> pose(p, 1, 1, Math.PI / 180)),
        wrong("track-frame", "sign of z_m", p -> pose(p, 1, -1, 1)),
        wrong("track-frame", "sign of", p -> pose(p, 1, -1, -1)),
        wrong(
            "track-clock",
            "one clock",
            p -> new TrackPose(p.timeS() - 1e6, p.xM(), p.yM(), p.headingRad())));
  }

  private static TrackPose pose(TrackPose p, double x, double y, double heading) {
    return new TrackPose(p.timeS(), x * p.xM(), y * p.yM(), heading * p.headingRad());
  }

  @ParameterizedTest(name = "{0} {1}")
  @MethodSource("impossible")
  void whatCannotBe_isRefused(String word, String suggestion, UnaryOperator<TrackPose> change) {
    AuditFinding worst = audit(change).get(0);

    assertEquals(Severity.REFUSE, worst.severity(), worst.what());
    assertEquals(word, worst.check().word());
    assertTrue(worst.suggestion().contains(suggestion), worst.suggestion());
    assertEquals(AuditFinding.File.TRACK, worst.file());
  }

  private static AuditFinding worst(List<Command> commands, List<TrackPose> track) {
    return MotionAudit.of(Map.of("a", rows(commands)), Map.of("a", rows(track)), true).get(0);
  }

  private static List<TrackPose> millisecondsOfTrack() {
    return RUN.track().stream()
        .map(p -> new TrackPose(1000 * p.timeS(), p.xM(), p.yM(), p.headingRad()))
        .toList();
  }

  private static List<Command> commands(double times, double turns) {
    return RUN.commands().stream()
        .map(c -> new Command(times * c.timeS(), c.speedMPerS(), turns * c.turnRadPerS()))
        .toList();
  }

  @Test
  void milliseconds_areRefused_inBothFilesAndInOne() {
    AuditFinding both = worst(commands(1000, 1), millisecondsOfTrack());
    AuditFinding track = worst(RUN.commands(), millisecondsOfTrack());
    AuditFinding told = worst(commands(1000, 1), RUN.track());

    assertTrue(both.refuses() && both.suggestion().contains("divide t_s by 1000"), both.what());
    assertTrue(track.refuses() && track.suggestion().contains("one clock"), track.what());
    assertTrue(told.refuses() && told.suggestion().contains("one clock"), told.what());
  }

  /** One last pose by the clock of the day: nobody drove from 1970 on. */
  @Test
  void poseDaysAfterTheCommands_isRefused() {
    List<TrackPose> track = new ArrayList<>(RUN.track());
    track.add(new TrackPose(1.7e9, 1, 1, 0));
    AuditFinding found = worst(RUN.commands(), track);
    assertTrue(found.refuses() && found.suggestion().contains("one clock"), found.what());
  }

  /** It goes straight on whatever turns it is told, but for a 57th: its heading is in degrees. */
  @Test
  void robotThatHardlyTurns_isBelieved() {
    Drives drives = new Drives(7);
    drives.turnFactor = Math.PI / 180;
    MotionRun run = drives.data().runs().get(0);

    List<AuditFinding> findings = auditOf(run);
    assertTrue(findings.stream().noneMatch(AuditFinding::refuses), findings.toString());
  }

  @Test
  void turnsInDegreesASecond_areRefused() {
    AuditFinding worst = worst(commands(1, 180 / Math.PI), RUN.track());

    assertTrue(worst.refuses(), worst.what());
    assertTrue(worst.suggestion().contains("w_rad_s in radians"), worst.suggestion());
  }

  @Test
  void fewPoses_areNoReasonToRefuse() {
    List<TrackPose> few = new ArrayList<>();
    for (int i = 0; i < RUN.track().size(); i += 30) {
      few.add(RUN.track().get(i));
    }
    assertTrue(audit(few).stream().noneMatch(AuditFinding::refuses));
  }

  @Test
  void holesJumpsAndRepeats_areSaid_withTheirRows() {
    List<TrackPose> track = new ArrayList<>(RUN.track());
    TrackPose pose = track.get(500);
    track.set(500, new TrackPose(pose.timeS(), pose.xM() + 5, pose.yM(), pose.headingRad()));
    track.subList(1000, 1020).clear();
    TrackPose last = track.get(1500);
    track.set(1501, new TrackPose(last.timeS(), last.xM(), last.yM(), last.headingRad() + 0.1));
    List<AuditFinding> findings = audit(track);

    assertEquals(
        List.of("track-clock", "track-jump", "track-holes"),
        findings.stream().map(finding -> finding.check().word()).toList());
    assertEquals(List.of(1501), findings.get(0).rows());
    assertEquals(List.of(500), findings.get(1).rows());
    assertEquals(List.of(1000), findings.get(2).rows());
    assertTrue(findings.stream().noneMatch(AuditFinding::refuses));
  }

  @Test
  void turnedTracker_isWarnedOf() {
    AuditFinding worst =
        audit(p -> new TrackPose(p.timeS(), p.xM(), p.yM(), p.headingRad() - Math.PI / 2)).get(0);

    assertEquals(Severity.WARN, worst.severity());
    assertTrue(worst.what().contains("90 degrees to the left"), worst.what());
  }

  @Test
  void trackThatStands_isWarnedOf() {
    List<TrackPose> track = new ArrayList<>(RUN.track());
    TrackPose seen = track.get(600);
    for (int i = 600; i < 1200; i++) {
      double timeS = track.get(i).timeS();
      track.set(i, new TrackPose(timeS, seen.xM(), seen.yM(), seen.headingRad()));
    }
    assertTrue(
        audit(track).stream().anyMatch(finding -> finding.check().word().equals("track-still")));
  }

  @Test
  void commands_areTakenInOrderOfTime() {
    Command first = RUN.commands().get(0);
    List<Command> mixed = new ArrayList<>(RUN.commands());
    mixed.remove(0);
    mixed.add(first);
    assertEquals(
        List.of(), MotionAudit.of(Map.of("a", rows(mixed)), Map.of("a", rows(RUN.track())), true));
  }

  private static List<AuditFinding> auditOf(MotionRun run) {
    return MotionAudit.of(Map.of("a", rows(run.commands())), Map.of("a", rows(run.track())), true);
  }

  @ParameterizedTest
  @ValueSource(longs = {5, 6, 7})
  void trackOfAnotherDrive_isRefused(long seed) {
    MotionRun other = new Drives(seed).data().runs().get(0);
    AuditFinding found = worst(RUN.commands(), other.track());

    assertEquals("track-foreign", found.check().word(), found.what());
    assertTrue(found.refuses());
    assertTrue(found.suggestion().startsWith("is it of another drive?"), found.suggestion());
    assertTrue(
        found.what().matches(".*hardly follows the commands \\(correlation 0\\.[0-3] of speed, .*"),
        found.what());
  }

  static Stream<Consumer<Drives>> badRobots() {
    return Stream.of(
        drives -> drives.dropped = 0.5,
        drives -> drives.lagS = 3,
        drives -> drives.roughness = 0.3,
        drives -> drives.mostSpeed = 0.03,
        drives -> drives.turnFactor = 0,
        // It stands still.
        drives -> drives.deadSpeed = drives.deadTurn = 9,
        drives -> drives.oneSpeed = true);
  }

  @ParameterizedTest
  @MethodSource("badRobots")
  void robotThatHardlyDoesWhatItIsTold_isBelieved(Consumer<Drives> change) {
    Drives drives = new Drives(8);
    change.accept(drives);
    List<AuditFinding> findings = auditOf(drives.data().runs().get(0));
    assertTrue(findings.stream().noneMatch(AuditFinding::refuses), findings.toString());
  }

  @Test
  void robotThatIsToldOneSpeed_isBelieved() {
    List<Command> one =
        RUN.commands().stream().map(told -> new Command(told.timeS(), 0.2, 0)).toList();
    List<AuditFinding> findings =
        MotionAudit.of(Map.of("a", rows(one)), Map.of("a", rows(RUN.track())), true);
    assertTrue(findings.stream().noneMatch(AuditFinding::refuses), findings.toString());
  }

  /** Millimetres in commands and track alike: nothing but their size tells it. */
  @Test
  void commandsThatNoRobotDoes_areRefused() {
    List<TrackPose> track = RUN.track().stream().map(p -> pose(p, 1000, 1000, 1)).toList();
    AuditFinding found = worst(faster(1000), track);

    assertEquals("command-unit", found.check().word(), found.what());
    assertTrue(found.refuses());
    assertTrue(found.suggestion().contains("--place-unit"), found.suggestion());
    assertEquals(AuditFinding.File.COMMANDS, found.file());
  }

  private static List<Command> faster(double times) {
    return RUN.commands().stream()
        .map(c -> new Command(c.timeS(), times * c.speedMPerS(), c.turnRadPerS()))
        .toList();
  }

  /** A slip of the keyboard is no unit. */
  @Test
  void oneCommandThatNoRobotDoes_isWarnedOf() {
    List<Command> told = new ArrayList<>(RUN.commands());
    Command last = told.remove(told.size() - 1);
    told.add(new Command(last.timeS(), 300, 0));
    AuditFinding found = worst(told, RUN.track());

    assertEquals("command-unit", found.check().word(), found.what());
    assertEquals(Severity.WARN, found.severity());
    assertEquals(List.of(told.size() - 1), found.rows());
  }

  @Test
  void turnsInAWrongUnit_areNotSlipsToo() {
    List<Command> told = new ArrayList<>(commands(1, 180 / Math.PI));
    Command last = told.remove(told.size() - 1);
    told.add(new Command(last.timeS(), 0, 70));
    List<AuditFinding> findings =
        MotionAudit.of(Map.of("a", rows(told)), Map.of("a", rows(RUN.track())), true);

    assertEquals(
        List.of("track-heading"), findings.stream().map(found -> found.check().word()).toList());
  }

  @Test
  void posesInAWrongUnit_areNotJumpsToo() {
    List<AuditFinding> findings = audit(p -> pose(p, 1000, 1000, 1));

    assertEquals(
        List.of("track-unit"), findings.stream().map(found -> found.check().word()).toList());
  }
}
