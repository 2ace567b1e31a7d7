package simbad.gui;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class TestSimbatchTest {
  /** A thousand steps of 0.05 s at 0.5 m/s. */
  @Test
  void example_drivesTwentyFiveMetres() {
    assertEquals(25, new TestSimbatch().run(), 1e-9);
  }
}
