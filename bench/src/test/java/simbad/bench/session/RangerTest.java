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
import org.junit.jupiter.params.provider.EnumSource;
import simbad.bench.link.MemoryLink;
import simbad.bench.protocol.FrameLine;

@Timeout(120)
class RangerTest {
  private static final Duration SOON = Duration.ofSeconds(20);
  private static final Duration SHORT = Duration.ofMillis(300);

  @Test
  void connect_silencesABoardThatPings() throws Exception {
    MemoryLink.Pair line = MemoryLink.pair();
    try (FakeRanger fake = new FakeRanger(line.there(), Map.of())) {
      Thread.sleep(120);
      try (Ranger ranger = Ranger.connect(line.here(), SOON)) {
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
        Ranger ranger = Ranger.connect(line.here(), SOON)) {
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
        Ranger ranger = Ranger.connect(line.here(), SOON)) {
      ranger.ping(SOON);
      IOException fault = assertThrows(Disturbance.class, () -> ranger.ping(SOON));
      assertTrue(String.valueOf(fault.getMessage()).contains("that nobody asked for"));
      fake.mute(true);
    }
  }

  @Test
  void deviceThatNeverIdentifies_isSaidInTime() {
    MemoryLink.Pair line = MemoryLink.pair();
    long begunNs = System.nanoTime();
    IOException fault =
        assertThrows(IOException.class, () -> Ranger.connect(line.here(), Duration.ofSeconds(1)));
    assertTrue(System.nanoTime() - begunNs >= 1_000_000_000L);
    assertTrue(String.valueOf(fault.getMessage()).contains("nobody answers who says"));
    assertThrows(IOException.class, () -> line.here().write(new byte[1]), "closed");
  }

  @Test
  void thesisMode_givesItsNumbersAndIsLeft() throws Exception {
    MemoryLink.Pair line = MemoryLink.pair();
    try (FakeRanger fake = new FakeRanger(line.there(), Map.of());
        Ranger ranger = Ranger.connect(line.here(), SOON)) {
      assertEquals(49, ranger.thesisSteps(SOON));
      ranger.settle(SOON);
      ranger.ping(SOON);
      fake.mute(true);
    }
  }
}
