package simbad.kernel.run;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

class PacerTest {
  private static void checkRepeats(double periodS) throws InterruptedException {
    Pacer pacer = new Pacer("test");
    CountDownLatch threeTimes = new CountDownLatch(3);
    pacer.start(periodS, threeTimes::countDown);
    assertTrue(pacer.isStarted());
    assertTrue(threeTimes.await(30, TimeUnit.SECONDS));
    pacer.stop();
    assertFalse(pacer.isStarted());
  }

  @Test
  void start_repeatsInTime() throws InterruptedException {
    checkRepeats(0.001);
  }

  @Test
  void start_withoutPeriod_repeatsAtOnce() throws InterruptedException {
    checkRepeats(0);
  }

  @Test
  void start_again_replacesTheTask() throws InterruptedException {
    Pacer pacer = new Pacer("test");
    CountDownLatch second = new CountDownLatch(2);
    pacer.start(0.001, () -> {});
    pacer.start(0.001, second::countDown);
    assertTrue(second.await(30, TimeUnit.SECONDS));
    pacer.stop();
    pacer.stop();
  }
}
