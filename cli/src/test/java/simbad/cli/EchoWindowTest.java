package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class EchoWindowTest {
  private static int lossesIn(EchoWindow window, String pings) {
    int losses = 0;
    for (int i = 0; i < pings.length(); i++) {
      losses += window.losesWith(pings.charAt(i) == '+') ? 1 : 0;
    }
    return losses;
  }

  @Test
  void singleMisses_loseNothing() {
    EchoWindow window = new EchoWindow(10, 5);
    assertEquals(0, lossesIn(window, "++++-+++-++-+-++++"));
    assertFalse(window.isLost());
    assertEquals("7 of the last 10 heard", window.text());
  }

  @Test
  void loss_isToldOnceAndAgainAfterTheEchoWasBack() {
    EchoWindow window = new EchoWindow(10, 5);
    assertEquals(1, lossesIn(window, "++++++-----------"));
    assertTrue(window.isLost());
    assertEquals(1, lossesIn(window, "++++++++++----------"));
  }

  /** 200 of 1000 are a fifth: 4 of 20. */
  @Test
  void longSeries_isLookedAtInItsLastTwenty() {
    EchoWindow window = new EchoWindow(1000, 200);
    assertEquals(0, lossesIn(window, "+".repeat(30) + "---"));
    assertEquals(1, lossesIn(window, "-"));
  }
}
