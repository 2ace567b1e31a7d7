package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.sonar.format.ReadingsFile;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;

/** The audit of data sets from the command line, and the copies that mend them. */
class DiagnoseAuditTest {
  private static final int ROWS = 240;
  private static final int RANGE = 6;

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  private Path clean = Path.of("");
  private Path out = Path.of("");

  @BeforeEach
  void write() throws IOException {
    List<ReadingRow> rows = new ArrayList<>(BenchData.rows(ROWS, 0));
    for (int i = 7; i < ROWS; i += 10) {
      ReadingRow row = rows.get(i);
      rows.set(i, new ReadingRow(row.run(), row.sensor(), row.timeS(), row.pose(), NoEcho.NO_ECHO));
    }
    clean = BenchData.write(folder.resolve("clean"), rows);
    out = folder.resolve("out");
  }

  /** A copy whose rows are other ones. */
  private Path spoilt(String name, UnaryOperator<String[]> change) throws IOException {
    Path copy = Files.createDirectories(folder.resolve(name));
    Files.copy(clean.resolve("scene.json"), copy.resolve("scene.json"));
    List<String> lines = new ArrayList<>();
    for (String line : Files.readAllLines(clean.resolve("readings.csv"))) {
      boolean isHeader = lines.isEmpty();
      lines.add(isHeader ? line : String.join(",", change.apply(line.split(",", -1))));
    }
    Files.write(copy.resolve("readings.csv"), lines);
    return copy;
  }

  private static UnaryOperator<String[]> times(int column, double factor) {
    return fields -> {
      if (!fields[column].isEmpty()) {
        fields[column] = String.valueOf(factor * Double.parseDouble(fields[column]));
      }
      return fields;
    };
  }

  private JsonNode json(String name) throws IOException {
    return new ObjectMapper().readTree(out.resolve(name).resolve("diagnosis.json").toFile());
  }

  private Shell diagnose(Path... sets) {
    List<String> words = new ArrayList<>(List.of("diagnose", "--out", out.toString()));
    for (Path set : sets) {
      words.add(set.toString());
    }
    return Shell.simbad(words.toArray(String[]::new));
  }

  private static Shell mend(Path set, Path copy, String... options) {
    List<String> words =
        new ArrayList<>(List.of("dataset", "mend", set.toString(), "--out", copy.toString()));
    words.addAll(List.of(options));
    return Shell.simbad(words.toArray(String[]::new));
  }

  /** Centimetres as metres: no verdict, status 2, the line, the command; the other set goes on. */
  @Test
  void refused_isNotDiagnosed() throws IOException {
    Path set = spoilt("centimetres", times(RANGE, 100));
    Path good = BenchData.write(folder.resolve("good"), BenchData.rows(ROWS, 0));
    Shell shell = diagnose(set, good);
    assertEquals(2, shell.status());
    String complaint = shell.complaints().get(0);
    assertTrue(complaint.startsWith("simbad diagnose: " + set + "/readings.csv:"), complaint);
    assertTrue(complaint.contains(": range_m: ranges are "), complaint);
    assertTrue(complaint.contains("centimetres written as metres"), complaint);
    assertTrue(complaint.contains("./simbad dataset mend " + set + " --out " + set), complaint);
    assertTrue(complaint.endsWith("--in readings.csv --scale 0.01"), complaint);
    assertTrue(shell.out().contains("centimetres: not diagnosed"), shell.out());
    assertTrue(shell.out().contains("\ngood: none"), shell.out());
    assertTrue(json("centimetres").path("verdict").isMissingNode());
    assertEquals("refuse", json("centimetres").at("/audit/0/severity").asText());
    assertTrue(json("centimetres").at("/audit/0/rows").asInt() > 20);
    assertEquals(0, json("good").at("/audit").size());
    assertEquals("none", json("good").at("/verdict").asText());
    String page = Files.readString(out.resolve("centimetres/report.html"));
    assertTrue(page.contains("Not diagnosed"), page);
    assertTrue(page.contains("--scale 0.01"), page);
  }

  /** What is to be mended is there, or nothing is written. */
  @Test
  void referenceThatIsNotThere_isNotMended() throws IOException {
    Path set = spoilt("bench", fields -> fields);
    Path copy = folder.resolve("copy");
    Shell shell = mend(set, copy, "--in", "reference.csv", "--scale", "0.5");
    assertEquals(2, shell.status());
    assertTrue(shell.err().contains("has no reference.csv to mend"), shell.err());
    assertFalse(Files.exists(copy));
  }

