package simbad.bench.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import simbad.bench.link.MemoryLink;
import simbad.bench.link.PortLink;
import simbad.bench.link.PtyLink;
import simbad.bench.protocol.FirmwareMode;
import simbad.bench.protocol.FrameLine;

@Timeout(300)
class SteadyRangerTest {
  private static final SteadyRanger.Terms QUICK =
      new SteadyRanger.Terms(
          Duration.ofSeconds(3),
          Duration.ofMillis(300),
          Duration.ofSeconds(20),
          Duration.ZERO,
          FirmwareMode.FRAME);

  @TempDir Path folder = Path.of("");

  /** Every ping has the time that belongs to its number. */
  private static void checkPings(SteadyRanger ranger, int count)
      throws IOException, InterruptedException {
    for (int i = 0; i < count; i++) {
      FrameLine.Ping ping = ranger.ping();
      assertEquals(1000 + ping.sequence(), ping.echoUs().orElseThrow(), ping.toString());
    }
  }

  /** 90 faults, ten of each kind, over a real pseudo-terminal. */
  @Test
  void faultCampaign_noWrongReadingIsAccepted() throws Exception {
    Map<Integer, FakeRanger.Fault> faults = new HashMap<>();
    Random random = new Random(3);
    for (int round = 0; round < 10; round++) {
      for (FakeRanger.Fault fault : FakeRanger.faults()) {
        int at = 1 + random.nextInt(900);
        while (faults.containsKey(at)) {
          at++;
        }
        faults.put(at, fault);
      }
    }
    List<String> told = new ArrayList<>();
    try (PtyLink pty = PtyLink.open();
        FakeRanger fake = new FakeRanger(pty, faults);
        SteadyRanger ranger = new SteadyRanger(() -> PortLink.open(pty.path()), QUICK, told::add)) {
      checkPings(ranger, 900);
      assertTrue(told.size() >= 80, told.toString());
      for (String one : told) {
        assertEquals(1, one.lines().count(), one);
      }
      fake.mute(true);
    }
  }

  @Test
  void tenSecondsOfSilence_areWaitedFor() throws Exception {
    List<String> told = new ArrayList<>();
    try (PtyLink pty = PtyLink.open();
        FakeRanger fake = new FakeRanger(pty, Map.of());
        SteadyRanger ranger = new SteadyRanger(() -> PortLink.open(pty.path()), QUICK, told::add)) {
      checkPings(ranger, 3);
      fake.mute(true);
      Thread speaks =
          new Thread(
              () -> {
                pause(10_000);
                fake.mute(false);
              });
      speaks.start();
      checkPings(ranger, 3);
      assertFalse(told.isEmpty());
      speaks.join();
      fake.mute(true);
    }
  }

  private static void pause(long ms) {
    try {
      Thread.sleep(ms);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  @Test
  void portThatVanishes_isOpenedAgainWhenItIsBack() throws Exception {
    Path link = folder.resolve("tty");
    List<String> told = new ArrayList<>();
    PtyLink first = PtyLink.open();
    Files.createSymbolicLink(link, first.path());
    FakeRanger before = new FakeRanger(first, Map.of());
    try (SteadyRanger ranger = new SteadyRanger(() -> PortLink.open(link), QUICK, told::add)) {
      checkPings(ranger, 5);
      before.close();
      Files.delete(link);
      try (PtyLink second = PtyLink.open();
          FakeRanger after = new FakeRanger(second, Map.of())) {
        Thread back =
            new Thread(
                () -> {
                  pause(1000);
                  try {
                    Files.createSymbolicLink(link, second.path());
                  } catch (IOException e) {
                    // The ranger will say that there is no port.
                  }
                });
        back.start();
        checkPings(ranger, 5);
        back.join();
        after.mute(true);
      }
    }
    assertTrue(told.toString().contains("gone"), told.toString());
  }

  @Test
  void boardThatStaysAway_isGivenUp() throws Exception {
    MemoryLink.Pair line = MemoryLink.pair();
    SteadyRanger.Terms terms =
        new SteadyRanger.Terms(
            Duration.ofSeconds(3),
            Duration.ofMillis(100),
            Duration.ofMillis(500),
            Duration.ZERO,
            FirmwareMode.FRAME);
    FakeRanger fake = new FakeRanger(line.there(), Map.of());
    try (SteadyRanger ranger = new SteadyRanger(line::here, terms, text -> {})) {
      fake.close();
      IOException fault = assertThrows(IOException.class, ranger::ping);
      assertTrue(String.valueOf(fault.getMessage()).startsWith("given up after"), fault.toString());
    }
  }

  @Test
  void lineThatStaysStuck_isGivenUpWithTheReason() throws Exception {
    Map<Integer, FakeRanger.Fault> faults = new HashMap<>();
    for (int i = 1; i <= 25; i++) {
      faults.put(i, FakeRanger.Fault.STUCK);
    }
    MemoryLink.Pair line = MemoryLink.pair();
    try (FakeRanger fake = new FakeRanger(line.there(), faults);
        SteadyRanger ranger = new SteadyRanger(line::here, QUICK, text -> {})) {
      IOException fault = assertThrows(IOException.class, ranger::ping);
      assertTrue(String.valueOf(fault.getMessage()).contains("look at its wires"));
      fake.mute(true);
    }
  }

  /** The firmware's own spacing counts, not this clock's. */
  @Test
  void spacing_isKept() throws Exception {
    MemoryLink.Pair line = MemoryLink.pair();
    SteadyRanger.Terms terms =
        new SteadyRanger.Terms(
            Duration.ofSeconds(3),
            Duration.ofSeconds(1),
            Duration.ofSeconds(9),
            Duration.ofMillis(68),
            FirmwareMode.FRAME);
    try (FakeRanger fake = new FakeRanger(line.there(), Map.of());
        SteadyRanger ranger = new SteadyRanger(line::here, terms, text -> {})) {
      long begunNs = System.nanoTime();
      checkPings(ranger, 5);
      assertTrue(System.nanoTime() - begunNs >= 4 * 68_000_000L);
      fake.mute(true);
    }
  }
}
