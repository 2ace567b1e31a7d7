package simbad.bench.capture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Clock;
import java.time.Instant;
import java.time.ZoneOffset;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.bench.protocol.FrameLine;
import simbad.bench.protocol.PingStatus;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.ReadingRow;

/** Sweeps, by a program and by a person, before an obstacle of four known thresholds. */
class SweepTest {
  private static final double[] EDGES_M = {0.30, 1.00, 2.00, 0.50};
  private static final SweepPlan PLAN = SweepPlan.ofBearings(4).with(4, 2, 0.02);
  private static final Clock CLOCK =
      Clock.fixed(Instant.ofEpochSecond(1_000_000_000), ZoneOffset.UTC);
  private static final CaptureSettings SETTINGS =
      new CaptureSettings(
          PLAN, OptionalDouble.of(20), Map.of("obstacle", "post", "firmware", "fake 1.0"));

  private static final Surface SURFACE = new Surface(0.018, SETTINGS.ranging());

  @TempDir Path folder = Path.of("");

  private double standsAtM = 1;
  private int edge;
  private int sequence;
  private int pingsUntilTheEnd = Integer.MAX_VALUE;

  private FrameLine.Ping ping() throws IOException {
    if (pingsUntilTheEnd-- == 0) {
      throw new IOException("the port is gone");
    }
    sequence++;
    boolean heard = standsAtM <= EDGES_M[edge] + 1e-9;
    return new FrameLine.Ping(
        sequence,
        heard ? PingStatus.ECHO : PingStatus.NO_ECHO,
        OptionalInt.of(heard ? (int) (standsAtM * 5800) : 36_000),
        70);
  }

  private void place(double bearingDeg, double distanceM) {
    edge = (int) Math.round(bearingDeg / 90);
    standsAtM = distanceM;
  }

  private Path journal() {
    return folder.resolve("journal.txt");
  }

  private Recorder begun() throws IOException {
    Journal journal = Journal.create(journal(), SETTINGS.entry());
    return new Recorder(journal, new SweepState(), CLOCK, OptionalDouble.of(20));
  }

  private Recorder resumed() throws IOException, DataFormatException {
    return new Recorder(
        Journal.resume(JournalEntries.text(journal())),
        JournalEntries.state(journal()),
        CLOCK,
        OptionalDouble.of(20));
  }

  private CapturedTable table() throws DataFormatException {
    CapturedReadings readings = CapturedReadings.of(journal());
    return CapturedTable.of(readings.text(), readings.state());
  }

  private List<ReadingRow> rows() throws DataFormatException {
    List<ReadingRow> rows = new ArrayList<>();
    CapturedReadings.of(journal()).forEach(rows::add);
    return rows;
  }

  private void checkTable() throws DataFormatException {
    CapturedTable table = table();
    for (int i = 0; i < EDGES_M.length; i++) {
      ThresholdFit fit = table.fits().get(i);
      assertTrue(
          fit.lowM() <= EDGES_M[i] + 1e-9 && EDGES_M[i] <= fit.highM() + 1e-9, fit.toString());
    }
    assertEquals("captured", table.document().provenanceWord());
    assertTrue(table.text().contains("# firmware: fake 1.0\n"), table.text());
  }

  @Test
  void unattendedSweep_findsTheThresholds() throws Exception {
    try (Recorder recorder = begun()) {
      new Sweep(PLAN, recorder, this::ping, this::place).run((bearing, fit, state) -> {});
    }
    checkTable();
  }

  /** Interrupted after every 17th ping: what comes out is the same, no reading is taken twice. */
  @Test
  void sweepThatIsInterrupted_goesOnWhereItWas() throws Exception {
    try (Recorder recorder = begun()) {
      assertFalse(recorder.state().isDone(0));
    }
    boolean done = false;
    int interruptions = 0;
    while (!done) {
      pingsUntilTheEnd = 17;
      try (Recorder recorder = resumed()) {
        new Sweep(PLAN, recorder, this::ping, this::place).run((bearing, fit, state) -> {});
        done = true;
      } catch (IOException e) {
        interruptions++;
      }
    }
    assertTrue(interruptions > 10);
    checkTable();
    for (int bearing = 0; bearing < 4; bearing++) {
      for (Level level : JournalEntries.state(journal()).levels(bearing)) {
        assertEquals(PLAN.pings(), level.pings(), level.toString());
      }
    }
  }

