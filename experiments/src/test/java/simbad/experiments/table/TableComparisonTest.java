package simbad.experiments.table;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.SplittableRandom;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import simbad.gap.diagnosis.Interval;
import simbad.obstacles.Catalogue;
import simbad.sonar.shape.ThresholdTable;

class TableComparisonTest {
  private static final ThresholdTable ANGLE = Catalogue.angleTable().table();

  @Test
  void tableWithItself_isTheSame() {
    TableComparison same = TableComparison.of(ANGLE, ANGLE);
    assertEquals(1, same.correlation(), 1e-12);
    assertEquals(0, same.medianRatioError());
    assertEquals(0, same.meanAbsoluteDifferenceM());
    assertEquals(new TableComparison.Placement(0, false, same.correlation()), same.best());
  }

  /** A table that was turned and mirrored is found to be: the angle has no symmetry of its own. */
  @Property(seed = "5", tries = 40)
  void turnAndMirror_areFound(
      @ForAll @IntRange(min = -35, max = 36) int turn, @ForAll boolean mirror) {
    double[] laid = new double[72];
    for (int i = 0; i < 72; i++) {
      int from = Math.floorMod(i + turn, 72);
      laid[mirror ? (72 - i) % 72 : i] = ANGLE.valueM(from);
    }
    TableComparison.Placement best = TableComparison.of(ANGLE, ThresholdTable.of(laid)).best();
    assertEquals(5 * turn, best.rotationDeg(), 1e-9);
    assertEquals(mirror, best.mirrored());
    assertEquals(1, best.correlation(), 1e-12);
  }

  /** All a tenth longer: ratio 1.1, perfect correlation. */
  @Test
  void scale_showsInRatioAndDifferenceOnly() {
    ThresholdTable longer =
        ThresholdTable.of(Arrays.stream(ANGLE.valuesM()).map(t -> 1.1 * t).toArray());
    TableComparison scaled = TableComparison.of(ANGLE, longer);
    assertEquals(1, scaled.correlation(), 1e-12);
    assertEquals(0.1, scaled.medianRatioError(), 1e-9);
    double mean = Arrays.stream(ANGLE.valuesM()).average().orElseThrow();
    assertEquals(0.1 * mean, scaled.meanDifferenceM(), 1e-9);
  }

  /** Against a circle of another spacing nothing correlates; differences remain. */
  @Test
  void circle_correlatesWithNothing() {
    TableComparison circle =
        TableComparison.of(ThresholdTable.uniform(4, 2), ThresholdTable.uniform(36, 1));
    assertEquals(0, circle.correlation());
    assertEquals(1, circle.medianRatioError(), 1e-12);
    assertEquals(-1, circle.meanDifferenceM(), 1e-12);
    assertEquals(4, circle.bearings().size());
  }

  /**
   * Ratios are log-normal with 0.3: half of their logarithms are over 0.6745 x 0.3. Were it held in
   * 95 of 100, more than 20 misses would come by chance less than once in a million times.
   */
  @Test
  void interval_holdsTheTruth_aboutAsOftenAsItSays() {
    SplittableRandom random = new SplittableRandom(11);
    double truth = Math.expm1(0.6745 * 0.3);
    int held = 0;
    for (int k = 0; k < 100; k++) {
      double[] off =
          Arrays.stream(ANGLE.valuesM())
              .map(t -> t * Math.exp(0.3 * random.nextGaussian()))
              .toArray();
      Interval interval =
          TableComparison.of(ANGLE, ThresholdTable.of(off)).medianRatioInterval(random);
      held += interval.low() <= truth && truth <= interval.high() ? 1 : 0;
    }
    assertTrue(held >= 80, held + " of 100");
  }

  @Test
  void interval_ofTheSameTables_isAPoint_andOfOthersTheSameForTheSameSeed() {
    assertEquals(
        new Interval(0, 0),
        TableComparison.of(ANGLE, ANGLE).medianRatioInterval(new SplittableRandom(1)));
    TableComparison other =
        TableComparison.of(ANGLE, Catalogue.find("square").orElseThrow().thresholds().table());
    Interval interval = other.correlationInterval(new SplittableRandom(1));
    assertEquals(interval, other.correlationInterval(new SplittableRandom(1)));
    assertTrue(interval.low() < other.correlation() && other.correlation() < interval.high());
  }

  /** Nothing heard at all is as good as the least distance, not minus infinity. */
  @Test
  void zeroThresholds_areCompared() {
    TableComparison zero =
        TableComparison.of(ThresholdTable.of(0, 1, 2), ThresholdTable.of(0.01, 1, 2));
    assertEquals(1, zero.correlation(), 1e-12);
    assertEquals(0, zero.medianRatioError());
  }
}
