package simbad.gap.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import simbad.gap.audit.AuditCheck;
import simbad.gap.audit.AuditFinding;
import simbad.gap.audit.Severity;
import simbad.motion.Command;
import simbad.motion.MotionChain;
import simbad.motion.MotionRun;
import simbad.motion.Robot;
import simbad.motion.TrackPose;
import simbad.motion.format.MotionData;
import simbad.motion.format.MotionRow;

/** A track of two runs of three poses each; an audit says which of them are repeated. */
class StuckTrackTest {
  private static final Robot ROBOT = new Robot(false, 0, false, 0.001, 0.001, MotionChain.EXACT);

  private static MotionRow<TrackPose> row(int number) {
    return new MotionRow<>(number, new TrackPose(number, 0.1 * number, 0, 0));
  }

  private static MotionRun run(String name, List<MotionRow<TrackPose>> rows) {
    return new MotionRun(
        name, List.of(Command.STAND), rows.stream().map(MotionRow::value).toList());
  }

  private static AuditFinding finding(AuditCheck check, Integer... rows) {
    return new AuditFinding(
        check, AuditFinding.File.TRACK, "", List.of(rows), "", "", Severity.WARN);
  }

  private static List<Double> timesS(MotionRun run) {
    return run.track().stream().map(TrackPose::timeS).toList();
  }

  @Test
  void onlyWhatIsRepeatedIsLeftOut() {
    List<MotionRow<TrackPose>> first = List.of(row(0), row(1), row(2));
    List<MotionRow<TrackPose>> second = List.of(row(3), row(4), row(5));
    MotionData data =
        new MotionData("d", ROBOT, List.of(run("a", first), run("b", second)), List.of());
    MotionData less =
        StuckTrack.without(
            data,
            Map.of("a", first, "b", second),
            List.of(
                finding(AuditCheck.TRACK_STILL, 1),
                finding(AuditCheck.UNIT, 0, 3),
                finding(AuditCheck.TRACK_STILL, 4, 5)));

    assertEquals(List.of(0.0, 2.0), timesS(less.runs().get(0)));
    assertEquals(List.of(3.0), timesS(less.runs().get(1)));
    assertEquals(List.of("a", "b"), less.runs().stream().map(MotionRun::name).toList());
    assertEquals(List.of(Command.STAND), less.runs().get(0).commands());
    assertEquals(ROBOT, less.robot());
  }
}
