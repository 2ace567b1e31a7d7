package simbad.gap.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.gap.audit.AuditFinding;
import simbad.motion.MotionRun;
import simbad.motion.TrackPose;
import simbad.motion.format.MotionData;
import simbad.motion.format.MotionRow;

/** A track's clock beside the commands': one lag is a robot's, and any other a second clock's. */
class LagCheckTest {
  private static MotionRun run(int seed, double lateS) {
    Drives drives = new Drives(seed);
    drives.lateS = lateS;
    return drives.data().runs().get(0);
  }

  private static List<AuditFinding> audit(
      MotionRun run, boolean isOneClock, DoubleUnaryOperator clock) {
    List<TrackPose> track =
        run.track().stream()
            .map(p -> new TrackPose(clock.applyAsDouble(p.timeS()), p.xM(), p.yM(), p.headingRad()))
            .toList();
    return LagCheck.of(Map.of("a", rows(run.commands())), Map.of("a", rows(track)), isOneClock);
  }

  private static <T> List<MotionRow<T>> rows(List<T> values) {
    List<MotionRow<T>> rows = new ArrayList<>();
    values.forEach(value -> rows.add(new MotionRow<>(rows.size(), value)));
    return rows;
  }

  /** Of no latency, a usual one and the longest that is diagnosed. */
  @ParameterizedTest
  @ValueSource(doubles = {0, 0.25, 1.9})
  void oneClock_isRight(double lateS) {
    for (int seed = 1; seed <= 5; seed++) {
      assertEquals(List.of(), audit(run(seed, lateS), true, t -> t), "seed " + seed);
    }
  }

  /** Two quartz clocks, a quarter of a second apart in the end. */
  @Test
  void slowDrift_isNoFault() {
    assertEquals(List.of(), audit(run(1, 0.2), true, t -> 1.001 * t));
  }

  @ParameterizedTest
  @CsvSource({"5", "1.2", "-2"})
  void jump_isFound_withItsSizeAndPlace(double jumpS) {
    List<AuditFinding> found = audit(run(1, 0.2), true, t -> t + (t > 80 ? jumpS : 0));

    assertEquals(1, found.size());
    assertTrue(found.get(0).refuses());
    assertTrue(found.get(0).what().contains("a clock jumped by "), found.get(0).what());
    double told = Double.parseDouble(found.get(0).what().replaceAll(".*jumped by (.*) s", "$1"));
    assertEquals(jumpS, told, 0.1);
    double from = run(1, 0.2).track().get(found.get(0).rows().get(0)).timeS();
    assertEquals(80, from, 16, "a piece of the run");
  }

  @ParameterizedTest
  @ValueSource(doubles = {1.01, 0.985})
  void drift_isFound_withItsRate(double rate) {
    List<AuditFinding> found = audit(run(2, 0.2), true, t -> rate * t);

    assertEquals(1, found.size());
    assertTrue(found.get(0).what().contains("do not run alike"), found.get(0).what());
    double times = Double.parseDouble(found.get(0).suggestion().replaceAll(".* by ", ""));
    assertEquals(1 / rate, times, 0.002);
  }

  @ParameterizedTest
  @ValueSource(doubles = {3, -3})
  void offset_isFound_whereTheClocksAreOne(double offsetS) {
    List<AuditFinding> found = audit(run(3, 0.2), true, t -> t + offsetS);

    assertEquals(1, found.size());
    assertTrue(found.get(0).suggestion().contains("separate"), found.get(0).suggestion());
    assertEquals(List.of(), audit(run(3, 0.2), false, t -> t + offsetS));
  }

  /** A command again and again says nothing of when it was. */
  @Test
  void monotony_saysNothing() {
    Drives drives = new Drives(4);
    MotionRun run = drives.data().runs().get(0);
    MotionRun one = new MotionRun("a", List.of(run.commands().get(0)), run.track());
    assertEquals(List.of(), audit(one, true, t -> t));
  }

  @Test
  void repeatedPoses_areLeftOut_andNothingElse() {
    MotionData data = new Drives(5).data();
    MotionRun run = data.runs().get(0);
    List<TrackPose> stuck = new ArrayList<>(run.track());
    TrackPose seen = stuck.get(600);
    for (int i = 601; i < 800; i++) {
      stuck.set(i, new TrackPose(stuck.get(i).timeS(), seen.xM(), seen.yM(), seen.headingRad()));
    }
    var track = Map.of(run.name(), rows(stuck));
    List<AuditFinding> audit =
        MotionAudit.of(Map.of(run.name(), rows(run.commands())), track, true);
    MotionData spoilt =
        new MotionData(
            data.name(),
            data.robot(),
            List.of(new MotionRun(run.name(), run.commands(), stuck)),
            data.reference());

    List<TrackPose> kept = StuckTrack.without(spoilt, track, audit).runs().get(0).track();

    List<TrackPose> right = new ArrayList<>(run.track());
    right.subList(601, 800).clear();
    assertEquals(right, kept);
  }
}