  /** Inches: said first, and diagnosed all the same. */
  @Test
  void warned_isDiagnosed() throws IOException {
    Path set = spoilt("inches", times(RANGE, 1 / 2.54));
    Shell shell = diagnose(set);
    assertEquals(0, shell.status(), shell.err());
    assertTrue(shell.out().startsWith("warn: " + set + "/readings.csv:"), shell.out());
    assertTrue(shell.out().contains("inches taken for centimetres"), shell.out());
    assertFalse(json("inches").path("verdict").isMissingNode());
    assertEquals("unit", json("inches").at("/audit/0/check").asText());
    String page = Files.readString(out.resolve("inches/report.html"));
    int audit = page.indexOf("id=\"audit\"");
    assertTrue(audit > 0 && audit < page.indexOf("class=\"verdict\""), "the audit comes first");
  }

  @Test
  void impossibleConstant_namesItsLine() throws IOException {
    Path scene = clean.resolve("scene.json");
    String text = Files.readString(scene);
    String changed = text.replaceFirst("(\"assumed_sound_speed_m_s\"\\s*:\\s*)[0-9.]+", "$11e-300");
    Files.writeString(scene, changed);
    Shell shell = diagnose(clean);
    assertEquals(2, shell.status());
    long line = changed.substring(0, changed.indexOf("assumed_sound")).lines().count();
    assertTrue(
        shell
            .complaints()
            .get(0)
            .startsWith("simbad diagnose: " + scene + ":" + line + ": sensor: "),
        shell.err());
  }

  @Test
  void auditOnly_fitsNothing() throws IOException {
    Shell shell =
        Shell.simbad("diagnose", clean.toString(), "--audit-only", "--out", out.toString());
    assertEquals(0, shell.status(), shell.err());
    assertTrue(shell.out().startsWith("clean: the audit found nothing\n"), shell.out());
    assertTrue(json("clean").path("verdict").isMissingNode());
    assertEquals(0, json("clean").at("/audit").size());
    Path other = folder.resolve("other");
    Path set = spoilt("coded", fields -> coded(fields, "7.65"));
    shell =
        Shell.simbad(
            "diagnose", set.toString(), "--audit-only", "--json", "--out", other.toString());
    assertEquals(0, shell.status(), shell.err());
    JsonNode line = new ObjectMapper().readTree(shell.out());
    assertEquals("--no-echo 7.65", line.at("/audit/0/mend").asText());
  }

  private static String[] coded(String[] fields, String code) {
    fields[RANGE] = fields[RANGE].isEmpty() ? code : fields[RANGE];
    return fields;
  }

  private static String[] swapped(String[] fields) {
    String x = fields[3];
    fields[3] = fields[4];
    fields[4] = x;
    return fields;
  }

  private static UnaryOperator<String[]> spoiling(String fault) {
    return switch (fault) {
      case "codes" ->
          fields ->
              coded(times(RANGE, 100).apply(fields), fields[2].endsWith("7.000") ? "nan" : "765");
      case "z up" -> times(4, -1);
      case "x left" -> times(3, -1);
      case "exchanged" -> DiagnoseAuditTest::swapped;
      case "clockwise" -> times(5, -1);
      case "radians" -> times(5, Math.PI / 180);
      case "millimetres" -> fields -> times(3, 1000).apply(times(4, 1000).apply(fields));
      case "milliseconds" -> times(2, 1000);
      default -> throw new IllegalArgumentException(fault);
    };
  }

  /** A mended copy reads as the clean set does, to the resolution. */
  @ParameterizedTest
  @CsvSource({
    "codes, --no-echo 765;nan --scale 0.01",
    "z up, --flip-z",
    "x left, --flip-x",
    "exchanged, --swap-xz",
    "clockwise, --heading-clockwise",
    "radians, --heading-radians",
    "millimetres, --pose-scale 0.001",
    "milliseconds, --time-scale 0.001"
  })
  void mend_givesTheCleanSetBack(String fault, String options) throws Exception {
    Path set = spoilt("spoilt", spoiling(fault));
    Shell shell = mend(set, out, options.replace(";", ",").split(" "));
    assertEquals(0, shell.status(), shell.err());
    List<ReadingRow> mended = ReadingsFile.read(out.resolve("readings.csv"));
    List<ReadingRow> rows = ReadingsFile.read(clean.resolve("readings.csv"));
    assertEquals(rows.size(), mended.size());
    for (int i = 0; i < rows.size(); i++) {
      assertSame(rows.get(i), mended.get(i));
    }
    assertEquals(
        Files.readString(clean.resolve("scene.json")), Files.readString(out.resolve("scene.json")));
  }

  private static void assertSame(ReadingRow expected, ReadingRow row) {
    assertEquals(rangeM(expected), rangeM(row), 1e-6);
    assertEquals(expected.timeS(), row.timeS(), 1e-6);
    assertEquals(expected.pose().position().xM(), row.pose().position().xM(), 1e-6);
    assertEquals(expected.pose().position().zM(), row.pose().position().zM(), 1e-6);
    double turn = expected.pose().heading().radians() - row.pose().heading().radians();
    assertEquals(1, Math.cos(turn), 1e-9);
  }

