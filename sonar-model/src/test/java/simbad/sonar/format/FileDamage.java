package simbad.sonar.format;

import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.Random;

/**
 * Good files with random damage: each is read or refused by a {@link DataFormatException} of the
 * usual form, in finite time. The seeds are fixed.
 */
public final class FileDamage {
  private static final int FILES = 1500;

  /** What breaks parsers: put in at random places. */
  private static final String[] PIECES = {
    "NaN",
    "1e999",
    "-1",
    "-0",
    "1e-323",
    "null",
    "\"",
    "'",
    ",",
    ",,",
    ";",
    "\n",
    "\r\n",
    "\r",
    "{",
    "}",
    "[",
    "]",
    ":",
    "#",
    "# provenance: x\n",
    "\\",
    "\\u0000",
    "\u0000",
    "\u001b[2J",
    "\u2028",
    "\uFEFF",
    "\u00e4",
    "9".repeat(400),
    "n".repeat(70_000),
    "0.",
    ".5",
    "e",
    " ",
    "\t",
    "true",
    "{}",
    "[]",
    "360",
    "1e308"
  };

  private FileDamage() {}

  /**
   * Damages a file in many ways and reads what comes of it.
   *
   * @param directory for the damaged files
   * @param reader of such files
   * @param good the text of a file that is read
   */
  public static void check(Path directory, Faults.Reader reader, String good) {
    assertTimeoutPreemptively(Duration.ofMinutes(2), () -> checkAll(directory, reader, good));
  }

  private static void checkAll(Path directory, Faults.Reader reader, String good)
      throws IOException {
    int refused = 0;
    for (int seed = 0; seed < FILES; seed++) {
      byte[] bad = damaged(good.getBytes(StandardCharsets.UTF_8), new Random(seed));
      // A file of its own each: file systems wait for the disk when one is written over.
      Path file = Files.write(directory.resolve(seed + ".txt"), bad);
      try {
        reader.read(file);
      } catch (DataFormatException e) {
        Faults.checkForm(String.valueOf(e.getMessage()), file);
        refused++;
      } catch (RuntimeException | StackOverflowError e) {
        String text = new String(bad, StandardCharsets.UTF_8);
        throw new AssertionError("seed " + seed + " throws " + e + " on:\n" + text, e);
      }
      Files.delete(file);
    }
    assertTrue(refused > FILES / 4 && refused < FILES, refused + " of " + FILES + " refused");
  }

  private static byte[] damaged(byte[] good, Random random) {
    byte[] bytes = good;
    for (int i = 1 + random.nextInt(3); i > 0; i--) {
      int from = random.nextInt(bytes.length + 1);
      int to = Math.min(bytes.length, from + (random.nextBoolean() ? 1 : random.nextInt(30)));
      bytes =
          switch (random.nextInt(6)) {
            case 0 -> spliced(bytes, from, to, new byte[] {(byte) random.nextInt(256)});
            case 1 -> spliced(bytes, from, to, new byte[0]);
            case 2 -> spliced(bytes, to, to, Arrays.copyOfRange(bytes, from, to));
            case 3 -> spliced(bytes, from, random.nextInt(9) == 0 ? bytes.length : to, new byte[0]);
            default -> spliced(bytes, from, random.nextBoolean() ? from : to, piece(random));
          };
    }
    return bytes;
  }

  private static byte[] piece(Random random) {
    return PIECES[random.nextInt(PIECES.length)].getBytes(StandardCharsets.UTF_8);
  }

  private static byte[] spliced(byte[] bytes, int from, int to, byte[] instead) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    out.write(bytes, 0, from);
    out.writeBytes(instead);
    out.write(bytes, to, bytes.length - to);
    return out.toByteArray();
  }
}
