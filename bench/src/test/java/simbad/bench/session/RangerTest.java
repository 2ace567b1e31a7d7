package simbad.bench.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.time.Duration;
import java.util.Map;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import simbad.bench.link.MemoryLink;
import simbad.bench.protocol.FirmwareMode;
import simbad.bench.protocol.FrameLine;
import simbad.bench.protocol.PingStatus;

@Timeout(120)
class RangerTest {
  private static final Duration SOON = Duration.ofSeconds(20);
  private static final Duration SHORT = Duration.ofMillis(300);

  @Test
  void connect_silencesABoardThatPings() throws Exception {
    MemoryLink.Pair line = MemoryLink.pair();
    try (FakeRanger fake = new FakeRanger(line.there(), Map.of())) {
      Thread.sleep(120);
      try (Ranger ranger = Ranger.connect(line.here(), SOON, FirmwareMode.FRAME)) {
        assertEquals("fake", ranger.identity().name());
        FrameLine.Ping first = ranger.ping(SOON);
        for (int i = 1; i < 50; i++) {
          FrameLine.Ping ping = ranger.ping(SOON);
          assertEquals(first.sequence() + i, ping.sequence());
          assertEquals(OptionalInt.of(1000 + ping.sequence()), ping.echoUs());
        }
      }
      fake.mute(true);
    }
  }

  @ParameterizedTest
  @EnumSource(
      value = FakeRanger.Fault.class,
      mode = EnumSource.Mode.EXCLUDE,
      names = {"STUCK", "TWICE"})
  void fault_isADisturbanceAndSettleMendsIt(FakeRanger.Fault fault) throws Exception {
    MemoryLink.Pair line = MemoryLink.pair();
    try (FakeRanger fake = new FakeRanger(line.there(), Map.of(3, fault));
        Ranger ranger = Ranger.connect(line.here(), SOON, FirmwareMode.FRAME)) {
      ranger.ping(SOON);
      ranger.ping(SOON);
      assertThrows(Disturbance.class, () -> ranger.ping(SHORT));
      ranger.settle(SOON);
      int number = ranger.ping(SOON).sequence();
      assertEquals(number + 1, ranger.ping(SOON).sequence());
      fake.mute(true);
    }
  }

  @Test
  void lineThatComesTwice_isSeenAtTheNextPing() throws Exception {
    MemoryLink.Pair line = MemoryLink.pair();
    try (FakeRanger fake = new FakeRanger(line.there(), Map.of(1, FakeRanger.Fault.TWICE));
        Ranger ranger = Ranger.connect(line.here(), SOON, FirmwareMode.FRAME)) {
      ranger.ping(SOON);
      IOException fault = assertThrows(Disturbance.class, () -> ranger.ping(SOON));
      assertTrue(String.valueOf(fault.getMessage()).contains("came without a question"));
      fake.mute(true);
    }
  }

  @Test
  void deviceThatNeverIdentifies_isSaidInTime() {
    MemoryLink.Pair line = MemoryLink.pair();
    long begunNs = System.nanoTime();
    IOException fault =
        assertThrows(
            IOException.class,
            () -> Ranger.connect(line.here(), Duration.ofSeconds(1), FirmwareMode.FRAME));
    assertTrue(System.nanoTime() - begunNs >= 1_000_000_000L);
    assertTrue(String.valueOf(fault.getMessage()).contains("no ranger answers"));
    assertThrows(IOException.class, () -> line.here().write(new byte[1]), "closed");
  }

  private static final int NONE_SINCE = 65535;

  private static FrameLine.Ping numbered(int sequence, PingStatus status, OptionalInt echoUs) {
    return new FrameLine.Ping(sequence, status, echoUs, NONE_SINCE);
  }

  /** 49 steps of 118 us, taken in the middle of the step. */
  @Test
  void thesisMode_givesItsNumbersAndIsLeft() throws Exception {
    MemoryLink.Pair line = MemoryLink.pair();
    try (FakeRanger fake = new FakeRanger(line.there(), Map.of())) {
      try (Ranger ranger = Ranger.connect(line.here(), SOON, FirmwareMode.THESIS)) {
        fake.sayInThesisMode("49", "305", "?", "0", "49");
        assertEquals(numbered(1, PingStatus.ECHO, OptionalInt.of(5841)), ranger.ping(SOON));
        assertEquals(numbered(2, PingStatus.NO_ECHO, OptionalInt.of(36_049)), ranger.ping(SOON));
        assertEquals(numbered(3, PingStatus.STUCK, OptionalInt.empty()), ranger.ping(SOON));
        assertEquals(numbered(4, PingStatus.TOO_NEAR, OptionalInt.of(59)), ranger.ping(SOON));
        ranger.settle(SOON);
        assertEquals(5841, ranger.ping(SOON).echoUs().orElseThrow());
      }
      fake.mute(true);
    }
  }

  @ParameterizedTest
  @CsvSource({
    "4x9, garbled line",
    "4949, garbled line",
    "P 7 1007 echo 100, has left the thesis's mode",
    "I fake 1.0 00000000 brown-out, the board was reset: brown-out"
  })
  void thesisMode_whatIsNoNumberIsNoReading(String text, String message) throws Exception {
    MemoryLink.Pair line = MemoryLink.pair();
    try (FakeRanger fake = new FakeRanger(line.there(), Map.of());
        Ranger ranger = Ranger.connect(line.here(), SOON, FirmwareMode.THESIS)) {
      fake.sayInThesisMode(text.length() > 4 ? FakeRanger.line(text).strip() : text);
      IOException fault = assertThrows(Disturbance.class, () -> ranger.ping(SOON));
      assertTrue(String.valueOf(fault.getMessage()).contains(message), fault.getMessage());
      fake.mute(true);
    }
  }
}