  private static double rangeM(ReadingRow row) {
    return row.reading() instanceof Echo echo ? echo.rangeM() : -1;
  }

  /** Further columns are kept; rows that stand twice go. */
  @Test
  void mend_keepsColumnsAndDropsDuplicates() throws IOException {
    Path set = Files.createDirectories(folder.resolve("twice"));
    Files.copy(clean.resolve("scene.json"), set.resolve("scene.json"));
    String head = "note,run,sensor,t_s,x_m,z_m,heading_deg,range_m\n";
    Files.writeString(
        set.resolve("readings.csv"),
        head + "a,r,s,0,0,1,90,9\na,r,s,0,0,1,90,9\nb,r,s,1,0,1,90,5\n");
    Shell shell =
        mend(
            set,
            out,
            "--drop-duplicates",
            "--no-echo-above",
            "8",
            "--scale",
            "2",
            "--offset",
            "-0.5");
    assertEquals(0, shell.status(), shell.err());
    assertEquals(
        head + "a,r,s,0,0,1,90,\nb,r,s,1,0,1,90,9.5\n",
        Files.readString(out.resolve("readings.csv")));
  }

  @ParameterizedTest
  @CsvSource({
    "--in readings.csv, nothing to mend",
    "--scale 0, --scale: 0.0 is not in",
    "--scale NaN, --scale: NaN is not in",
    "--offset inf, is not",
    "--flip-z --in scene.json, 'scene.json' is neither",
    "--heading-offset 1e10, --heading-offset: 1.0E10 is not in"
  })
  void mend_wrongUsage(String options, String complaint) {
    List<String> words = new ArrayList<>(List.of("dataset", "mend", clean.toString()));
    words.addAll(List.of("--out", out.toString()));
    words.addAll(List.of(options.split(" ")));
    Shell shell = Shell.simbad(words.toArray(String[]::new));
    assertEquals(2, shell.status());
    assertTrue(shell.err().contains(complaint), shell.err());
    assertFalse(Files.exists(out));
  }

  /** A ladder has no times; only times need them. */
  @Test
  void mend_needsTimesOnlyForTimes() throws IOException {
    Path set = Files.createDirectories(folder.resolve("ladder"));
    String scene = Files.readString(clean.resolve("scene.json"));
    Files.writeString(set.resolve("scene.json"), scene.replace("sonar-gap/1", "sonar-gap/2"));
    String head = "run,sensor,x_m,z_m,heading_deg,range_m\n";
    Files.writeString(set.resolve("readings.csv"), head + "r,s,0,1,90,9\nr,s,0,2,90,18\n");
    List<String> words = List.of("dataset", "mend", set.toString(), "--out", out.toString());
    Shell times = mended(words, "--time-scale");
    assertEquals(2, times.status());
    assertTrue(times.err().contains("readings.csv:1: t_s: column is missing"), times.err());
    Shell ranges = mended(words, "--scale");
    assertEquals(0, ranges.status(), ranges.err());
    assertEquals(
        head + "r,s,0,1,90,4.5\nr,s,0,2,90,9\n", Files.readString(out.resolve("readings.csv")));
  }

  private static Shell mended(List<String> words, String option) {
    List<String> all = new ArrayList<>(words);
    all.addAll(List.of(option, "0.5"));
    return Shell.simbad(all.toArray(String[]::new));
  }

  @Test
  void mend_namesTheFieldThatIsNoNumber() throws IOException {
    Path set = spoilt("words", fields -> coded(fields, "none"));
    Shell shell =
        Shell.simbad("dataset", "mend", set.toString(), "--out", out.toString(), "--scale", "2");
    assertEquals(2, shell.status());
    assertTrue(shell.err().contains("readings.csv:"), shell.err());
    assertTrue(shell.err().contains("range_m: 'none' is not a finite number"), shell.err());
    assertFalse(Files.exists(out));
  }

  /** Drawn, audited, counted. */
  @Test
  void blindCheck_countsAlarmsAndHits() throws IOException {
    Shell shell =
        Shell.simbad(
            "blind-check",
            "--cases",
            "3",
            "--seed",
            "2",
            "--mix",
            "none:1",
            "--audit-only",
            "--rows",
            "800-900",
            "--out",
            out.toString());
    assertEquals(0, shell.status(), shell.err());
    assertTrue(shell.out().contains("warned of falsely: clean"), shell.out());
    assertTrue(shell.out().contains("found: ranges times 100.0 "), shell.out());
    assertEquals(4, Files.readAllLines(out.resolve("audit.csv")).size());
  }
}
