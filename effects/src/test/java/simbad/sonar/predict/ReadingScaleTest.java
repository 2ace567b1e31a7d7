package simbad.sonar.predict;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;
import simbad.sonar.change.ReadingScale;

class ReadingScaleTest {
  /** 0.237 m is given as 0.23 m and stored in inches, as if they were centimetres. */
  @Test
  void numberIsMultipliedAfterItWasGivenInSteps() {
    ReadingScale inches = new ReadingScale(1 / 2.54, 0.01);
    assertEquals(0.23 / 2.54, inches.reported(0.237), 1e-12);
    assertEquals(0.237 / 2.54, new ReadingScale(1 / 2.54, 0).reported(0.237), 1e-12);
  }

  @Test
  void one_isNeutralToTheLastBit() {
    assertEquals(0.237, new ReadingScale(1, 0.01).reported(0.237));
    assertEquals(0.237, new ReadingScale(1, 0.01).leastRange(0.237));
  }

  @Property(tries = 500)
  void leastRange_isTheLeastThatIsReportedAsMuch(
      @ForAll @DoubleRange(min = 0.2, max = 5) double scale,
      @ForAll @DoubleRange(min = 0.01, max = 4) double reportedM) {
    ReadingScale change = new ReadingScale(scale, 0.01);
    double least = change.leastRange(reportedM);
    assertTrue(change.reported(least) >= reportedM - 1e-9, () -> "at " + least);
    assertTrue(change.reported(least - 1e-6) < reportedM, () -> "under " + least);
  }
}
