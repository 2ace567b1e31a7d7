package simbad.bench.board;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.TableFile;
import simbad.sonar.frame.Point;
import simbad.sonar.model.DetectionRule;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.shape.ThresholdTable;

class ScriptedBenchTest {
  private static ScriptedBench bench(String rows, DetectionRule rule, OptionalDouble endS)
      throws DataFormatException {
    return new ScriptedBench(
        BoardScriptTest.parse(rows), rule, BoardScriptTest.SPEC, new Random(7), endS);
  }

  private static ScriptedBench bench(String rows) throws DataFormatException {
    return bench(rows, DetectionRule.SHADOW, OptionalDouble.empty());
  }

  private static BoardOrder last(List<BoardOrder> orders) {
    return orders.get(orders.size() - 1);
  }

  /** The bearing of the sensor is the clockwise turn, as on the bench. */
  @Property(seed = "20140901", tries = 200)
  void scene_bearingIsTheClockwiseTurn(
      @ForAll @DoubleRange(min = 0, max = 6.28) double clockwiseRad,
      @ForAll @DoubleRange(min = 0.1, max = 3) double distanceM) {
    Obstacle obstacle =
        new BenchScene(Optional.of(BoardScriptTest.POST), distanceM, 0, clockwiseRad)
            .scene()
            .obstacles()
            .get(0);
    double bearing = obstacle.worldFromObstacle().bearingRad(0, 0);
    assertEquals(0, Math.sin(bearing - clockwiseRad), 1e-9);
    assertEquals(1, Math.cos(bearing - clockwiseRad), 1e-9);
    assertEquals(
        new Point(distanceM, 0), obstacle.worldFromObstacle().worldFromObstacle(new Point(0, 0)));
  }

  @Test
  void ping_distanceToTheSurface() throws Exception {
    // The post's near face is 1 cm before its axis.
    assertEquals(BoardOrder.distance(1.49), last(bench("0,post,1.5,0,0,20,none\n").ping(1, 0.01)));
  }

  @Test
  void ping_beyondTheThresholdOfItsBearing_isNothing() throws Exception {
    assertEquals(BoardOrder.nothing(), last(bench("0,post,1.5,0,90,20,none\n").ping(1, 0)));
    assertEquals(BoardOrder.distance(0.79), last(bench("0,post,0.8,0,90,20,none\n").ping(1, 0)));
    assertEquals(BoardOrder.nothing(), last(bench("0,post,2.1,0,0,20,none\n").ping(1, 0)));
    assertEquals(BoardOrder.nothing(), last(bench("0,none,1,0,0,20,none\n").ping(1, 0)));
  }

  @Test
  void ping_outOfTheCone_isNothing() throws Exception {
    assertEquals(BoardOrder.nothing(), last(bench("0,post,0.5,0.5,0,20,none\n").ping(1, 0)));
  }

  /** The same thresholds as the simulator's, at each bearing of the measured table. */
  @Test
  void ping_losesTheAngleAtItsThresholds() throws Exception {
    ThresholdTable angle =
        TableFile.read(Path.of("..", "data", "threshold-plots", "angle-25mm.csv")).table();
    BenchTarget target = new BenchTarget(BoardScriptTest.POST.outline(), angle);
    for (int i = 0; i < angle.size(); i++) {
      for (double side : new double[] {-0.001, 0.001}) {
        double distanceM = angle.valueM(i) + side;
        BenchScene scene = new BenchScene(Optional.of(target), distanceM, 0, angle.bearingRad(i));
        BoardScript script =
            new BoardScript(List.of(new BoardScript.Row(0, scene, 20, BoardEvent.NONE)));
        BoardOrder order =
            last(
                new ScriptedBench(
                        script,
                        DetectionRule.SHADOW,
                        BoardScriptTest.SPEC,
                        new Random(1),
                        OptionalDouble.empty())
                    .ping(1, 0));
        assertEquals(side > 0, order.equals(BoardOrder.nothing()), "bearing " + i);
      }
    }
  }

  @Test
  void noisyModel_sameSeedSamePings() throws Exception {
    List<List<BoardOrder>> twice = new ArrayList<>();
    for (int run = 0; run < 2; run++) {
      ScriptedBench bench =
          bench("0,post,1.99,0,0,20,none\n", DetectionRule.NOISY, OptionalDouble.empty());
      List<BoardOrder> orders = new ArrayList<>();
      for (int ping = 1; ping <= 200; ping++) {
        orders.add(last(bench.ping(ping, ping * 0.065)));
      }
      twice.add(orders);
    }
    assertEquals(twice.get(0), twice.get(1));
    assertTrue(twice.get(0).contains(BoardOrder.nothing()));
    assertTrue(twice.get(0).stream().distinct().count() > 50);
  }

  @Test
  void rows_beginAtTheirTimes() throws Exception {
    ScriptedBench bench =
        bench(
            "0,post,1,0,0,20,none\n2,post,1,0,0,30,stuck-low\n5,post,0.5,0,0,20,garbage\n",
            DetectionRule.SHADOW,
            OptionalDouble.of(6));
    List<BoardOrder> first = bench.wake(0);
    assertEquals(BoardOrder.wakeAt(2), last(first));
    assertTrue(first.contains(BoardOrder.temperature(20)));
    assertEquals(List.of(BoardOrder.wakeAt(2), BoardOrder.distance(0.99)), bench.ping(1, 1.9));
    List<BoardOrder> second = bench.ping(2, 2.0);
    assertTrue(second.contains(BoardOrder.fault(SensorFault.STUCK_LOW)));
    assertTrue(second.contains(BoardOrder.wakeAt(5)));
    List<BoardOrder> third = bench.wake(5);
    assertTrue(third.contains(BoardOrder.fault(SensorFault.NONE)));
    assertTrue(third.contains(BoardOrder.garbage(64)));
    assertEquals(BoardOrder.wakeAt(6), last(third));
    assertFalse(bench.wake(5.5).contains(BoardOrder.garbage(64)));
    assertEquals(List.of(BoardOrder.stop()), bench.wake(6));
    assertEquals(2, bench.pings());
  }

  @Test
  void orders_outOfRange_areRefused() {
    assertThrows(IllegalArgumentException.class, () -> BoardOrder.distance(-1));
    assertThrows(IllegalArgumentException.class, () -> BoardOrder.pace(Double.NaN));
    assertThrows(IllegalArgumentException.class, () -> BoardOrder.temperature(-300));
    assertThrows(IllegalArgumentException.class, () -> new BenchScene(Optional.empty(), -1, 0, 0));
    assertThrows(
        IllegalArgumentException.class,
        () -> new BenchScene(Optional.empty(), 1, 0, Double.POSITIVE_INFINITY));
    assertThrows(IllegalArgumentException.class, () -> new BoardSetup(Path.of("tty"), -1));
  }
}
