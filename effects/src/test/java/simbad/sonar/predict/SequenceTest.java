package simbad.sonar.predict;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;
import simbad.sonar.change.BeamEdge;
import simbad.sonar.change.BeamMisalignment;
import simbad.sonar.change.BeamWidth;
import simbad.sonar.change.Burst;
import simbad.sonar.change.Gain;
import simbad.sonar.change.HeadingDrift;
import simbad.sonar.change.HeadingDriftByWay;
import simbad.sonar.change.Hysteresis;
import simbad.sonar.change.Latency;
import simbad.sonar.change.ObstacleTurn;
import simbad.sonar.change.OdometryScale;
import simbad.sonar.change.PathScale;
import simbad.sonar.change.PingDelay;
import simbad.sonar.change.PreviousPing;
import simbad.sonar.change.SensorScatter;
import simbad.sonar.change.StaleReading;
import simbad.sonar.fixture.Scenes;
import simbad.sonar.fixture.Sonars;
import simbad.sonar.frame.Pose;
import simbad.sonar.ping.Change;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.Reading;
import simbad.sonar.sensing.ReadingRow;

/** What belongs to one run of one sensor, in which order, and where its poses really are. */
class SequenceTest {
  private static final SensingSetup SETUP =
      new SensingSetup(Sonars.noisy(0.01, 0.02, 0.1, 0.1), Scenes.of(Scenes.box(1, 0, 0.9)), 6.5);

  private static ReadingRow row(String run, String sensor, double timeS, double xM, double rangeM) {
    Reading reading = rangeM > 0 ? new Echo(rangeM) : NoEcho.NO_ECHO;
    return new ReadingRow(run, sensor, timeS, Pose.of(xM, 0, 0), reading);
  }

  /** Two runs of two sensors, interleaved and backwards. */
  private static final List<ReadingRow> MIXED =
      List.of(
          row("b", "right", 3, 0.1, 0.77),
          row("a", "left", 2, 0.2, 0.67),
          row("b", "left", 1, 0.3, 0.57),
          row("a", "right", 2.5, 0.4, 0),
          row("a", "left", 1, 0.5, 0.37),
          row("b", "right", 2, 0.6, 0.27),
          row("a", "left", 0.5, 0.7, 0.17));

  @Test
  void rows_areSortedIntoSequences() {
    PingLog log = new PingLog(MIXED);
    assertEquals(List.of("a", "b"), log.runs());
    assertEquals(List.of("left", "right"), log.sensors());
    int[] rows = {6, 4, 1, 3, 2, 5, 0};
    int[] starts = {0, 0, 0, 3, 4, 5, 5};
    double[] runStartS = {0.5, 0.5, 0.5, 0.5, 1, 1, 1};
    for (int ping = 0; ping < log.size(); ping++) {
      ReadingRow row = MIXED.get(rows[ping]);
      assertEquals(rows[ping], log.row(ping));
      assertEquals(starts[ping], log.sequenceStart(ping));
      assertEquals(runStartS[ping], log.runStartS(ping));
      assertEquals(row.timeS(), log.timeS(ping));
      assertEquals(row.run(), log.runs().get(log.run(ping)));
      assertEquals(row.sensor(), log.sensors().get(log.sensor(ping)));
      assertEquals(row.pose().position().xM(), log.xM(ping));
      assertEquals(row.reading() instanceof Echo, log.echo(ping));
    }
    assertEquals(6, log.echoes());
  }

  @Test
  void equalTimes_keepTheOrderOfTheRows() {
    List<ReadingRow> rows =
        List.of(row("a", "s", 1, 0.1, 1), row("a", "s", 0, 0.2, 2), row("a", "s", 1, 0.3, 3));
    PingLog log = new PingLog(rows);
    assertEquals(2, log.rangeM(0));
    assertEquals(1, log.rangeM(1));
    assertEquals(3, log.rangeM(2));
  }

