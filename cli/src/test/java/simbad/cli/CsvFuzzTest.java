package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.gap.diagnosis.DataSetFolder;

/** Broken logs: status 2 with one line that names the file, or a data set that can be read. */
class CsvFuzzTest {
  private static final int EACH = 8;
  private static final String SIGNS = "0123456789.,;\t \n\r-\"abcm#e";
  private static final String LOG =
      """
      t_ms,x_cm,y_cm,th,d1,d2,T,run
      0,0,100,0,99,98.5,21,a
      60,5,100,3,99,NaN,21,a
      120,10,100,6,,101,21,a
      0,10,90,-3,89,88,22,b
      70,10,80,-6,80,81,22,b
      130,10,70,-9,765,70,22,b
      """;
  private static final List<String> JUNK =
      Junk.and(
          "\r",
          " ",
          "//",
          "'",
          "1e",
          "--",
          "0x10",
          "999999999999999999999",
          "12 cm",
          "\u20ac",
          "\u00b5s",
          "2021-03-04 12:00:01",
          "-",
          "+",
          ".",
          "e5",
          "1e999");

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  private int made;

  private void check(byte[] log, String... options) throws Exception {
    Path file = Files.write(folder.resolve("log.csv"), log);
    Path out = folder.resolve("set" + made++);
    String[] words = new String[options.length + 5];
    System.arraycopy(options, 0, words, 5, options.length);
    words[0] = "dataset";
    words[1] = "csv";
    words[2] = file.toString();
    words[3] = "--out";
    words[4] = out.toString();
    Shell said = Shell.simbad(words);
    if (said.status() == 0) {
      assertTrue(!new DataSetFolder(out).read().readings().isEmpty());
      return;
    }
    assertEquals(2, said.status(), said.err());
    assertEquals(1, said.complaints().size(), said.err());
    assertTrue(said.err().contains("log.csv") || said.err().contains("--"), said.err());
    assertTrue(Files.notExists(out));
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2})
  void randomBytes_areRefusedOrRead(int kind) throws Exception {
    Random random = new Random(kind);
    for (int i = 0; i < EACH; i++) {
      byte[] bytes = new byte[random.nextInt(300)];
      for (int at = 0; at < bytes.length; at++) {
        bytes[at] =
            kind == 0
                ? (byte) random.nextInt(256)
                : (byte) SIGNS.charAt(random.nextInt(SIGNS.length()));
      }
      if (kind == 2 && bytes.length > 2) {
        bytes[0] = 0x1f;
        bytes[1] = (byte) 0x8b;
      }
      check(bytes, "--range", "1", "--range-unit", "cm", "--distance", "30cm", "--skip-bad");
      check(bytes);
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3})
  void junkInALog_isRefusedOrRead(int most) throws Exception {
    Random random = new Random(100 + most);
    for (int i = 0; i < EACH; i++) {
      StringBuilder log = new StringBuilder(LOG);
      for (int junk = 0; junk < most; junk++) {
        int at = random.nextInt(log.length());
        int end = Math.min(log.length(), at + random.nextInt(4));
        log.replace(at, end, JUNK.get(random.nextInt(JUNK.size())));
      }
      byte[] bytes =
          log.toString().getBytes(i % 5 == 0 ? StandardCharsets.UTF_16 : StandardCharsets.UTF_8);
      check(
          bytes,
          "--range",
          "d1,d2",
          "--range-unit",
          "cm",
          "--no-echo",
          "765",
          "--time",
          "t_ms",
          "--x",
          "x_cm",
          "--y",
          "y_cm",
          "--heading",
          "th",
          "--temperature",
          "T",
          "--run",
          "run",
          "--mount",
          "d1=0,0",
          "--mount",
          "d2=0,5cm,10deg",
          "--target",
          "round:3cm");
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "--range",
        "--range-unit",
        "--no-echo",
        "--wide",
        "--time",
        "--time-unit",
        "--period",
        "--run",
        "--sensor",
        "--placement",
        "--temperature",
        "--gap-ms",
        "--pause-ms",
        "--only",
        "--without",
        "--distance",
        "--distance-unit",
        "--distance-to",
        "--moves",
        "--bearing",
        "--x",
        "--z",
        "--y",
        "--pose-unit",
        "--origin",
        "--heading",
        "--pan",
        "--angle-unit",
        "--angle-positive",
        "--angle-zero",
        "--target-turn",
        "--target-x",
        "--target-z",
        "--target-y",
        "--mount",
        "--pose-sigma",
        "--heading-sigma",
        "--target",
        "--detection",
        "--scene",
        "--sonar",
        "--min-range",
        "--max-range",
        "--resolution",
        "--cone",
        "--height",
        "--sound-speed",
        "--compensated",
        "--separator",
        "--decimal",
        "--encoding",
        "--header",
        "--skip",
        "--comment"
      })
  void junkInAnOption_isRefusedOrTaken(String option) throws Exception {
    byte[] log = "true_cm,reading_cm\n10,9\n20,19\n".getBytes(StandardCharsets.UTF_8);
    // Every third for each option, so that each of them meets some options.
    for (int i = Math.floorMod(option.hashCode(), 3); i < JUNK.size(); i += 3) {
      check(log, option + "=" + JUNK.get(i).replace("\u0000", "\u0001"));
    }
  }
}