  @Test
  void tableOfAHalf_isRefusedWithWhatIsMissing() throws Exception {
    try (Recorder recorder = begun()) {
      pingsUntilTheEnd = 100;
      assertThrows(
          IOException.class,
          () ->
              new Sweep(PLAN, recorder, this::ping, this::place).run((bearing, fit, state) -> {}));
    }
    DataFormatException fault = assertThrows(DataFormatException.class, this::table);
    assertTrue(String.valueOf(fault.getMessage()).contains("of 4 bearings are done"));
  }

  /** A person who types lines; the obstacle stands where the last number says. */
  private final class Typist implements Operator {
    private final Deque<String> lines;
    private final List<String> said = new ArrayList<>();
    private DoubleUnaryOperator isAt = typedCm -> typedCm / 100;

    Typist(String... lines) {
      this.lines = new ArrayDeque<>(Arrays.asList(lines));
    }

    @Override
    public void show(SweepView view) {
      edge = view.bearing();
      said.addAll(view.text());
    }

    @Override
    public String ask(PingSource live) {
      String line = lines.isEmpty() ? "q" : lines.remove();
      if (line.matches("\\d+")) {
        standsAtM = isAt.applyAsDouble(Integer.parseInt(line));
      }
      return line;
    }

    @Override
    public void pause() {
      said.add("paused before " + ask(SweepTest.this::ping));
    }

    @Override
    public void say(String text) {
      said.add(text);
    }

    @Override
    public void heard(Entry.Taken taken) {}

    @Override
    public void lost(Level level) {
      said.add("LOST at " + level.distanceM());
    }
  }

  private boolean guide(Recorder recorder, Typist typist) throws IOException, InterruptedException {
    return new GuidedSweep(PLAN, recorder, this::ping, typist, SURFACE).run();
  }

  @Test
  void personWhoTypes_getsATableToo() throws Exception {
    Typist typist =
        new Typist(
            "28", "30", "", "32", "34", "30", "", // bearing 0; done too early at first
            "t 21.5", "98", "100", "102", "", "198", "200", "202", "d", "r 90", "96", "100", "102",
            "", "48", "50", "52", "");
    try (Recorder recorder = begun()) {
      assertTrue(guide(recorder, typist));
    }
    checkTable();
    String said = String.join("\n", typist.said);
    assertTrue(said.contains("not done: this bearing needs"), said);
    assertTrue(said.contains("LOST at 0.32"), said);
    assertTrue(said.contains("4 of 4 heard at 98.0 cm"), said);
    assertTrue(said.contains("AXIS OF ROTATION"), said);
    assertTrue(said.contains("Turn it clockwise"), said);
    assertTrue(said.contains("3 of 4 bearings done"), said);
  }

  @Test
  void undoneDistance_countsNowhere() throws Exception {
    try (Recorder recorder = begun()) {
      assertFalse(guide(recorder, new Typist("28", "66", "u", "29", "q")));
      assertEquals(
          List.of(0.28, 0.29), recorder.state().levels(0).stream().map(Level::distanceM).toList());
    }
    List<ReadingRow> rows = rows();
    assertEquals(8, rows.size());
    assertTrue(rows.stream().allMatch(row -> row.reading() instanceof Echo));
  }