  @Test
  void speed_isFromPingToPing() {
    PingLog log =
        new PingLog(
            List.of(
                row("a", "s", 0, 0, 1),
                row("a", "s", 2, 0.3, 1),
                row("a", "s", 3, 0.1, 1),
                row("a", "s", 3, 0.4, 1),
                row("a", "t", 0, 5, 1)));
    double[] expected = {0.15, 0.15, 0.2, 0, 0};
    for (int ping = 0; ping < expected.length; ping++) {
      assertEquals(expected[ping], log.speedMPerS(ping), 1e-12, "ping " + ping);
    }
  }

  @Test
  void emptyLog() {
    PingLog log = new PingLog(List.of());
    assertEquals(0, log.size());
    assertTrue(
        new ChangedModel(SETUP, List.of())
            .forecast(new ChangedModel(SETUP, List.of()).geometry(log))
            .isEmpty());
  }

  /** Every kind of memory, of places and of readings. */
  private static final List<Change> MEMORY =
      List.of(
          new Burst(0.2, 3, 1),
          new Hysteresis(0.9, 1.1),
          new StaleReading(2, 9, 1),
          new PreviousPing(0.3, 0.8, 0.05, 0.01),
          new Latency(0.7),
          new HeadingDrift(0.05, true),
          new OdometryScale(1.1),
          new BeamMisalignment(0.1, Optional.of("left")));

  @Property(tries = 50, seed = "20140617")
  void orderOfRows_changesNothing(@ForAll long seed) {
    List<ReadingRow> shuffled = new ArrayList<>(MIXED);
    Collections.shuffle(shuffled, new Random(seed));
    double[] expected = byRow(MIXED);
    double[] found = byRow(shuffled);
    for (int i = 0; i < MIXED.size(); i++) {
      assertEquals(expected[MIXED.indexOf(shuffled.get(i))], found[i], 0);
    }
  }

  private static double[] byRow(List<ReadingRow> rows) {
    PingLog log = new PingLog(rows);
    double[] byPing = Logs.likelihood(SETUP, rows, MEMORY);
    double[] byRow = new double[byPing.length];
    for (int ping = 0; ping < byPing.length; ping++) {
      byRow[log.row(ping)] = byPing[ping];
    }
    return byRow;
  }

  /** Sequences remember nothing of each other, but for the time at which their run began. */
  @Test
  void sequences_areAlone() {
    double[] together = byRow(MIXED);
    List<ReadingRow> left = List.of(MIXED.get(1), MIXED.get(4), MIXED.get(6));
    double[] alone = byRow(left);
    assertArrayEquals(new double[] {together[1], together[4], together[6]}, alone, 0);
  }

  private static Geometry geometry(List<ReadingRow> rows, Change... changes) {
    return new Geometry(new PingLog(rows), SETUP, List.of(changes));
  }

  private static List<ReadingRow> way() {
    return List.of(
        Logs.row(1, Pose.of(0.1, 0, 0), Logs.SILENCE),
        Logs.row(2, Pose.of(0.2, 0.1, 0.2), Logs.SILENCE),
        Logs.row(4, Pose.of(0.6, 0.1, 0.2), Logs.SILENCE),
        Logs.row(4, Pose.of(0.7, 0.1, 0.4), OptionalDouble.of(1)));
  }

  private static void assertPose(
      Geometry geometry, int ping, double xM, double zM, double headingRad) {
    assertEquals(xM, geometry.xM(ping), 1e-12, "x of ping " + ping);
    assertEquals(zM, geometry.zM(ping), 1e-12, "z of ping " + ping);
    assertEquals(headingRad, geometry.headingRad(ping), 1e-12, "heading of ping " + ping);
  }

