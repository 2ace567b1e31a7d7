package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.gap.diagnosis.DataSet;
import simbad.gap.diagnosis.DataSetFolder;
import simbad.sonar.sensing.Echo;

/** Logs as spreadsheets and serial monitors leave them, and a ladder that is diagnosed. */
class LogAsExportedTest {
  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  private String notes = "";
  private int sets;

  private DataSet read(String text, String options) throws Exception {
    Path log = Files.writeString(folder.resolve("log.csv"), text);
    List<String> words = new ArrayList<>(List.of("dataset", "csv", log.toString()));
    words.addAll(List.of(GuideShell.words(options)));
    words.addAll(List.of("--out", folder.resolve("set" + sets).toString()));
    Shell said = Shell.simbad(words.toArray(String[]::new));
    assertEquals(0, said.status(), said.err());
    notes = said.err();
    sets++;
    return new DataSetFolder(folder.resolve("set" + (sets - 1))).read();
  }

  private static String ranges(DataSet data) {
    return data.readings().stream()
        .map(row -> row.reading() instanceof Echo echo ? number(echo.rangeM()) : "-")
        .collect(Collectors.joining(" "));
  }

  private static String distances(DataSet data) {
    return data.readings().stream()
        .map(row -> number(row.pose().position().zM()))
        .collect(Collectors.joining(" "));
  }

  private static String number(double value) {
    return String.format(Locale.ROOT, "%.4f", value).replaceFirst("\\.?0+$", "");
  }

  /** As spreadsheets and serial monitors write them; the third reading is none. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "sep=;\ntrue_cm;reading_cm\n10;9,8\n20;19,7\n30;-inf\n",
        "Distance (cm),range [mm],t/ms\n10,98,0\n20,197,60\n30,Out of range!,120\n",
        "\"true_cm\",\"reading_cm\"\n\"10\",\"9,8\"\n\"20\",\"19,7\"\n\"30\",ovf\n",
        "true_cm,reading_cm\n10,9.8\n20,19.7\n30,1.#INF\n\n,\n \n,,\n\n"
      })
  void ladder_isReadAsItIsExported(String text) throws Exception {
    DataSet data = read(text, "");
    assertEquals("0.098 0.197 -", ranges(data));
    assertEquals("0.1 0.2 0.3", distances(data));
  }

  /** Thousands have a mark in some tables; a column of 1.000 and 500 is left as it is written. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "true_mm,reading_mm\n\"1,000\",\"1,012.5\"\n500,505.5\n",
        "true_mm;reading_mm\n1.000;1.012,5\n500;505,5\n",
        "true_mm;reading_mm\n1 000;1 012,5\n500;505,5\n",
        "true_mm;reading_mm\n1'000;1'012.5\n500;505.5\n"
      })
  void thousands_areRead(String text) throws Exception {
    assertEquals("1.0125 0.5055", ranges(read(text, "")));
  }

  @Test
  void pointThatMayBeOfThousands_isNoted() throws Exception {
    String log = "true_mm;reading_mm\n1.000;1.012\n500;505\n";
    assertEquals("0.001 0.505", ranges(read(log, "")));
    assertTrue(notes.contains("note: '1.012' in column 'reading_mm' is read with a decimal point"));
    assertEquals("1.012 0.505", ranges(read(log, "--decimal comma")));
    assertEquals("", notes);
    read("true_m;reading_m\n1.000;1.012\n0.500;0.505\n", "");
    assertEquals("", notes);
  }

  /** The lines of a serial monitor: times before arrows, labels before numbers, words between. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "Distance: 34.2 cm\\nOut of range\\nDistance: 34.4 cm\\n | ''",
        "Distance = 34.2cm, Duration = 2000us\\ntimeout\\nDistance = 34.4cm, Duration = 2004us\\n | ''",
        "d_cm=34.2 n=1\\nd_cm=none n=2\\nd_cm=34.4 n=3\\n | --range d_cm --only n=1..3 --skip-bad",
        "12:03:44.123 -> Distance: 34.2 cm\\n12:03:44.183 -> Out of range\\n12:03:44.243 -> Distance: 34.4 cm\\n"
            + " | --time time",
        "12:03:44.123 -> 34.2\\n12:03:44.183 -> \\n12:03:44.243 -> 34.4\\n | --time 1 --range-unit cm",
        "12:03:44.1 -> n,reading_cm\\n12:03:44.123 -> 1,34.2\\n12:03:44.183 -> 2,\\n12:03:44.243 -> 3,34.4\\n"
            + " | --time time"
      })
  void serialMonitor_isRead(String text, String options) throws Exception {
    DataSet data = read(text.replace("\\n", "\n"), "--distance 34cm " + options);
    assertTrue(ranges(data).startsWith("0.342 "), ranges(data));
    assertTrue(ranges(data).endsWith("0.344"), ranges(data));
    if (options.contains("--time")) {
      double lasts = data.readings().get(data.readings().size() - 1).timeS();
      assertEquals(0.12, lasts - data.readings().get(0).timeS(), 1e-9);
    }
  }

  /** A tape that was misread at one place is said on the console and drawn on the page. */
  @Test
  void ladderWithOnePlaceOff_namesIt() throws Exception {
    StringBuilder log = new StringBuilder("true_cm,reading_cm\n");
    for (int i = 0; i < 100; i++) {
      int distance = 20 + 10 * (i / 10);
      double off = distance == 70 ? 4 : 0;
      log.append(distance + "," + (distance + off + 0.1 * (i % 3)) + "\n");
    }
    read(log.toString(), "--pose-sigma 1mm");
    Shell said =
        Shell.simbad(
            "diagnose",
            folder.resolve("set0").toString(),
            "--out",
            folder.resolve("diagnoses").toString());
    assertEquals(0, said.status(), said.err());
    // 4 cm, the mean of 0, 1 and 2 mm, and half a step: 4.15 cm.
    String off = "(?s).*: placement p6 at 0\\.70 m reads 4\\.[12] cm too long .*";
    assertTrue(said.out().matches(off), said.out());
    String page = Files.readString(folder.resolve("diagnoses/set0").resolve("report.html"));
    assertTrue(page.contains("placement p6 at 0.70"));
    assertTrue(page.contains("Residuals by distance"));
    assertTrue(page.contains("so there is no plan"));
    assertFalse(page.contains("round the obstacle"), "no plan of a strip");
  }
}