  /** 28 cm on the tape and 4 m typed; then 4 m again, which is believed. */
  @Test
  void distanceThatTheReadingContradicts_isAskedForAgain() throws Exception {
    Typist typist = new Typist("28", "400", "27", "400", "400", "q");
    typist.isAt = typed -> typed == 400 ? 0.28 : typed / 100;
    try (Recorder recorder = begun()) {
      assertFalse(guide(recorder, typist));
      assertEquals(
          List.of(0.28, 0.27, 4.0),
          recorder.state().levels(0).stream().map(Level::distanceM).toList());
    }
    String said = String.join("\n", typist.said);
    assertTrue(
        said.contains(
            "not taken: axis at 400.0 cm, but the sensor reads 27.9 cm to the surface; "
                + "type the distance again"),
        said);
  }

  @ParameterizedTest
  @CsvSource({
    "1.00, 1.00, true", // the axis itself, of a hollow section
    "1.00, 1.09, true",
    "1.00, 1.11, false",
    "1.00, 0.91, true",
    "1.00, 0.89, false",
    "0.10, 0.15, true",
    "3.00, 2.83, true",
    "3.00, 2.79, false"
  })
  void surface_isNearItsAxis(double axisM, double rangeM, boolean possible) {
    Ranging ranging = SETTINGS.ranging();
    int us = (int) (2e6 * rangeM / ranging.soundSpeedMPerS());
    FrameLine.Ping echo = new FrameLine.Ping(1, PingStatus.ECHO, OptionalInt.of(us), 70);
    FrameLine.Ping none = new FrameLine.Ping(2, PingStatus.NO_ECHO, OptionalInt.of(36_000), 70);
    assertEquals(
        possible, SURFACE.findContradiction(List.of(none, echo), axisM).isEmpty(), "of an echo");
    assertTrue(SURFACE.findContradiction(List.of(none), axisM).isEmpty(), "no echo, no doubt");
  }

  @Test
  void nonsense_isSaidAndNothingIsRecorded() throws Exception {
    Typist typist =
        new Typist("p", "7", "u", "far", "-3", "0", "99999", "r 7", "r", "t cold", "x 3", "q");
    try (Recorder recorder = begun()) {
      assertFalse(guide(recorder, typist));
      assertEquals(0, recorder.state().pings());
    }
    String said = String.join("\n", typist.said);
    assertTrue(said.contains("paused before 7\ngoing on"), said);
    assertTrue(said.contains("nothing to undo"), said);
    assertTrue(said.contains("'far' is neither a distance"), said);
    assertTrue(said.contains("r and a bearing"), said);
    assertTrue(said.contains("t and the temperature"), said);
  }

  /** Bearing 90 is the obstacle's +x; the sensor there looks along -x. */
  @Test
  void poses_areThoseOfTheObstaclesFrame() throws Exception {
    try (Recorder recorder = begun()) {
      edge = 1;
      standsAtM = 0.5;
      recorder.record(1, new TriedDistance(0.5, Approach.OUT), ping());
    }
    ReadingRow row = rows().get(0);
    assertEquals(0.5, row.pose().position().xM(), 1e-12);
    assertEquals(0, row.pose().position().zM(), 1e-12);
    double headingRad = row.pose().heading().radians();
    assertEquals(-1, Math.cos(headingRad), 1e-12);
    assertEquals(0, Math.sin(headingRad), 1e-12);
    // 2900 us at 343.2 m/s there and back.
    assertEquals(0.4976, ((Echo) row.reading()).rangeM(), 1e-3);
  }

  @Test
  void settings_surviveTheJournal() throws Exception {
    begun().close();
    CaptureSettings read = CaptureSettings.of(JournalEntries.text(journal()));
    assertEquals(SETTINGS.plan(), read.plan());
    assertEquals(SETTINGS.temperatureC(), read.temperatureC());
    assertEquals(SETTINGS.origin(), read.origin());
    Path other = folder.resolve("other");
    Journal.create(other, new Entry.Begun(Map.of("format", "else"))).close();
    assertThrows(DataFormatException.class, () -> CaptureSettings.of(JournalEntries.text(other)));
    Path bad = folder.resolve("bad");
    Journal.create(bad, new Entry.Begun(Map.of("format", "bench-journal/1"))).close();
    assertThrows(DataFormatException.class, () -> CaptureSettings.of(JournalEntries.text(bad)));
  }
}
