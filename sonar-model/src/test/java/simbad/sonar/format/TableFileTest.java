package simbad.sonar.format;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.sonar.fixture.Refusal;
import simbad.sonar.fixture.Shapes;
import simbad.sonar.shape.ThresholdBand;
import simbad.sonar.shape.ThresholdTable;

class TableFileTest {
  private static final double[] ONE_TO_FOUR = {1, 2, 3, 4};

  @TempDir private Path directory = Path.of("target");

  private TableDocument read(String text) throws Exception {
    return TableFile.read(Faults.file(directory, text));
  }

  private void check(String text) throws Exception {
    assertArrayEquals(ONE_TO_FOUR, read(text).table().valuesM(), text);
  }

  @Test
  void table_isRead_howeverItIsWritten() throws Exception {
    check("bearing_deg,threshold_m\n0,1\n90,2\n180,3\n270,4\n");
    check("bearing_deg,threshold_m\n0,1\n90,2\n180,3\n270,4");
    check("\uFEFFbearing_deg,threshold_m\n0,1\n90,2\n180,3\n270,4\n");
    check("bearing_deg,threshold_m\r\n0,1\r\n90,2\r\n180,3\r\n270,4\r\n");
    check("bearing_deg,threshold_m\r0,1\r90,2\r180,3\r270,4\r");
    check("\"bearing_deg\",\"threshold_m\"\n\"0\",\"1\"\n90,\"2\"\n180,3\n\"270\",4\n");
    check("\nbearing_deg,threshold_m\n\n0,1\n90,2\n\n180,3\n270,4\n\n\n");
    check(" bearing_deg , threshold_m \n 0 ,\t1\n 90, 2 \n180 , 3\n270,4 \n");
    check("bearing_deg,threshold_m\n0,1\n  \n90,2\n180,3\n270,4\n \t \n");
    check("bearing_deg,threshold_m\n0,1.\n9e1,+2\n180.0,3e0\n.27e3,4.000\n");
    check("threshold_m,note,bearing_deg\n1,front,0\n2,,90\n3,\"a,b\",180\n4,x,270\n");
    check("# made by hand\nbearing_deg,threshold_m\n0,1\n90,2\n# halfway\n180,3\n270,4\n");
  }

  @Test
  void header_isReadInItsOrder() throws Exception {
    TableDocument document =
        read(
            """
            #object: 25 mm angle
            # source : Kranz 2014: appendix A.2\s
            # provenance: measured
            # no key here
            # : no key either
            # empty:
            # note: a
            # note: b, c
            bearing_deg,threshold_m
            0,1
            120,0
            240,100
            """);
    assertEquals(
        List.of("object", "source", "provenance", "empty", "note"),
        List.copyOf(document.header().keySet()));
    assertEquals(Optional.of("Kranz 2014: appendix A.2"), document.header("source"));
    assertEquals(Optional.of("a; b, c"), document.header("note"));
    assertEquals(Optional.of(Provenance.MEASURED), document.provenance());
    assertEquals("measured", document.provenanceWord());
    assertEquals(Optional.empty(), document.header("date"));
  }

  @Test
  void provenance_notStated_isSaid() throws Exception {
    TableDocument document = read("bearing_deg,threshold_m\n0,1\n120,1\n240,1\n");
    assertEquals(Optional.empty(), document.provenance());
    assertEquals("provenance not stated", document.provenanceWord());
  }

  @ParameterizedTest
  @EnumSource
  void everyProvenance_goesThereAndBack(Provenance provenance) throws Exception {
    Map<String, String> header = Map.of("provenance", provenance.word());
    TableDocument document = new TableDocument(ThresholdTable.uniform(72, 1), header);
    Path file = directory.resolve("table.csv");
    TableFile.write(file, document);
    assertEquals(Optional.of(provenance), TableFile.read(file).provenance());
  }

  /**
   * What is written is read again to the last digit, with its header. Each write waits for the
   * disk.
   */
  @Property(tries = 60, seed = "20140617")
  void table_goesThereAndBack(@ForAll Random random) throws Exception {
    int size = random.nextInt(3, 400);
    ThresholdTable table = Shapes.anyTable(random, size, true);
    Map<String, String> header = new LinkedHashMap<>();
    for (int i = random.nextInt(4); i > 0; i--) {
      header.put(anyText(random) + i, anyText(random) + ": " + anyText(random));
    }
    TableDocument document = new TableDocument(table, header);
    Path file = Files.createTempFile(Path.of("target"), "table", ".csv");
    try {
      TableFile.write(file, document);
      TableDocument again = TableFile.read(file);
      assertEquals(document, again);
      assertEquals(List.copyOf(header.keySet()), List.copyOf(again.header().keySet()));
    } finally {
      Files.delete(file);
    }
  }

