package simbad.gap.fit;

import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import simbad.sonar.model.ReadingDistribution;
import simbad.sonar.ping.Change;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.PingLog;
import simbad.sonar.predict.Answers;
import simbad.sonar.predict.ChangedModel;
import simbad.sonar.scene.SensingSetup;

/**
 * A log before a set-up, and what of the set-up was calibrated: asks of any hypothesis how probable
 * each reading is. Immutable, safe for use by several threads.
 */
public final class CalibratedLog {
  /** Of every model: a reading that nothing explains must not decide a verdict alone. */
  private static final double BROAD = 1e-3;

  private static final double BROAD_NO_ECHO = 0.3;
  private static final double FINEST_STEP_M = 1e-3;

  private final SensingSetup setup;
  private final List<Change> calibration;
  private final PingLog log;
  private final double[] broad;
  private final Geometry plain;

  /** Many sets of effects look from the same places. */
  private final Geometries geometries;

  private final Optional<UnsureHeadings> headings;

  /** What a nat counts for: of whether there is an echo, and of where. */
  private final double echoWeight;

  private final double rangeWeight;

  /**
   * Puts a log before a set-up.
   *
   * @param setup as the simulator believes it
   * @param calibration what is different in the set-up without being an effect
   * @param log what was read
   */
  public CalibratedLog(SensingSetup setup, List<? extends Change> calibration, PingLog log) {
    this.setup = setup;
    this.calibration = List.copyOf(calibration);
    this.log = log;
    echoWeight = 1;
    rangeWeight = 1;
    plain = new Geometry(log, setup, calibration);
    geometries = new Geometries(plain, this.calibration);
    headings = UnsureHeadings.of(setup, plain);
    broad = new double[log.size()];
    double resolution = setup.sensor().resolutionM();
    double step = resolution > 0 ? resolution : FINEST_STEP_M;
    double each = (1 - BROAD_NO_ECHO) * Math.min(1, step / setup.sensor().maxRangeM());
    for (int i = 0; i < broad.length; i++) {
      broad[i] = BROAD * (log.echo(i) ? each : BROAD_NO_ECHO);
    }
  }

  private CalibratedLog(CalibratedLog other, double echoWeight, double rangeWeight) {
    setup = other.setup;
    calibration = other.calibration;
    log = other.log;
    broad = other.broad;
    plain = other.plain;
    geometries = other.geometries;
    headings = other.headings;
    this.echoWeight = echoWeight;
    this.rangeWeight = rangeWeight;
  }

  /**
   * Returns the same log for a set-up that is known to be off: what its readings have in common
   * beyond it does not count as often as there are readings.
   *
   * @param echoes by how much sums of echoes vary more than by chance, at least 1
   * @param ranges the same of where ranges lie
   */
  public CalibratedLog divided(double echoes, double ranges) {
    return new CalibratedLog(this, 1 / echoes, 1 / ranges);
  }

  /** Returns the same log, which counts for as much, with another calibration. */
  public CalibratedLog calibrated(List<? extends Change> other) {
    return new CalibratedLog(new CalibratedLog(setup, other, log), echoWeight, rangeWeight);
  }

  /** Returns whether the sensor hears by the level law, which is smooth. */
  public boolean hearsByLevels() {
    return plain.ears() != null;
  }

  /** Returns the set-up. */
  public SensingSetup setup() {
    return setup;
  }

  /** Returns the log. */
  public PingLog log() {
    return log;
  }

  /** Returns what was calibrated. */
  public List<Change> calibration() {
    return calibration;
  }

  /** Returns the model of a hypothesis. */
  public ChangedModel model(Hypothesis hypothesis) {
    return model(hypothesis.changes());
  }

  /** Returns the model of some changes. */
  public ChangedModel model(List<Change> changes) {
    return new ChangedModel(setup, ChangedModel.changes(calibration, changes));
  }

  /** Returns the geometry under a hypothesis; that of the set-up where nothing changes it. */
  public Geometry geometry(ChangedModel model) {
    return geometries.of(model);
  }

  /**
   * Computes what a hypothesis expects of each ping without looking at any reading, headings that
   * are known to some degrees only counted in.
   *
   * @param model of the hypothesis
   */
  public List<ReadingDistribution> forecast(ChangedModel model) {
    Geometry geometry = geometry(model);
    List<ReadingDistribution> straight = model.forecast(geometry);
    return headings.map(unsure -> unsure.average(model, geometry, straight)).orElse(straight);
  }

  Geometries geometries() {
    return geometries;
  }

  /**
   * Computes the log probability of each reading, natural, given the readings before it.
   *
   * @param model of a hypothesis
   * @param geometry of the log under it
   * @param into takes a finite value for each ping
   */
  public void logLikelihood(ChangedModel model, Geometry geometry, double[] into) {
    logLikelihood(model, geometry, into, null, new Answers());
  }

  /**
   * Computes the same of some readings.
   *
   * @param model of a hypothesis
   * @param geometry of the log under it
   * @param into takes a finite value for each ping
   * @param only which pings are asked for, null for all; what is left for the others means nothing
   * @param known what obstacles answer, from one model to the next
   */
  void logLikelihood(
      ChangedModel model,
      Geometry geometry,
      double[] into,
      boolean @Nullable [] only,
      Answers known) {
    boolean weighed = echoWeight != 1 || rangeWeight != 1;
    double[] echoes = weighed ? new double[into.length] : null;
    model.likelihood(geometry, into, echoes, only, known);
    headings.ifPresent(unsure -> unsure.average(model, geometry, into, echoes, only));
    double silent = -1;
    double logSilent = 0;
    for (int i = 0; i < into.length; i++) {
      if (only != null && !only[i]) {
        continue;
      }
      if (log.echo(i)) {
        into[i] = ofEcho(i, into[i], echoes);
      } else {
        // Many pings have nothing in the cone and are alike; a logarithm costs as much as the rest.
        if (into[i] != silent) {
          silent = into[i];
          logSilent = Math.log((1 - BROAD) * silent + broad[i]);
        }
        into[i] = weighed ? echoWeight * logSilent : logSilent;
      }
    }
  }

  private double ofEcho(int ping, double probability, double @Nullable [] echoes) {
    double read = Math.log((1 - BROAD) * probability + broad[ping]);
    if (echoes == null) {
      return read;
    }
    double echo = Math.log((1 - BROAD) * echoes[ping] + BROAD * (1 - BROAD_NO_ECHO));
    return echoWeight * echo + rangeWeight * (read - echo);
  }

  /** Returns the log probability of each reading under a hypothesis. */
  public double[] logLikelihood(Hypothesis hypothesis) {
    return logLikelihood(hypothesis.changes());
  }

  /** Returns the log probability of each reading if the simulator were changed so. */
  public double[] logLikelihood(List<Change> changes) {
    return logLikelihood(changes, geometry(model(changes)));
  }

  /**
   * Returns the same for changes whose geometry is known.
   *
   * @param changes of the simulator
   * @param geometry of the log under them
   */
  public double[] logLikelihood(List<Change> changes, Geometry geometry) {
    double[] into = new double[log.size()];
    logLikelihood(model(changes), geometry, into);
    return into;
  }
}
