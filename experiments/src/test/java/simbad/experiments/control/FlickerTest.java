package simbad.experiments.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class FlickerTest {
  private static final String SHORT_SIDES = "11101010";

  /** After so many readings, of which 1 is heard, the robot shall stand; 0 for never. */
  private static int asksAt(Flicker flicker, String readings) {
    for (int i = 0; i < readings.length(); i++) {
      if (flicker.asks(readings.charAt(i) == '1')) {
        return i + 1;
      }
    }
    return 0;
  }

  /** Sides of three steps and of one, one, one, one: asked when the fourth short one has ended. */
  @Test
  void fourShortSides_areAskedAbout() {
    assertEquals(8, asksAt(new Flicker(), SHORT_SIDES));
  }

  @Test
  void sidesOfThreeSteps_areAnEdge() {
    assertEquals(0, asksAt(new Flicker(), "111000".repeat(50)));
  }

  /** A missed echo makes a side of one step; the sides beside it make up for it. */
  @Test
  void missedEchoes_areNotAskedAbout() {
    assertEquals(0, asksAt(new Flicker(), "1111101111".repeat(50)));
  }

  @Test
  void contradictionAtOnePlace_isProof() {
    Flicker flicker = new Flicker();
    asksAt(flicker, SHORT_SIDES);
    assertTrue(flicker.asks(false));
    assertFalse(flicker.isProven());
    assertFalse(flicker.asks(true));
    assertTrue(flicker.isProven());
  }

  /** A needle of the edge: ten answers alike, and the robot goes on. */
  @Test
  void oneAnswerAtOnePlace_clearsTheSensor() {
    Flicker flicker = new Flicker();
    asksAt(flicker, SHORT_SIDES);
    int asked = 1;
    while (flicker.asks(false)) {
      asked++;
    }
    assertEquals(10, asked);
    assertFalse(flicker.isProven());
  }
}
