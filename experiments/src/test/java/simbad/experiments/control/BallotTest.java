package simbad.experiments.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class BallotTest {
  private static int readingsUntilDecided(Ballot ballot, String readings) {
    int taken = 0;
    while (!ballot.isDecided()) {
      ballot.add(readings.charAt(taken++) == '1');
    }
    return taken;
  }

  @Test
  void lead_endsIt() {
    Ballot ballot = new Ballot(3, 9);
    assertEquals(3, readingsUntilDecided(ballot, "111"));
    assertTrue(ballot.close());
    assertEquals(5, readingsUntilDecided(ballot, "01000"));
    assertFalse(ballot.close());
  }

  @Test
  void mostReadings_endIt() {
    Ballot ballot = new Ballot(3, 9);
    assertEquals(9, readingsUntilDecided(ballot, "010101011"));
    assertTrue(ballot.close());
    assertFalse(ballot.isDecided());
  }
}
