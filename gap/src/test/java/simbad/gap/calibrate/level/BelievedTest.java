package simbad.gap.calibrate.level;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import simbad.gap.fixture.LevelWorlds;
import simbad.sonar.level.LevelLaw;
import simbad.sonar.scene.Detection;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.scene.TableDetection;
import simbad.sonar.scene.UniformDetection;
import simbad.sonar.shape.ThresholdTable;

/** What a table says of strengths, and what it does not say. */
class BelievedTest {
  private static final LevelLaw LAW = LevelWorlds.POST.sensor().levelLaw();
  private static final Obstacle POST = LevelWorlds.POST.scene().obstacles().get(0);

  /** One metre all round, but for its four faces: these are heard to the end of a sweep. */
  private static Obstacle lobe(double metres) {
    double[] thresholds = new double[72];
    Arrays.fill(thresholds, 1);
    for (int face = 0; face < 4; face++) {
      thresholds[18 * face] = metres;
    }
    return post(new TableDetection(ThresholdTable.of(thresholds)));
  }

  private static SonarSpec sensor(double maxRangeM) {
    SonarSpec sensor = LevelWorlds.POST.sensor();
    return sensor.withRange(sensor.minRangeM(), maxRangeM);
  }

  private static Obstacle post(Detection detection) {
    return new Obstacle("post", POST.worldFromObstacle(), POST.outline(), detection);
  }

  private static double decibels(Believed believed, int orbit) {
    return believed.loss(orbit).decibels(Loss.values(LAW));
  }

  @Test
  void aTableAsLongAsTheRange_saysAtLeast() {
    Believed long4 = new Believed(lobe(3.98), sensor(4));
    Believed long6 = new Believed(lobe(3.98), sensor(6));
    int lobe = long4.symmetry().orbit(0);
    int side = long4.symmetry().orbit(4);
    assertEquals(4, decibels(long4, lobe) - decibels(long6, lobe), 1e-9);
    assertEquals(0, long4.precision(lobe), 0);
    assertTrue(long6.precision(lobe) > 0);
    assertEquals(decibels(long6, side), decibels(long4, side), 0);
    assertEquals(long6.precision(side), long4.precision(side), 0);
  }

  /** One figure for all bearings was not measured with the sensor. */
  @Test
  void oneFigureForAllBearings_isTakenAsItIs() {
    Obstacle uniform = post(new UniformDetection(4));
    assertEquals(
        decibels(new Believed(uniform, sensor(6)), 0),
        decibels(new Believed(uniform, sensor(4)), 0),
        0);
  }
}
