package simbad.sonar.predict;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.random.RandomGenerator;
import org.jspecify.annotations.Nullable;
import simbad.sonar.model.Part;
import simbad.sonar.model.ReadingDistribution;
import simbad.sonar.model.Report;
import simbad.sonar.ping.Change;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.MemoryChange;
import simbad.sonar.ping.Mixture;
import simbad.sonar.ping.OutputChange;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;

/**
 * The nominal model with any set of changes: what is expected of the pings of a log.
 *
 * <p>Without changes, and with changes at their neutral parameters, its distributions are those of
 * {@link simbad.sonar.model.NominalModel} to the last bit. Immutable, safe for use by several
 * threads.
 */
public final class ChangedModel {
  /** The step of a reading whose sensor has none: recordings write millimetres or finer. */
  private static final double FINEST_STEP_M = 1e-3;

  /** As a share of a step: a range so near a step is that step, written with few decimals. */
  private static final double ROUNDING = 1e-9;

  private final SensingSetup believed;
  private final List<Change> changes;
  private final SonarSpec sensor;
  private final Report report;
  private final Memory memory;

  /**
   * Creates a model.
   *
   * @param believed the set-up as the simulator believes it
   * @param changes what is different in the world, in any order; of bursts, hysteresis and stale
   *     readings at most one each
   */
  public ChangedModel(SensingSetup believed, List<? extends Change> changes) {
    this.believed = believed;
    this.changes = List.copyOf(changes);
    sensor = Geometry.changedSensor(believed.sensor(), changes);
    report = report(Change.only(OutputChange.class, changes));
    memory = Memory.of(changes);
  }

  /**
   * Joins the changes of a set-up and of effects. An effect with memory stands in the place of a
   * calibration of the same kind, since a model holds one of each.
   *
   * @param calibration in what the set-up is off without an effect
   * @param effects at work
   */
  public static List<Change> changes(
      List<? extends Change> calibration, List<? extends Change> effects) {
    List<Change> changes = new ArrayList<>(calibration);
    changes.removeIf(
        change ->
            change instanceof MemoryChange
                && effects.stream().anyMatch(effect -> effect.getClass() == change.getClass()));
    changes.addAll(effects);
    return changes;
  }

  private static Report report(List<OutputChange> outputs) {
    if (outputs.isEmpty()) {
      return Report.AS_MEASURED;
    }
    return new OutputChain(
        outputs.stream().sorted(Comparator.comparingInt(OutputChange::order)).toList());
  }

  /** Several ways of reporting, one after the other. */
  private record OutputChain(List<OutputChange> outputs) implements Report {
    @Override
    public double reported(double rangeM) {
      double reported = rangeM;
      for (OutputChange output : outputs) {
        reported = output.reported(reported);
      }
      return reported;
    }

    @Override
    public double leastRange(double reportedM) {
      double least = reportedM;
      for (int i = outputs.size() - 1; i >= 0; i--) {
        least = outputs.get(i).leastRange(least);
      }
      return least;
    }
  }

  /** Returns the changes. */
  public List<Change> changes() {
    return changes;
  }

  /** Computes the geometry of a log under the changes. */
  public Geometry geometry(PingLog log) {
    return new Geometry(log, believed, changes);
  }

  /**
   * Computes the same as {@link #geometry(PingLog)} from what is known under other changes of the
   * same log and set-up.
   */
  public Geometry geometryLike(Geometry known) {
    return geometryLike(known, null);
  }

  /**
   * Computes the same of some pings.
   *
   * @param known under other changes of the same log and set-up; of these pings at least
   * @param only the pings that are asked for, null for all; what is left for others means nothing
   */
  public Geometry geometryLike(Geometry known, boolean @Nullable [] only) {
    return new Geometry(known.log(), believed, changes, known, only);
  }

  /** Tells whether what is read at a ping depends on what was seen or read at those before. */
  public boolean looksBack() {
    return hasMemory() || changes.stream().anyMatch(Change::looksBack);
  }

  /**
   * Computes how probable each reading of a log is, given all readings of its sequence before it.
   * The outcome of a ping is no echo, or the step of the sensor's resolution that the range lies in
   * (steps of 1 mm where it has none), so that every outcome has a probability.
   *
   * @param geometry of the log under this model's changes
   * @param into takes a probability in [0, 1] for each ping
   */
  public void likelihood(Geometry geometry, double[] into) {
    likelihood(geometry, into, null, null, new Answers());
  }

