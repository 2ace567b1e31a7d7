package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFileAttributes;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import simbad.bench.board.Board;
import simbad.bench.board.BoardKit;
import simbad.bench.board.BoardOrder;
import simbad.bench.board.BoardSetup;
import simbad.bench.board.BoardWorld;
import simbad.bench.capture.Entry;
import simbad.bench.capture.JournalText;
import simbad.bench.capture.SweepState;
import simbad.bench.link.PortLink;
import simbad.bench.protocol.PingStatus;
import simbad.experiments.bench.CaptureFolder;
import simbad.sonar.format.DataFormatException;

/**
 * The bench program as a process, the ranger's program in gpsim, between them real ports and
 * everything that goes wrong on lines, disks and benches.
 */
@Timeout(1800)
class BenchFaultTest {
  private static final BoardKit KIT = BoardKit.ofProject(Path.of(".."));

  @TempDir Path folder = Path.of("");

  /** Every ping meets another distance: a reading that is taken for another one is seen. */
  private static final class Staircase implements BoardWorld {
    /** Distances come again only after so many pings. */
    static final int STEPS = 3000;

    private final Map<Long, Double> pulsesUs = new TreeMap<>();

    @Override
    public List<BoardOrder> ping(long number, double timeS) {
      return List.of(BoardOrder.distance(0.2 + 0.001 * (number % STEPS)));
    }

    @Override
    public synchronized void pulse(long number, double pulseS) {
      pulsesUs.put(number, pulseS * 1e6);
    }

    /** The first ping after another one whose pulse is that long, within the clock's 2 us. */
    synchronized long after(long last, Entry.Taken taken) {
      for (long n = last + 1; n < last + STEPS - 10; n++) {
        if (Math.abs(pulsesUs.getOrDefault(n, 0.0) - taken.echoUs().orElse(-1)) <= 2) {
          return n;
        }
      }
      return fail("no ping after " + last + " was answered by " + taken);
    }
  }

  private static List<Entry> entries(Path journal) throws DataFormatException {
    List<Entry> entries = new ArrayList<>();
    JournalText.read(journal, entries::add);
    return entries;
  }

  private static void checkTrue(CaptureFolder capture, Staircase world) throws Exception {
    long last = 0;
    for (Entry entry : entries(capture.journal())) {
      if (entry instanceof Entry.Taken taken) {
        assertEquals(PingStatus.ECHO, taken.status(), taken.toString());
        last = world.after(last, taken);
      }
    }
  }

  private static List<FaultyLine.Fault> each(int times, int ofTheLongOnes) {
    List<FaultyLine.Fault> faults = new ArrayList<>();
    for (FaultyLine.Fault fault : FaultyLine.Fault.values()) {
      boolean isLong = fault.compareTo(FaultyLine.Fault.VANISHING) >= 0;
      faults.addAll(Collections.nCopies(isLong ? ofTheLongOnes : times, fault));
    }
    return faults;
  }

  /** All faults in one capture, which goes on by itself and takes every reading once, and right. */
  private static Void checkCampaign(Path folder, List<FaultyLine.Fault> faults, long seed)
      throws Exception {
    assumeTrue(KIT.missingPackages().isEmpty(), () -> "missing " + KIT.missingPackages());
    int readings = 6 * faults.size();
    Staircase world = new Staircase();
    CaptureFolder capture = new CaptureFolder(folder.resolve("capture"));
    Path port = folder.resolve("port");
    try (Board board = Board.start(KIT, new BoardSetup(folder.resolve("tty"), 1), world);
        FaultyLine line = FaultyLine.open(board, port, 7, faults, new Random(seed))) {
      // No reading fits the distance: it must be typed twice to be believed.
      SimbadProcess bench =
          SimbadProcess.start(
              folder,
              "100\n100\nq\n",
              "bench capture --obstacle angle --port %s --pings %d --out %s"
                  .formatted(port, readings, capture.path())
                  .split(" "));
      assertTrue(bench.process().waitFor(20, TimeUnit.MINUTES));
      assertEquals(0, bench.process().exitValue(), bench.complaints().toString());
      assertEquals(0, line.left(), "faults that did not come");
      checkTrue(capture, world);
      SweepState state = capture.read().state();
      assertEquals(readings, state.levels(0).get(0).pings());
      assertEquals(readings, state.levels(0).get(0).heard());
      assertTrue(bench.complaints().size() >= faults.size() * 8 / 10, "few complaints");
      for (String complaint : bench.complaints()) {
        assertTrue(complaint.startsWith("bench: "), complaint);
      }
    }
    return null;
  }

  @Test
  void faultsOfEveryKind_noReadingIsWrongOrLost() throws Exception {
    checkCampaign(folder, each(3, 1), 4);
  }

  /** Five captures at once: most of the time is waited for answers that do not come. */
  @Test
  @Tag("full")
  void manyFaultsOfEveryKind_noReadingIsWrongOrLost() throws Exception {
    List<Callable<Void>> fifths = new ArrayList<>();
    for (int fifth = 0; fifth < 5; fifth++) {
      Path where = Files.createDirectory(folder.resolve("fifth" + fifth));
      long seed = 5L + fifth;
      fifths.add(() -> checkCampaign(where, each(12, 2), seed));
    }
    Concurrently.run(fifths);
  }

