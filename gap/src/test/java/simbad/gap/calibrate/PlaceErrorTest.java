package simbad.gap.calibrate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.LevelWorlds;
import simbad.gap.unexplained.SetupScores;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.PingLog;

/** Scores of which each place has its own shift: the spread of the shifts comes back. */
class PlaceErrorTest {
  private static final Geometry GEOMETRY =
      new Geometry(
          new PingLog(LevelWorlds.log(4000, 7)), LevelWorlds.POST, Hypothesis.NONE.changes());

  /** Each ping's slope is normal with an information of one, about its place's shift. */
  private static PlaceError error(double spread, int from) {
    Random random = new Random(5);
    double[] shift = new double[64];
    for (int i = 0; i < shift.length; i++) {
      shift[i] = spread * random.nextGaussian();
    }
    double[] slope = new double[4000];
    for (int i = 0; i < slope.length; i++) {
      int place = (int) (8 * GEOMETRY.nearestM(i));
      slope[i] = random.nextGaussian() + shift[Math.min(63, place)];
    }
    PlaceError error = new PlaceError(1);
    error.take(new SetupScores(GEOMETRY, slope, new double[slope.length]), i -> i >= from);
    return error;
  }

  @Test
  void shiftsOfPlacesAreFound() {
    double found = error(0.5, 0).excessDb();

    assertTrue(found > 0.1 && found < 1, () -> "found " + found);
  }

  @Test
  void chanceAloneIsNearlyNothing() {
    assertTrue(error(0, 0).excessDb() < 0.06);
  }

  @Test
  void nothingIsKnownOfNoPing() {
    assertEquals(0, error(0.5, 4000).excessDb());
    assertEquals(0, error(0.5, 0).rangeM());
  }
}