  /**
   * Computes the same, and how probable it was that there is an echo at all.
   *
   * @param geometry of the log under this model's changes
   * @param into takes a probability in [0, 1] for each ping
   * @param echoes takes that of any echo for each ping that read one; null if it is not asked for
   * @param only which pings are asked for, null for all; what is left for the others means nothing
   * @param known what obstacles answer, from one model to the next
   */
  public void likelihood(
      Geometry geometry,
      double[] into,
      double @Nullable [] echoes,
      boolean @Nullable [] only,
      Answers known) {
    new Likelihood(this, geometry, known).into(into, echoes, only);
  }

  /**
   * Computes what was expected of each ping of a log just before its reading came, given all
   * readings of its sequence before it.
   *
   * @param geometry of the log under this model's changes
   */
  public Expectation expectation(Geometry geometry) {
    Expectation expectation = new Expectation(geometry.log().size());
    new Likelihood(this, geometry, new Answers()).into(expectation);
    return expectation;
  }

  /**
   * Computes what is expected of each ping of a log without looking at any reading: changes with
   * memory run forward from the start of each sequence.
   *
   * @param geometry of the log under this model's changes
   * @return one distribution for each ping
   */
  public List<ReadingDistribution> forecast(Geometry geometry) {
    return new Forecast(this, geometry).all();
  }

  /**
   * Draws readings for all pings of a log, as a world with these changes might have given them.
   *
   * @param geometry of the log under this model's changes
   * @param random source of chance
   * @return what is read at each ping in metres; infinity for no echo
   */
  public double[] draw(Geometry geometry, RandomGenerator random) {
    PingLog log = geometry.log();
    PingModel pings = pings(geometry);
    Recollection recollection = new Recollection(this, pings);
    double[] rangeM = new double[log.size()];
    for (int ping = 0; ping < rangeM.length; ping++) {
      if (log.sequenceStart(ping) == ping) {
        recollection = new Recollection(this, pings);
      }
      rangeM[ping] = recollection.read(ping, log.timeS(ping), random);
    }
    return rangeM;
  }

  /** Returns whether what is read depends on the pings before. */
  public boolean hasMemory() {
    return !memory.isNone();
  }

  Memory memory() {
    return memory;
  }

  /** Room for the geometry of pings that are yet to be sent. */
  Geometry geometry(int pings) {
    return new Geometry(pings, believed, changes);
  }

  /** What is reported for a measured range, in the sensor's steps. */
  double reportedM(double measuredM) {
    double reported = report.reported(measuredM);
    double step = sensor.resolutionM();
    return Math.max(0, step > 0 ? Math.floor(reported / step + ROUNDING) * step : reported);
  }

  PingModel pings(Geometry geometry) {
    return pings(geometry, null);
  }

  PingModel pings(Geometry geometry, @Nullable Answers known) {
    return new PingModel(geometry, sensor, changes, known);
  }

  ReadingDistribution distribution(Mixture mixture) {
    List<Part> parts = new ArrayList<>(mixture.size());
    for (int i = 0; i < mixture.size(); i++) {
      parts.add(
          new Part(
              mixture.meanM(i), mixture.deviationM(i), mixture.halfWidthM(i), mixture.share(i)));
    }
    return new ReadingDistribution(parts, sensor.resolutionM(), report);
  }

  /** The least measured range of the step that a reported range lies in. */
  double stepStartM(double reportedM) {
    double step = step();
    double index = Math.floor(reportedM / step + ROUNDING);
    return index <= 0 ? Double.NEGATIVE_INFINITY : report.leastRange(index * step);
  }

  /** The least measured range beyond the step that a reported range lies in. */
  double stepEndM(double reportedM) {
    double step = step();
    return report.leastRange((Math.floor(reportedM / step + ROUNDING) + 1) * step);
  }

  /** Of the believed sensor: outcomes must not change with the model that is asked. */
  private double step() {
    double resolution = believed.sensor().resolutionM();
    return resolution > 0 ? resolution : FINEST_STEP_M;
  }
}
