package simbad.bench.link;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.time.Duration;
import java.util.Random;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** What every {@link SerialLink} does. */
@Timeout(120)
abstract class SerialLinkContract {
  private static final Duration SOON = Duration.ofSeconds(20);

  /** A line: the end that is tested, and its other end. */
  record Ends(SerialLink near, SerialLink far) implements AutoCloseable {
    @Override
    public void close() {
      near.close();
      far.close();
    }
  }

  abstract Ends open() throws Exception;

  private static byte[] read(SerialLink link, int count) throws IOException {
    ByteArrayOutputStream came = new ByteArrayOutputStream();
    byte[] buffer = new byte[100];
    while (came.size() < count) {
      int n = link.read(buffer, SOON);
      assertTrue(n > 0, "only " + came.size() + " of " + count + " bytes came");
      came.write(buffer, 0, n);
    }
    return came.toByteArray();
  }

  private static byte[] anyBytes(int count) {
    byte[] bytes = new byte[count];
    new Random(7).nextBytes(bytes);
    return bytes;
  }

  @Test
  void everyByte_passesBothWays() throws Exception {
    byte[] all = new byte[256];
    for (int i = 0; i < all.length; i++) {
      all[i] = (byte) i;
    }
    try (Ends ends = open()) {
      ends.far().write(all);
      assertArrayEquals(all, read(ends.near(), all.length));
      ends.near().write(all);
      assertArrayEquals(all, read(ends.far(), all.length));
    }
  }

  @Test
  void longText_comesWholeAndInOrder() throws Exception {
    byte[] text = anyBytes(20_000);
    try (Ends ends = open()) {
      Thread writer =
          new Thread(
              () -> {
                try {
                  ends.far().write(text);
                } catch (IOException e) {
                  // The reader will miss it.
                }
              });
      writer.start();
      assertArrayEquals(text, read(ends.near(), text.length));
      writer.join();
    }
  }

  @Test
  void silence_isZeroBytes() throws Exception {
    try (Ends ends = open()) {
      assertEquals(0, ends.near().read(new byte[10], Duration.ofMillis(60)));
      assertEquals(0, ends.near().read(new byte[10], Duration.ZERO));
    }
  }

  @Test
  void bytesThatAreThere_comeWithoutWaiting() throws Exception {
    try (Ends ends = open()) {
      ends.far().write(new byte[] {1, 2});
      assertArrayEquals(new byte[] {1, 2}, read(ends.near(), 2));
      ends.far().write(new byte[] {3});
      // It may be on its way for a moment.
      byte[] buffer = new byte[10];
      int count = 0;
      for (int i = 0; i < 2000 && count == 0; i++) {
        Thread.sleep(1);
        count = ends.near().read(buffer, Duration.ZERO);
      }
      assertEquals(1, count);
      assertEquals(3, buffer[0]);
    }
  }

  @Test
  void closedLine_neitherReadsNorWrites() throws Exception {
    try (Ends ends = open()) {
      ends.near().close();
      ends.near().close();
      assertThrows(IOException.class, () -> ends.near().read(new byte[1], SOON));
      assertThrows(IOException.class, () -> ends.near().write(new byte[1]));
    }
  }

  @Test
  void close_endsAReadThatWaits() throws Exception {
    try (Ends ends = open()) {
      AtomicBoolean threw = new AtomicBoolean();
      Thread reader =
          new Thread(
              () -> {
                try {
                  ends.near().read(new byte[1], Duration.ofMinutes(10));
                } catch (IOException e) {
                  threw.set(true);
                }
              });
      reader.start();
      Thread.sleep(50);
      ends.near().close();
      reader.join(20_000);
      assertTrue(threw.get());
    }
  }

  @Test
  void otherEndThatIsGone_isAnException() throws Exception {
    try (Ends ends = open()) {
      ends.far().close();
      assertThrows(
          IOException.class,
          () -> {
            while (true) {
              ends.near().read(new byte[1], Duration.ofMillis(50));
            }
          });
    }
  }
}
