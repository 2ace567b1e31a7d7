package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Every broken table ends with status 2 and one line that says where; nothing is left behind. */
class BadTableTest {
  private static final String HEAD = "bearing_deg,threshold_m\n";

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  /** What is in the file, then what the line must name: a line's number and a field, if any. */
  static Stream<Arguments> broken() {
    return Stream.of(
        table("missing column", "bearing_deg\n0\n90\n180\n270\n", ":1: threshold_m:"),
        table("other column", "bearing,threshold_m\n0,1\n90,1\n180,1\n", ":1: bearing_deg:"),
        table("no header", "0,1\n120,1\n240,1\n", ":1: bearing_deg:"),
        table("missing rows", HEAD + "0,1\n90,1\n180,1\n", ":"),
        table("missing row inside", HEAD + "0,1\n90,1\n270,1\n", ":4: bearing_deg:"),
        table("too many rows", HEAD + "0,1\n120,1\n240,1\n360,1\n", ":5: bearing_deg:"),
        table("two rows", HEAD + "0,1\n180,1\n", ":"),
        table("header only", HEAD, ":"),
        table("uneven", HEAD + "0,1\n120,1\n241,1\n", ":4: bearing_deg:"),
        table("first is not 0", HEAD + "1,1\n121,1\n241,1\n", ":2: bearing_deg:"),
        table("backwards", HEAD + "240,1\n120,1\n0,1\n", ":2: bearing_deg:"),
        table("negative bearing", HEAD + "0,1\n-120,1\n240,1\n", ":3: bearing_deg:"),
        table("duplicate", HEAD + "0,1\n120,1\n120,1\n240,1\n", ":4: bearing_deg:"),
        table("duplicate at the start", HEAD + "0,1\n0,1\n120,1\n240,1\n", ":3: bearing_deg:"),
        table("NaN", HEAD + "0,1\n120,NaN\n240,1\n", ":3: threshold_m:"),
        table("NaN bearing", HEAD + "0,1\nNaN,1\n240,1\n", ":3: bearing_deg:"),
        table("infinite", HEAD + "0,1\n120,Infinity\n240,1\n", ":3: threshold_m:"),
        table("negative", HEAD + "0,1\n120,-0.5\n240,1\n", ":3: threshold_m:"),
        table("10^9", HEAD + "0,1\n120,1000000000\n240,1\n", ":3: threshold_m:"),
        table("1e9", HEAD + "0,1\n120,1e9\n240,1\n", ":3: threshold_m:"),
        table("1e999", HEAD + "0,1\n120,1e999\n240,1\n", ":3: threshold_m:"),
        table("no number", HEAD + "0,1\n120,far\n240,1\n", ":3: threshold_m:"),
        table("empty field", HEAD + "0,1\n120,\n240,1\n", ":3: threshold_m:"),
        table("decimal commas", HEAD + "0,1,5\n120,1,5\n240,1,5\n", ":2: threshold_m:"),
        table("quoted decimal comma", HEAD + "0,\"1,5\"\n120,1\n240,1\n", ":2: threshold_m:"),
        table("semicolons", "bearing_deg;threshold_m\n0;1,5\n120;1,5\n240;1,5\n", ":"),
        table("open quote", HEAD + "0,\"1\n120,1\n240,1\n", ":"),
        table("wrong provenance", "# provenance: guessed\n" + HEAD + "0,1\n120,1\n240,1\n", ":"),
        table("comments only", "# provenance: measured\n", ":"),
        table("empty", "", ":"),
        table("blank lines", "\n\n\n", ":"));
  }

  private static Arguments table(String name, String text, String names) {
    return Arguments.argumentSet(name, text.getBytes(StandardCharsets.UTF_8), names);
  }

  static Stream<Arguments> unreadableText() {
    return Stream.of(
        Arguments.argumentSet("UTF-16", HEAD.getBytes(StandardCharsets.UTF_16), ":"),
        Arguments.argumentSet("bytes", new byte[] {(byte) 0xff, 0, 1, (byte) 0xfe}, ":"));
  }

  @ParameterizedTest
  @MethodSource({"broken", "unreadableText"})
  void run_ofABrokenTable_saysWhereAndLeavesNothing(byte[] content, String names)
      throws IOException {
    Path file = Files.write(folder.resolve("broken.csv"), content);
    checkRefused(file + names, file.toString());
  }

  private void checkRefused(String names, String... obstacles) throws IOException {
    List<String> before = listing();
    String out = folder.resolve("out").toString();
    Shell shell =
        Shell.simbad(
            Stream.of(List.of("run"), List.of(obstacles), List.of("--out", out))
                .flatMap(List::stream)
                .toArray(String[]::new));
    assertAll(
        () -> assertEquals(2, shell.status(), shell.err()),
        () -> assertEquals(1, shell.complaints().size(), shell.err()),
        () -> assertTrue(shell.err().contains(names), shell.err()),
        () -> assertFalse(shell.err().contains("fault in the program"), shell.err()),
        () -> assertEquals("", shell.out()),
        () -> assertEquals(before, listing()));
  }

  private List<String> listing() throws IOException {
    try (Stream<Path> entries = Files.walk(folder)) {
      return entries.map(Path::toString).sorted().toList();
    }
  }

  @Test
  void run_ofADirectory_isRefused() throws IOException {
    Path directory = Files.createDirectory(folder.resolve("table.csv"));
    checkRefused(
        "OBSTACLE: " + directory + ": is a folder without outline.csv and table.csv",
        directory.toString());
  }

  @Test
  void run_ofAMissingFile_isRefused() throws IOException {
    Path missing = folder.resolve("missing.csv");
    checkRefused("OBSTACLE: " + missing + ": no such file", missing.toString());
  }

  /** Root reads everything, so the file is one that cannot be read by anybody. */
  @Test
  void run_ofAnUnreadableFile_isRefused() throws IOException {
    checkRefused("/proc/self/mem: ", "/proc/self/mem");
  }

  @Test
  void run_ofABrokenTableAmongGoodOnes_isRefused() throws IOException {
    Path file = Files.writeString(folder.resolve("broken.csv"), HEAD + "0,1\n120,x\n240,1\n");
    checkRefused(file + ":3: threshold_m:", "round", file.toString());
  }

  @Test
  void run_ofAnUnknownName_listsTheNames() throws IOException {
    checkRefused(
        "OBSTACLE: 'octagon': no such obstacle, expected square, round, angle,", "octagon");
    checkRefused("'': no such obstacle", "");
  }

  @Test
  void run_ofTwoOfOneName_isRefused() throws IOException {
    checkRefused("OBSTACLE: two are called angle", "angle", "angle");
    Path own = Files.writeString(folder.resolve("Angle.csv"), HEAD + "0,1\n120,1\n240,1\n");
    checkRefused("OBSTACLE: two are called Angle", "angle", own.toString());
  }

  @Test
  void run_ofANameWithAZeroByte_isRefused() throws IOException {
    checkRefused("'a b': no such obstacle", "a\0b");
  }

  @Test
  void tableShow_ofABrokenTable_isRefused() throws IOException {
    Path file = Files.writeString(folder.resolve("broken.csv"), HEAD + "0,1\n120,x\n240,1\n");
    Shell shell = Shell.simbad("table", "show", file.toString());
    assertEquals(2, shell.status());
    assertEquals(1, shell.complaints().size());
    assertTrue(shell.err().contains(file + ":3: threshold_m:"), shell.err());
  }
}
