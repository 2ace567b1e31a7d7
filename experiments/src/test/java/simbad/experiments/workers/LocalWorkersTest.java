package simbad.experiments.workers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class LocalWorkersTest {
  private static List<Long> results(int threads, long from, long to)
      throws IOException, InterruptedException {
    List<Long> results = new ArrayList<>();
    try (Workers workers = new LocalWorkers(threads)) {
      workers.run(LocalWorkersTest::unevenSquare, from, to, results::add);
    }
    return results;
  }

  /** Every seventh piece takes much longer than those after it. */
  private static long unevenSquare(long number) {
    double waste = 0;
    for (int i = 0; i < (number % 7 == 0 ? 2_000_000 : 10); i++) {
      waste += Math.sin(i);
    }
    return waste > 1e9 ? -1 : number * number;
  }

  @ParameterizedTest
  @CsvSource({"1, 0, 100", "2, 0, 100", "5, 37, 300", "3, 9, 9"})
  void results_comeOnceAndInOrder(int threads, long from, long to) throws Exception {
    List<Long> expected = LongStream.range(from, to).map(n -> n * n).boxed().toList();
    assertEquals(expected, results(threads, from, to));
  }

  @Test
  void receiverThatFails_endsTheJob() {
    AtomicInteger pieces = new AtomicInteger();
    try (Workers workers = new LocalWorkers(2)) {
      IOException fault =
          assertThrows(
              IOException.class,
              () ->
                  workers.run(
                      number -> pieces.incrementAndGet(),
                      0,
                      1_000_000,
                      result -> {
                        throw new IOException("disk full");
                      }));
      assertEquals("disk full", fault.getMessage());
    }
    assertTrue(pieces.get() < 1000, pieces + " pieces");
  }

  @Test
  void pieceThatThrows_endsTheJob() {
    try (Workers workers = new LocalWorkers(2)) {
      Job<Integer> job =
          number -> {
            throw new OutOfMemoryError("made up");
          };
      assertThrows(OutOfMemoryError.class, () -> workers.run(job, 0, 3, result -> {}));
    }
  }
}
