package simbad.sonar.ping;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.sonar.change.HeadingDrift;
import simbad.sonar.change.LatePose;
import simbad.sonar.frame.Pose;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;

/** Poses that are written late, of a robot that drives a circle of 1 m at 0.8 rad/s. */
class LatePoseTest {
  private static final double RAD_PER_S = 0.8;

  private static Pose at(double timeS) {
    double angle = RAD_PER_S * timeS;
    // Counter-clockwise, seen from above, with z down the page.
    return Pose.of(Math.cos(angle), -Math.sin(angle), angle + Math.PI / 2);
  }

  private static PingLog log(int... pings) {
    List<ReadingRow> rows = new ArrayList<>();
    for (int run = 0; run < pings.length; run++) {
      for (int i = 0; i < pings[run]; i++) {
        rows.add(new ReadingRow("run" + run, "s", 0.1 * i, at(0.1 * i), NoEcho.NO_ECHO));
      }
    }
    return new PingLog(rows);
  }

  private static void isAt(double timeS, TruePose pose, double within) {
    Pose expected = at(timeS);
    assertEquals(expected.position().xM(), pose.xM(), within);
    assertEquals(expected.position().zM(), pose.zM(), within);
    assertEquals(
        0,
        Math.IEEEremainder(expected.heading().radians() - pose.headingRad(), 2 * Math.PI),
        within);
  }

  /** On a circle going on as before is exact, from when as much time has gone by. */
  @Test
  void simulation_goesOnAsBefore() {
    PoseChange.Track track = new LatePose(0.3).start("s", 0);
    TruePose pose = new TruePose();
    for (int i = 0; i < 40; i++) {
      Pose now = at(0.1 * i);
      pose.set(now.position().xM(), now.position().zM(), now.heading().radians());
      track.next(0.1 * i, pose);
      if (i == 0 || i > 3) {
        isAt(i == 0 ? 0 : 0.1 * i + 0.3, pose, 1e-9);
      }
    }
  }

  /** A log says it: exactly at its poses, on the chord between them; each run by itself. */
  @Test
  void log_saysWhereTheSensorWasLater() {
    PingLog log = log(30, 20);
    for (double late : new double[] {0.2, 0.25}) {
      LoggedPoses poses = new LoggedPoses(log, List.of(new LatePose(late)));
      TruePose pose = new TruePose();
      for (int ping = 0; ping < log.size(); ping++) {
        poses.next(ping, pose);
        // At a run's end as a simulation does, which on a circle is the same.
        isAt(log.timeS(ping) + late, pose, late == 0.2 ? 1e-9 : 1e-3);
      }
    }
  }

  /** What else turns the sensor is done to the later pose. */
  @Test
  void otherChanges_areMadeOfTheLaterPose() {
    PingLog log = log(10);
    LoggedPoses poses =
        new LoggedPoses(log, List.of(new LatePose(0.2), new HeadingDrift(0.1, false)));
    TruePose pose = new TruePose();
    for (int ping = 0; ping < 7; ping++) {
      poses.next(ping, pose);
      assertEquals(
          at(log.timeS(ping) + 0.2).heading().radians() + 0.1 * log.timeS(ping),
          pose.headingRad(),
          1e-9);
    }
  }

  /** So little later that a clock of seconds since 1970 does not show it. */
  @Test
  void lessThanTheClockShows_isNow() {
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < 5; i++) {
      rows.add(new ReadingRow("run", "s", 1.7e9 + 0.1 * i, at(0.1 * i), NoEcho.NO_ECHO));
    }
    PingLog log = new PingLog(rows);
    LoggedPoses poses = new LoggedPoses(log, List.of(new LatePose(1e-9)));
    TruePose pose = new TruePose();
    for (int ping = 0; ping < 5; ping++) {
      poses.next(ping, pose);
      isAt(0.1 * ping, pose, 1e-9);
    }
  }

  @Test
  void noTime_changesNothing_andLessIsRefused() {
    PingLog log = log(5);
    LoggedPoses poses = new LoggedPoses(log, List.of(new LatePose(0)));
    TruePose pose = new TruePose();
    for (int ping = 0; ping < 5; ping++) {
      poses.next(ping, pose);
      assertEquals(log.xM(ping), pose.xM());
    }
    assertThrows(IllegalArgumentException.class, () -> new LatePose(-0.1));
    assertThrows(IllegalArgumentException.class, () -> new LatePose(Double.NaN));
  }
}
