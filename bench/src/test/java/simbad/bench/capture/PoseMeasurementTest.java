package simbad.bench.capture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.time.ZoneId;
import java.time.ZoneOffset;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simbad.bench.protocol.FirmwareMode;
import simbad.bench.protocol.FrameLine;
import simbad.bench.protocol.PingStatus;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.frame.Pose;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;

class PoseMeasurementTest {
  private static final String HEAD = "run,sensor,t_s,x_m,z_m,heading_deg,range_m\n";
  private static final Ranging RANGING = new Ranging(20, FirmwareMode.FRAME);

  @TempDir private Path folder = Path.of("target");

  private final Deque<FrameLine.Ping> answers = new ArrayDeque<>();
  private final List<String> placed = new ArrayList<>();

  private static ReadingRow row(double timeS, double xM, double headingDeg) {
    Pose pose = Pose.of(xM, -0.5, Math.toRadians(headingDeg));
    return new ReadingRow("next-1", "s", timeS, pose, NoEcho.NO_ECHO);
  }

  private static final List<ReadingRow> POSES =
      List.of(row(0, 1, 90), row(0.1, 1, 90), row(0.2, 1, 95), row(0.3, 2, 95));

  private void answer(PingStatus status, int echoUs) {
    OptionalInt echo = echoUs > 0 ? OptionalInt.of(echoUs) : OptionalInt.empty();
    answers.add(new FrameLine.Ping(0, status, echo, 68));
  }

  private void measure(Path file, Optional<Clock> clock) throws Exception {
    try (ReadingsLog log = ReadingsLog.open(file)) {
      new PoseMeasurement(
              POSES,
              () -> {
                if (answers.isEmpty()) {
                  throw new IOException("no more");
                }
                return answers.remove();
              },
              (row, pose) -> placed.add(row + " " + pose.position().xM()),
              RANGING)
          .run(log, clock);
    }
  }

  /** 10 ms of sound at 343.21 m/s, there and back, are 1.7161 m. */
  @Test
  void rows_areReadWhereTheyAre_andKept() throws Exception {
    answer(PingStatus.ECHO, 10_000);
    answer(PingStatus.NO_ECHO, 0);
    answer(PingStatus.TOO_NEAR, 120);
    answer(PingStatus.ECHO, 5_000);
    Path file = folder.resolve("next.csv");
    measure(file, Optional.empty());
    assertEquals(
        HEAD
            + "next-1,s,0.000,1.0000,-0.5000,90.000,1.7161\n"
            + "next-1,s,0.100,1.0000,-0.5000,90.000,\n"
            + "next-1,s,0.200,1.0000,-0.5000,95.000,\n"
            + "next-1,s,0.300,2.0000,-0.5000,95.000,0.8580\n",
        Files.readString(file));
    assertEquals(List.of("0 1.0", "2 1.0", "3 2.0"), placed);
  }

  /** Ended in the middle, with half a line when the power went: what is whole stays. */
  @Test
  void measurement_goesOn_whereItEnded() throws Exception {
    Path file = folder.resolve("next.csv");
    answer(PingStatus.ECHO, 10_000);
    answer(PingStatus.NO_ECHO, 0);
    assertThrows(IOException.class, () -> measure(file, Optional.of(new TickingClock())));
    String kept = Files.readString(file);
    assertEquals(3, kept.lines().count());
    Files.writeString(file, kept + "next-1,s,7.1,1.0");
    placed.clear();
    answer(PingStatus.NO_ECHO, 0);
    answer(PingStatus.NO_ECHO, 0);
    measure(file, Optional.of(new TickingClock()));
    assertEquals(
        kept
            + "next-1 from row 3,s,0.000,1.0000,-0.5000,95.000,\n"
            + "next-1 from row 3,s,2.000,2.0000,-0.5000,95.000,\n",
        Files.readString(file));
    assertEquals(List.of("2 1.0", "3 2.0"), placed);
    measure(file, Optional.of(new TickingClock()));
    assertEquals(5, Files.readString(file).lines().count(), "all is there");
  }

  @Test
  void log_ofOtherPoses_isForeign() {
    assertEquals(Optional.empty(), PoseMeasurement.findForeign(POSES, POSES.subList(0, 2)));
    List<ReadingRow> other = List.of(row(0, 1, 90), row(0, 1, 91));
    assertEquals(Optional.of(1), PoseMeasurement.findForeign(POSES, other));
    assertEquals(Optional.of(2), PoseMeasurement.findForeign(POSES.subList(0, 2), POSES));
    assertEquals(
        Optional.empty(),
        PoseMeasurement.findForeign(List.of(row(0, 1, 360)), List.of(row(0, 1, 0))));
  }

  @Test
  void file_thatHoldsNoReadings_isLeftAsItIs() throws Exception {
    Path file = Files.writeString(folder.resolve("other.csv"), "bearing_deg,threshold_m\n0,1");
    DataFormatException refused =
        assertThrows(DataFormatException.class, () -> ReadingsLog.open(file).close());
    assertTrue(refused.toString().contains("begin with run,sensor"), refused.toString());
    assertEquals("bearing_deg,threshold_m\n0,1", Files.readString(file));
  }

  @Test
  void file_thatIsBeingWritten_isRefused() throws Exception {
    Path file = folder.resolve("next.csv");
    try (ReadingsLog log = ReadingsLog.open(file)) {
      assertEquals(List.of(), log.before());
      assertThrows(IOException.class, () -> ReadingsLog.open(file).close());
    }
    ReadingsLog.open(file).close();
  }

  /** Two seconds pass from look to look. */
  private static final class TickingClock extends Clock {
    private Instant now = Instant.ofEpochSecond(1_700_000_000);

    @Override
    public ZoneId getZone() {
      return ZoneOffset.UTC;
    }

    @Override
    public Clock withZone(ZoneId zone) {
      return this;
    }

    @Override
    public Instant instant() {
      now = now.plus(Duration.ofSeconds(2));
      return now;
    }
  }
}
