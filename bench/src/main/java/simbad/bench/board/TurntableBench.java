package simbad.bench.board;

import java.util.ArrayList;
import java.util.List;
import java.util.random.RandomGenerator;
import simbad.sonar.model.SensorModel;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.sensing.Readings;
import simbad.sonar.sensing.Sensor;
import simbad.sonar.sensing.TransducerPoses;

/**
 * A bench whose obstacle a program moves while the board runs: each ping meets what stands there
 * when it leaves. Equal moves and chance, equal pings. Thread-safe.
 */
public final class TurntableBench implements BoardWorld {
  private final SensorModel model;
  private final SonarSpec spec;
  private final RandomGenerator random;
  private final List<BoardOrder> setting;
  private final TransducerPoses pose = new TransducerPoses(1);
  private final Readings reading = new Readings(1);
  private Sensor sensor;

  /**
   * Prepares a bench.
   *
   * @param model when the sensor hears what stands there
   * @param spec the sensor's figures, but for its resolution and least range: the board's own
   *     sensor has those
   * @param random source of chance of the model
   * @param scene what stands there at first
   * @param temperatureC of the air, degrees Celsius
   */
  public TurntableBench(
      SensorModel model,
      SonarSpec spec,
      RandomGenerator random,
      BenchScene scene,
      double temperatureC) {
    this.model = model;
    this.spec = ScriptedBench.ofBoard(spec);
    this.random = random;
    setting = List.of(BoardOrder.temperature(temperatureC));
    pose.setPosition(0, 0, spec.mountHeightM(), 0);
    pose.setDirection(0, 1, 0, 0);
    sensor = model.bind(this.spec, scene.scene(), random);
  }

  /** Puts something else there, for every ping from now on. */
  public synchronized void place(BenchScene scene) {
    sensor = model.bind(spec, scene.scene(), random);
  }

  @Override
  public synchronized List<BoardOrder> ping(long number, double timeS) {
    sensor.ping(pose, timeS, reading);
    List<BoardOrder> orders = new ArrayList<>(setting);
    orders.add(reading.isEcho(0) ? BoardOrder.distance(reading.rangeM(0)) : BoardOrder.nothing());
    return orders;
  }
}