  private SimbadProcess captureAt(Path port, String... before) throws Exception {
    Path where = Files.createTempDirectory(folder, "try");
    List<String> command = new ArrayList<>(List.of(before));
    command.addAll(
        SimbadProcess.command(
            "bench capture --obstacle angle --port %s --out %s"
                .formatted(port, where.resolve("x"))
                .split(" ")));
    return SimbadProcess.start(where, "", command);
  }

  private static void checkRefused(SimbadProcess bench, String message) throws Exception {
    assertEquals(1, bench.process().waitFor(), bench.complaints().toString());
    assertEquals(1, bench.complaints().size(), bench.complaints().toString());
    assertTrue(bench.complaints().get(0).contains(message), bench.complaints().toString());
    assertFalse(Files.exists(bench.err().resolveSibling("x")), "nothing is begun");
  }

  @Test
  void deviceThatSaysSomethingElse_isSaid() throws Exception {
    try (PseudoTerminal port = PseudoTerminal.open()) {
      SimbadProcess bench = captureAt(port.path());
      while (bench.process().isAlive()) {
        port.send("$GPGGA,123519,4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,*47\r\n");
        Thread.sleep(50);
      }
      checkRefused(bench, "no ranger answers");
    }
  }

  @Test
  void deviceThatSaysNothing_isSaid() throws Exception {
    try (PseudoTerminal port = PseudoTerminal.open()) {
      checkRefused(captureAt(port.path()), "no ranger answers");
    }
  }

  @Test
  void portThatAnotherProgramHolds_isSaid() throws Exception {
    try (PseudoTerminal port = PseudoTerminal.open();
        PortLink held = PortLink.open(port.path())) {
      checkRefused(captureAt(port.path()), "another program holds it");
      held.write(new byte[1]);
    }
  }

  /** The owner may not, the group may; root is made to obey as others do. */
  @Test
  void portWithoutPermission_namesTheGroup() throws Exception {
    try (PseudoTerminal port = PseudoTerminal.open()) {
      Files.setPosixFilePermissions(port.path(), PosixFilePermissions.fromString("---rw----"));
      PosixFileAttributes is = Files.readAttributes(port.path(), PosixFileAttributes.class);
      String[] asOthers =
          System.getProperty("user.name").equals("root")
              ? new String[] {"setpriv", "--bounding-set", "-dac_override,-dac_read_search"}
              : new String[0];
      checkRefused(
          captureAt(port.path(), asOthers),
          ": no permission; your user must be in the group " + is.group().getName() + " (");
      Files.setPosixFilePermissions(port.path(), PosixFilePermissions.fromString("---------"));
      checkRefused(
          captureAt(port.path(), asOthers),
          ": no permission; only its owner, " + is.owner().getName() + ", may open it");
    }
  }

  /** A disk of 24 kB; then it is given more room. */
  @Test
  void fullDisk_isSaidAndGoneOnWithWhenThereIsRoom() throws Exception {
    assumeTrue(KIT.missingPackages().isEmpty(), () -> "missing " + KIT.missingPackages());
    Files.createDirectory(folder.resolve("disk"));
    String simbad = String.join(" ", SimbadProcess.command());
    Process shell =
        new ProcessBuilder(
                "unshare",
                "-m",
                "sh",
                "-c",
                String.join(
                    "\n",
                    "mount -t tmpfs -o size=24k none disk || exit 77",
                    simbad
                        + " bench capture --auto --obstacle angle --bearings 3 --out disk/angle"
                        + " >out1.txt 2>err1.txt",
                    "echo $? >status.txt",
                    "cp disk/angle/journal.txt before.txt",
                    "ls -A disk/angle >left.txt",
                    "mount -o remount,size=4m disk",
                    simbad + " bench resume disk/angle >out2.txt 2>err2.txt",
                    "echo $? >>status.txt",
                    "cp -r disk/angle after"))
            .directory(folder.toFile())
            .inheritIO()
            .start();
    int status = shell.waitFor();
    assumeTrue(status != 77 && status != 1, "no file systems can be mounted here");
    assertEquals(List.of("1", "0"), Files.readAllLines(folder.resolve("status.txt")));
    List<String> said = Files.readAllLines(folder.resolve("err1.txt"));
    assertEquals(1, said.size(), said.toString());
    assertTrue(said.get(0).contains("journal.txt: cannot be written: No space left"), said.get(0));
    assertEquals(List.of("journal.txt"), Files.readAllLines(folder.resolve("left.txt")));
    List<Entry> before = entries(folder.resolve("before.txt"));
    List<Entry> after = entries(folder.resolve("after/journal.txt"));
    assertTrue(before.size() > 250, "24 kB hold some 320 readings");
    assertEquals(before, after.subList(0, before.size()));
    assertEquals(3, new CaptureFolder(folder.resolve("after")).read().state().doneCount());
  }
}
