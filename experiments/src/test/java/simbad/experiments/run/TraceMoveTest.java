package simbad.experiments.run;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import simbad.experiments.run.TraceMove.Radii;

class TraceMoveTest {
  private static OptionalDouble[] radii(double... metres) {
    return Arrays.stream(metres).mapToObj(OptionalDouble::of).toArray(OptionalDouble[]::new);
  }

  /** The mean of the ratios is 1.425: a way that is nearer would be at more of its distance. */
  @Test
  void way_thatIsNearerIsAtLessOfItsDistance() {
    Radii radii = Radii.of(radii(0.2, 1.7), radii(0.1, 2)).orElseThrow();
    assertEquals(-0.1, radii.moveM(), 1e-12);
    assertEquals(1.9 / 2.1, radii.ratio(), 1e-12);
  }

  @Test
  void bearings_thatOnlyOneReachedDoNotCount() {
    OptionalDouble[] mine = {OptionalDouble.of(1.2), OptionalDouble.empty(), OptionalDouble.of(9)};
    OptionalDouble[] theirs = radii(1, 5, 0);
    assertEquals(Optional.of(new Radii(1.2, 1, 1)), Radii.of(mine, theirs));
    assertEquals(Optional.empty(), Radii.of(new OptionalDouble[] {mine[1]}, radii(5)));
  }
}