  private static String anyText(Random random) {
    String letters = "aZ9#,;\"'=\u00e4\u03c0\u20ac_-.()";
    StringBuilder text = new StringBuilder("k");
    for (int i = random.nextInt(12); i > 0; i--) {
      text.append(letters.charAt(random.nextInt(letters.length())));
    }
    return text.toString();
  }

  @Test
  void band_isReadAndWrittenBesideTheThresholds() throws Exception {
    String text =
        """
        bearing_deg,threshold_m,threshold_low_m,threshold_high_m
        0,1.0,0.5,1.5
        120,2.0,2.0,2.0
        240,3.0,0.0,100.0
        """;
    TableDocument document = read(text);
    ThresholdBand band = document.band().orElseThrow();
    assertArrayEquals(new double[] {0.5, 2, 0}, band.low().valuesM());
    assertArrayEquals(new double[] {1.5, 2, 100}, band.high().valuesM());
    assertEquals(text, TableFile.text(document));
    assertTrue(band.holds(0, 0.5) && band.holds(0, 1.5));
    assertFalse(band.holds(0, 0.49) || band.holds(0, 1.51));
  }

  /** One end alone is another column, as any. */
  @Test
  void bandOfOneEnd_isNone() throws Exception {
    String text = "bearing_deg,threshold_m,threshold_low_m\n0,1,a\n120,2,b\n240,3,c\n";
    assertEquals(Optional.empty(), read(text).band());
  }

  @Test
  void badBand_isRefusedWithItsLine() throws Exception {
    String columns = "bearing_deg,threshold_m,threshold_low_m,threshold_high_m\n";
    Faults.check(
        TableFile::read,
        Faults.file(directory, columns + "0,1,0.5,1.5\n120,2,2.1,2\n240,3,3,3\n"),
        ":3: threshold_low_m",
        "2.1 is above threshold_high_m = 2.0");
    Faults.check(
        TableFile::read,
        Faults.file(directory, columns + "0,1,0.5,1.5\n120,2,2,2\n240,3,3,-\n"),
        ":4: threshold_high_m",
        "'-' is not a distance");
    ThresholdBand three =
        new ThresholdBand(ThresholdTable.uniform(3, 1), ThresholdTable.uniform(3, 2));
    Refusal.check(
        () -> new TableDocument(ThresholdTable.uniform(4, 1), Map.of(), Optional.of(three)),
        "band has 3 bearings");
    Refusal.check(() -> new ThresholdBand(three.high(), three.low()), "is above high");
    Refusal.check(() -> new ThresholdBand(three.low(), ThresholdTable.uniform(4, 2)), "high 4");
  }

  @Test
  void writtenTable_hasWholeDegrees() throws IOException {
    Path file = directory.resolve("table.csv");
    TableFile.write(file, new TableDocument(ThresholdTable.uniform(72, 0.5), Map.of("unit", "m")));
    List<String> lines = Files.readAllLines(file);
    assertEquals("# unit: m", lines.get(0));
    assertEquals("bearing_deg,threshold_m", lines.get(1));
    assertEquals("5,0.5", lines.get(3));
    assertEquals("355,0.5", lines.get(73));
    assertEquals(74, lines.size());
  }

  /** A header line that a file cannot hold would not come back: it is refused at once. */
  @ParameterizedTest
  @ValueSource(strings = {"", " ", "a:b", "a\nb", " a", "a "})
  void headerKey_thatNoFileHolds_isRefused(String key) {
    Refusal.check(
        () -> new TableDocument(ThresholdTable.uniform(3, 1), Map.of(key, "x")), "header key");
  }

  @ParameterizedTest
  @ValueSource(strings = {"a\nb", "a\r", " a", "a ", "\n0,7\n"})
  void headerValue_thatNoFileHolds_isRefused(String value) {
    Refusal.check(
        () -> new TableDocument(ThresholdTable.uniform(3, 1), Map.of("source", value)),
        "header source");
  }

  @Test
  void provenance_thatIsNone_isRefused() {
    Refusal.check(
        () -> new TableDocument(ThresholdTable.uniform(3, 1), Map.of("provenance", "guessed")),
        "provenance = guessed",
        "measured, captured, reconstructed, predicted");
  }

  @Test
  void header_isCopied() {
    Map<String, String> header = new LinkedHashMap<>(Map.of("unit", "m"));
    TableDocument document = new TableDocument(ThresholdTable.uniform(3, 1), header);
    header.clear();
    assertEquals(Map.of("unit", "m"), document.header());
    assertThrows(UnsupportedOperationException.class, () -> document.header().put("a", "b"));
  }

  @Test
  void table_intoADirectoryThatIsNotThere_isRefused() {
    Path file = directory.resolve("nowhere").resolve("table.csv");
    TableDocument document = new TableDocument(ThresholdTable.uniform(3, 1), Map.of());
    IOException refused = assertThrows(IOException.class, () -> TableFile.write(file, document));
    assertTrue(String.valueOf(refused.getMessage()).contains("nowhere"));
  }
}
