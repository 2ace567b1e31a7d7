package simbad.bench.board;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.random.RandomGenerator;
import simbad.sonar.check.Checks;
import simbad.sonar.model.SensorModel;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.sensing.Readings;
import simbad.sonar.sensing.Sensor;
import simbad.sonar.sensing.TransducerPoses;

/**
 * Plays a script: at each ping the sonar model says what the sensor hears of the obstacle that
 * stands there, and from how far. Equal script, model and chance, equal pings. Not thread-safe.
 *
 * <p>The model's range is taken as the distance that the sound travels; it is not rounded, because
 * the firmware rounds for itself.
 */
public final class ScriptedBench implements BoardWorld {
  private final BoardScript script;
  private final SensorModel model;
  private final SonarSpec spec;
  private final RandomGenerator random;
  private final OptionalDouble endS;

  private final TransducerPoses pose = new TransducerPoses(1);
  private final Readings reading = new Readings(1);
  private int row = -1;
  private long pings;
  private Sensor sensor;

  /**
   * Prepares to play a script.
   *
   * @param script what stands there
   * @param model when the sensor hears it
   * @param spec the sensor's figures; its resolution and its least range are not used: the board's
   *     own sensor has them
   * @param random source of chance of the model
   * @param endS when to stop the board, simulated seconds; empty for never
   */
  public ScriptedBench(
      BoardScript script,
      SensorModel model,
      SonarSpec spec,
      RandomGenerator random,
      OptionalDouble endS) {
    this.script = script;
    this.model = model;
    this.spec = ofBoard(spec);
    this.random = random;
    this.endS = Checks.number("endS", endS);
    pose.setPosition(0, 0, spec.mountHeightM(), 0);
    pose.setDirection(0, 1, 0, 0);
    sensor = bind(0);
  }

  /** The figures of a sensor whose near limit and steps are those of the board. */
  static SonarSpec ofBoard(SonarSpec spec) {
    return new SonarSpec(
        spec.name(),
        spec.coneHalfAngleRad(),
        0,
        spec.maxRangeM(),
        spec.mountHeightM(),
        spec.assumedSoundSpeedMPerS(),
        0,
        spec.rangeNoiseM(),
        spec.missRate(),
        spec.edgeWidthM(),
        spec.updatePeriodS(),
        spec.law());
  }

  private Sensor bind(int at) {
    return model.bind(spec, script.rows().get(at).bench().scene(), random);
  }

  /** Returns how many pings were decided. */
  public long pings() {
    return pings;
  }

  @Override
  public List<BoardOrder> ping(long number, double timeS) {
    pings++;
    List<BoardOrder> orders = new ArrayList<>(wake(timeS));
    sensor.ping(pose, timeS, reading);
    orders.add(reading.isEcho(0) ? BoardOrder.distance(reading.rangeM(0)) : BoardOrder.nothing());
    return orders;
  }

  @Override
  public List<BoardOrder> wake(double timeS) {
    List<BoardOrder> orders = new ArrayList<>();
    while (row + 1 < script.rows().size() && script.rows().get(row + 1).timeS() <= timeS) {
      row++;
      begin(orders);
    }
    if (endS.isPresent() && timeS >= endS.getAsDouble()) {
      orders.add(BoardOrder.stop());
    } else {
      nextTimeS().ifPresent(next -> orders.add(BoardOrder.wakeAt(next)));
    }
    return orders;
  }

  private void begin(List<BoardOrder> orders) {
    BoardScript.Row begun = script.rows().get(row);
    sensor = bind(row);
    orders.add(BoardOrder.temperature(begun.temperatureC()));
    orders.addAll(begun.event().orders());
  }

  private OptionalDouble nextTimeS() {
    if (row + 1 == script.rows().size()) {
      return endS;
    }
    double nextS = script.rows().get(row + 1).timeS();
    return OptionalDouble.of(Math.min(nextS, endS.orElse(nextS)));
  }
}