  @Test
  void latency_goesBackInTime() {
    Geometry half = geometry(way(), new Latency(0.5));
    assertPose(half, 0, 0.1, 0, 0);
    assertPose(half, 1, 0.15, 0.05, 0.1);
    assertPose(half, 2, 0.5, 0.1, 0.2);
    assertPose(half, 3, 0.5, 0.1, 0.2);
    Geometry longer = geometry(way(), new Latency(2.5));
    assertPose(longer, 1, 0.1, 0, 0);
    assertPose(longer, 3, 0.15, 0.05, 0.1);
    assertPose(geometry(way(), new Latency(9)), 3, 0.1, 0, 0);
  }

  @Test
  void pingDelay_goesBackByPings() {
    Geometry one = geometry(way(), new PingDelay(1));
    assertPose(one, 0, 0.1, 0, 0);
    assertPose(one, 1, 0.1, 0, 0);
    assertPose(one, 3, 0.6, 0.1, 0.2);
    Geometry more = geometry(way(), new PingDelay(1.25));
    assertPose(more, 1, 0.1, 0, 0);
    assertPose(more, 3, 0.6 - 0.25 * 0.4, 0.1, 0.2);
    assertPose(geometry(way(), new PingDelay(30)), 3, 0.1, 0, 0);
  }

  @Test
  void odometryScale_stretchesTheWayFromItsStart() {
    Geometry geometry = geometry(way(), new OdometryScale(2));
    assertPose(geometry, 0, 0.1, 0, 0);
    assertPose(geometry, 1, 0.3, 0.2, 0.2);
    assertPose(geometry, 3, 1.3, 0.2, 0.4);
  }

  /** Every change of poses: of a way that lies turned on the page, the true way lies so as well. */
  @Property(tries = 40, seed = "20140617")
  void changesOfPoses_turnWithThePage(@ForAll @DoubleRange(min = -2, max = 1.5) double turnRad) {
    List<ReadingRow> turned = way().stream().map(row -> turned(row, turnRad)).toList();
    List<Change> changes =
        List.of(
            new OdometryScale(1.3),
            new PathScale(0.6),
            new Latency(0.7),
            new PingDelay(1.25),
            new HeadingDrift(0.3, true),
            new HeadingDrift(0.3, 2, true),
            new HeadingDriftByWay(0.5));
    for (Change change : changes) {
      Geometry plain = geometry(way(), change);
      Geometry rotated = geometry(turned, change);
      double cos = Math.cos(turnRad);
      double sin = Math.sin(turnRad);
      for (int ping = 0; ping < 4; ping++) {
        double x = plain.xM(ping);
        double z = plain.zM(ping);
        double heading = plain.headingRad(ping) + turnRad;
        assertPose(rotated, ping, x * cos + z * sin, z * cos - x * sin, heading);
      }
    }
  }

  private static ReadingRow turned(ReadingRow row, double turnRad) {
    double x = row.pose().position().xM();
    double z = row.pose().position().zM();
    double cos = Math.cos(turnRad);
    double sin = Math.sin(turnRad);
    Pose pose =
        Pose.of(x * cos + z * sin, z * cos - x * sin, row.pose().heading().radians() + turnRad);
    return new ReadingRow(row.run(), row.sensor(), row.timeS(), pose, row.reading());
  }

  @Test
  void headingDrift_turnsWithTheTime() {
    Geometry geometry = geometry(way(), new HeadingDrift(0.1, false));
    assertPose(geometry, 0, 0.1, 0, 0);
    assertPose(geometry, 1, 0.2, 0.1, 0.3);
    assertPose(geometry, 3, 0.7, 0.1, 0.7);
  }

