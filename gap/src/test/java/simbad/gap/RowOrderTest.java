package simbad.gap;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import simbad.definition.Effect;
import simbad.gap.audit.Audit;
import simbad.gap.diagnosis.DataSet;
import simbad.gap.diagnosis.DataSetFolder;
import simbad.gap.diagnosis.Diagnosis;
import simbad.gap.diagnosis.DiagnosisJson;
import simbad.gap.diagnosis.DiagnosisProvenance;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.Ladders;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.sensing.ReadingRow;

/**
 * The order of rows says nothing, and the order of times only what remembers or drifts. Of the
 * practice sets that stand here and of the recorded logs in data/gap; {@code -Dorder.sets=FOLDER}
 * takes all data sets of a folder as well.
 */
class RowOrderTest {
  /** What an order of times shows, or how far something was driven by then. */
  private static final Set<Effect> OF_TIME =
      Set.of(
          Effect.DROPOUT,
          Effect.HEADING_DRIFT,
          Effect.HYSTERESIS,
          Effect.LATENCY,
          Effect.ODOMETRY_SCALE,
          Effect.PREVIOUS_PING,
          Effect.RANGE_DRIFT,
          Effect.STALE_READING);

  /** A larger recorded log takes many seconds to diagnose. */
  private static final int MOST_ROWS = 1000;

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path scratch;

  static Stream<Path> practice() throws IOException, URISyntaxException {
    Path practice =
        Path.of(Objects.requireNonNull(RowOrderTest.class.getResource("/practice")).toURI());
    List<Path> all = new ArrayList<>(folders(practice));
    String more = System.getProperty("order.sets", "");
    all.addAll(more.isEmpty() ? List.of() : folders(Path.of(more)));
    return all.stream();
  }

  static Stream<Path> recorded() throws IOException {
    return folders(Path.of("..", "data", "gap")).stream();
  }

  private static List<Path> folders(Path of) throws IOException {
    try (Stream<Path> all = Files.list(of)) {
      return all.filter(one -> Files.exists(one.resolve(DataSetFolder.READINGS))).sorted().toList();
    }
  }

  private static Diagnosis diagnose(DataSet data) {
    return new Diagnoser(1, Set.of())
        .diagnose(data)
        .with(Audit.of(data.setup(), data.readings(), data.reference()));
  }

  /** All but where the rows of a finding stand, and the hash of the file. */
  private static String json(Diagnosis diagnosis, DataSet data) {
    return DiagnosisJson.text(diagnosis, data, new DiagnosisProvenance(Map.of(), "test", 1))
        .replaceAll("\"first_rows\" : \\[[^]]*]", "");
  }

  private static String answer(Diagnosis diagnosis) {
    return diagnosis.verdict() + " " + new TreeSet<>(diagnosis.explanation());
  }

  @ParameterizedTest
  @MethodSource("practice")
  void order_saysNothing(Path folder) throws Exception {
    DataSet data = new DataSetFolder(folder).read();
    Diagnosis told = checkLinesMoved(folder, data);
    if (data.readings().get(0).isTimed() && Collections.disjoint(told.explanation(), OF_TIME)) {
      List<ReadingRow> shuffled = new ArrayList<>(data.readings());
      Collections.shuffle(shuffled, new Random(7));
      checkAnswer(told, data, shuffled, "times dealt out anew");
      List<ReadingRow> sorted = new ArrayList<>(data.readings());
      sorted.sort(Comparator.comparingDouble(row -> bearingRad(data, row)));
      checkAnswer(told, data, sorted, "times by bearing");
    }
  }

  /** What is at work in them nobody knows, so nothing is said of other times. */
  @ParameterizedTest
  @MethodSource("recorded")
  void linesOfRecordedLogs_sayNothing(Path folder) throws Exception {
    DataSet data = new DataSetFolder(folder).read();
    DataSet moved = linesMoved(folder);
    assertEquals(audit(data), audit(moved));
    assertArrayEquals(believed(data), believed(moved), "likelihood of the believed model");
    if (data.readings().size() <= MOST_ROWS) {
      checkLinesMoved(folder, data);
    }
  }

