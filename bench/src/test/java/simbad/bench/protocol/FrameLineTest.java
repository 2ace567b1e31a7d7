package simbad.bench.protocol;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Stream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.CharRange;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class FrameLineTest {
  /** The same vectors as the firmware's host tests. */
  static Stream<String> vectors() throws IOException {
    return Files.readAllLines(Path.of("..", "firmware-pic18", "test", "vectors", "lines.csv"))
        .stream()
        .filter(row -> row.startsWith("ping,") || row.startsWith("answer,"));
  }

  @ParameterizedTest
  @MethodSource("vectors")
  void parse_isWhatTheVectorsSay(String row) {
    String[] fields = row.split(",", 6);
    FrameLine expected =
        fields[0].equals("ping")
            ? new FrameLine.Ping(
                Integer.parseInt(fields[1]),
                PingStatus.find(fields[3]).orElseThrow(),
                fields[3].equals("stuck")
                    ? OptionalInt.empty()
                    : OptionalInt.of(Integer.parseInt(fields[2])),
                Integer.parseInt(fields[4]))
            : new FrameLine.Answer(
                Integer.parseInt(fields[1]),
                Integer.parseInt(fields[2], 16),
                Integer.parseInt(fields[3]));
    assertEquals(Optional.of(expected), FrameLine.parse(fields[5]));
  }

  @Test
  void vectors_areThere() throws IOException {
    assertTrue(vectors().count() >= 15);
  }

  @Test
  void checksum_ofTheCheckText() {
    assertEquals("29B1", Checksum.of("123456789"));
  }

  private static String line(String text) {
    return text + "*" + Checksum.of(text);
  }

  @Test
  void parse_identity() {
    assertEquals(
        Optional.of(new FrameLine.Identity("simbad-ranger", "1.0", "0123abcd", "power-on")),
        FrameLine.parse(line("I simbad-ranger 1.0 0123abcd power-on")));
  }

  @Test
  void parse_whatIsNoLine_isEmpty() {
    Stream.of(
            "",
            "*",
            "49",
            "P 1 699 echo 65535",
            "P 1 699 echo 65535*6438",
            line("P 1 699 stuck 250"),
            line("P 1 low echo 250"),
            line("P 1 699 maybe 250"),
            line("P -1 699 echo 250"),
            line("P 1 123456 echo 250"),
            line("X 1 2 3"))
        .forEach(text -> assertEquals(Optional.empty(), FrameLine.parse(text), text));
  }

  /** A CRC of 16 bits sees every burst of up to 16 bits, so every single character. */
  @Property(seed = "20140901", tries = 500)
  void parse_oneWrongCharacter_isEmpty(
      @ForAll @IntRange(min = 0, max = 65535) int sequence,
      @ForAll @IntRange(min = 100, max = 20000) int echoUs,
      @ForAll @IntRange(min = 0, max = 40) int place,
      @ForAll @CharRange(from = ' ', to = '~') char wrong) {
    String line = line(String.format(Locale.ROOT, "P %d %d echo 250", sequence, echoUs));
    int at = place % line.length();
    if (line.charAt(at) != wrong) {
      assertEquals(
          Optional.empty(),
          FrameLine.parse(line.substring(0, at) + wrong + line.substring(at + 1)));
    }
  }
}