  /** A robot that thinks it drives straight on while it turns left by a quarter each second. */
  @Test
  void headingDrift_bendsTheWay() {
    double quarter = Math.PI / 2;
    List<ReadingRow> straight =
        List.of(
            Logs.row(0, Pose.of(0, 0, 0), Logs.SILENCE),
            Logs.row(1, Pose.of(1, 0, 0), Logs.SILENCE),
            Logs.row(2, Pose.of(2, 0, 0), Logs.SILENCE));
    Geometry geometry = geometry(straight, new HeadingDrift(quarter, true));
    double half = Math.sqrt(0.5);
    // The first metre at 45 degrees to the left, up the page, the next at 135.
    assertPose(geometry, 1, half, -half, quarter);
    assertPose(geometry, 2, 0, -2 * half, 2 * quarter);
    Geometry stretched = geometry(straight, new HeadingDrift(quarter, true), new OdometryScale(2));
    assertPose(stretched, 2, 0, -4 * half, 2 * quarter);
    // The latency is taken from the bent way, whatever the order of the list.
    Geometry late = geometry(straight, new Latency(1), new HeadingDrift(quarter, true));
    assertPose(late, 2, half, -half, quarter);
  }

  /** 0.1 rad/s that falls to 1/e in 2 s has turned by 0.2 (1 - 1/e) after 2 s. */
  @Test
  void headingDrift_settles() {
    Geometry geometry = geometry(way(), new HeadingDrift(0.1, 2, false));
    assertPose(geometry, 0, 0.1, 0, 0);
    assertPose(geometry, 1, 0.2, 0.1, 0.2 + 0.2 * (1 - Math.exp(-0.5)));
    assertPose(geometry, 3, 0.7, 0.1, 0.4 + 0.2 * (1 - Math.exp(-1.5)));
  }

  @Test
  void headingDriftByWay_turnsWithTheWayMade() {
    Geometry geometry = geometry(way(), new HeadingDriftByWay(0.5));
    double first = Math.sqrt(0.02);
    assertPose(geometry, 0, 0.1, 0, 0);
    assertPose(geometry, 1, 0.2, 0.1, 0.2 + 0.5 * first);
    assertPose(geometry, 3, 0.7, 0.1, 0.4 + 0.5 * (first + 0.5));
  }

  /** Half of the way of sqrt(0.02) + 0.5 m lies on the second, straight piece. */
  @Test
  void pathScale_staysOnThePath() {
    Geometry geometry = geometry(way(), new PathScale(0.5));
    double first = Math.sqrt(0.02);
    assertPose(geometry, 0, 0.1, 0, 0);
    assertPose(geometry, 1, 0.15, 0.05, 0.1);
    assertPose(geometry, 3, 0.2 + (first + 0.5) / 2 - first, 0.1, 0.2);
    assertThrows(IllegalArgumentException.class, () -> new PathScale(1.01));
  }

  /** The drift's clock is the run's, the way's start the sequence's own. */
  @Test
  void headingDrift_countsFromTheStartOfTheRun() {
    List<ReadingRow> rows =
        List.of(row("a", "early", 0, 0, 1), row("a", "late", 2, 0.5, 1), row("b", "late", 7, 0, 1));
    Geometry geometry = geometry(rows, new HeadingDrift(0.1, true));
    assertPose(geometry, 1, 0.5, 0, 0.2);
    assertPose(geometry, 2, 0, 0, 0);
  }

  @Test
  void misalignment_comesLast_andOfOneSensorOnly() {
    List<ReadingRow> rows = List.of(row("a", "left", 0, 0.1, 1), row("a", "right", 0, 0.2, 1));
    Geometry geometry = geometry(rows, new BeamMisalignment(0.3, Optional.of("right")));
    assertPose(geometry, 0, 0.1, 0, 0);
    assertPose(geometry, 1, 0.2, 0, 0.3);
  }

  @Test
  void dependsOn_whatMovesOrWidens() {
    assertTrue(Geometry.dependsOn(new Latency(1)));
    assertTrue(Geometry.dependsOn(new ObstacleTurn(1, Optional.empty())));
    assertTrue(Geometry.dependsOn(new BeamWidth(0.1)));
    assertTrue(Geometry.dependsOn(new BeamEdge(0.1)));
    assertFalse(Geometry.dependsOn(new SensorScatter(0.1, 0.1, 0.1)));
    assertFalse(Geometry.dependsOn(new Gain(0.5)));
  }
}