  private static List<String> audit(DataSet data) {
    return Audit.of(data.setup(), data.readings(), data.reference()).stream()
        .map(one -> one.check() + " " + one.what() + " " + one.rows().size())
        .toList();
  }

  private static double[] believed(DataSet data) {
    PingLog log = new PingLog(data.readings());
    return new CalibratedLog(data.setup(), List.of(), log).logLikelihood(Hypothesis.NONE);
  }

  private Diagnosis checkLinesMoved(Path folder, DataSet data) throws Exception {
    Diagnosis told = diagnose(data);
    DataSet moved = linesMoved(folder);
    assertNotEquals(data.readings(), moved.readings(), "lines were moved");
    assertEquals(json(told, data), json(diagnose(moved), moved), "lines moved, times kept");
    return told;
  }

  private static void checkAnswer(
      Diagnosis told, DataSet data, List<ReadingRow> inOrder, String how) {
    DataSet dealt = new DataSet(data.name(), data.setup(), timed(inOrder), data.reference());
    assertEquals(answer(told), answer(diagnose(dealt)), how);
  }

  /** The data set with the lines of its files, below the header, in another order. */
  private DataSet linesMoved(Path folder) throws IOException, DataFormatException {
    Path copy = Files.createDirectories(scratch.resolve(folder.getFileName()));
    for (String name :
        List.of(DataSetFolder.SCENE, DataSetFolder.READINGS, DataSetFolder.REFERENCE)) {
      Path file = folder.resolve(name);
      if (Files.exists(file)) {
        List<String> lines = new ArrayList<>(Files.readAllLines(file));
        if (name.endsWith(".csv")) {
          lines.removeIf(line -> line.startsWith("#"));
          Collections.shuffle(lines.subList(1, lines.size()), new Random(8));
        }
        Files.write(copy.resolve(name), lines);
      }
    }
    return new DataSetFolder(copy).read();
  }

  /** The times of each run and sensor, in the order of the rows as they are given. */
  private static List<ReadingRow> timed(List<ReadingRow> rows) {
    Map<List<String>, List<ReadingRow>> sequences =
        rows.stream()
            .collect(
                Collectors.groupingBy(
                    row -> List.of(row.run(), row.sensor()),
                    LinkedHashMap::new,
                    Collectors.toList()));
    List<ReadingRow> anew = new ArrayList<>();
    for (List<ReadingRow> own : sequences.values()) {
      double[] times = own.stream().mapToDouble(ReadingRow::timeS).sorted().toArray();
      for (int i = 0; i < times.length; i++) {
        ReadingRow row = own.get(i);
        anew.add(
            new ReadingRow(
                row.run(), row.sensor(), times[i], row.pose(), row.reading(), row.circumstances()));
      }
    }
    return anew;
  }

  private static double bearingRad(DataSet data, ReadingRow row) {
    Obstacle first = data.setup().scene().obstacles().get(0);
    return first
        .worldFromObstacle()
        .bearingRad(row.pose().position().xM(), row.pose().position().zM());
  }

  /** Without times not even the lines' order stands for one. */
  @Test
  void untimedLadder_isTheSame() {
    List<ReadingRow> rows = Ladders.untimed(Ladders.read((range, lot) -> 0.985 * range - 0.009, 1));
    List<ReadingRow> other = new ArrayList<>(rows);
    Collections.shuffle(other, new Random(3));
    DataSet data = new DataSet("ladder", Ladders.BOARD, rows, List.of());
    DataSet moved = new DataSet("ladder", Ladders.BOARD, other, List.of());
    assertEquals(json(diagnose(data), data), json(diagnose(moved), moved));
  }
}
