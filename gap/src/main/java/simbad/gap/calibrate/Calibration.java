package simbad.gap.calibrate;

import java.util.List;
import java.util.Optional;
import simbad.definition.Effect;
import simbad.gap.calibrate.level.Leeway;
import simbad.gap.calibrate.level.LevelCalibration;
import simbad.gap.calibrate.level.LevelCalibrator;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Fitter;
import simbad.gap.fit.Fold;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fit.JointFitter;
import simbad.gap.fit.Placements;
import simbad.gap.score.Blocks;
import simbad.gap.score.GapGain;
import simbad.gap.score.PlacementScatter;
import simbad.gap.unexplained.Clumping;
import simbad.gap.unexplained.Constants;
import simbad.gap.unexplained.SetupDoubt;
import simbad.gap.unexplained.Surprise;
import simbad.sonar.catalogue.LevelForms;
import simbad.sonar.catalogue.SetupForms;
import simbad.sonar.effect.Definitions;
import simbad.sonar.effect.Form;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SensorLaw;

/**
 * What a reference log says of the set-up: in what it is a little off while the simulation is
 * trusted, and how far its readings hang together.
 */
public final class Calibration implements SetupDoubt {
  /** What an effect must gain beside a set-up that is fitted to the log as well. */
  private static final double SUPERFLUOUS_NATS = 15;

  private final Optional<CalibratedLog> reference;
  private final Hypothesis setup;
  private final double clumping;
  private final double rangeClumping;

  private final Optional<ModelError> heldOut;

  /** How far the reference leaves a level law open. */
  private final Optional<Leeway> leeway;

  /** Of a set-up without a reference, whose readings hang together by a factor. */
  private Calibration(Hypothesis setup, double clumping) {
    reference = Optional.empty();
    heldOut = Optional.empty();
    leeway = Optional.empty();
    this.setup = setup;
    this.clumping = clumping;
    rangeClumping = clumping;
  }

  private Calibration(
      Optional<CalibratedLog> reference,
      Hypothesis setup,
      Optional<ModelError> heldOut,
      Optional<Leeway> leeway) {
    this.reference = reference;
    this.setup = setup;
    this.heldOut = heldOut;
    this.leeway = leeway;
    Optional<Surprise> surprise = reference.map(given -> new Surprise(given, setup));
    // Where rows were held out, they say more, and all evidence is divided by it already.
    clumping = heldOut.isPresent() ? 1 : surprise.map(Clumping::ofEchoes).orElse(1.0);
    rangeClumping = heldOut.isPresent() ? 1 : surprise.map(Clumping::ofRanges).orElse(1.0);
  }

  /** Returns the calibration of a set-up without a reference: it is as it is believed to be. */
  public static Calibration none() {
    return new Calibration(Optional.empty(), Hypothesis.NONE, Optional.empty(), Optional.empty());
  }

  /**
   * Returns the calibration of a set-up without a reference, which may believe in the level law. A
   * log itself says how far readings of one placement hang together.
   */
  public static Calibration none(SensingSetup setup, PingLog log) {
    Hypothesis believed = PoseScatter.believed(setup, log);
    if (setup.sensor().law().isLevel()) {
      Form law = LevelForms.law(setup);
      believed = believed.and(law, law.neutral());
    }
    CalibratedLog given = new CalibratedLog(setup, believed.changes(), log);
    return new Calibration(believed, PlacementScatter.clumping(given, new Placements(log)));
  }

  /**
   * Calibrates the law that the scene states; the threshold rule where it states none ({@link Laws}
   * chooses between the two).
   */
  public static Calibration of(SensingSetup setup, PingLog reference) {
    return setup.sensor().law().isLevel()
        ? ofLevel(setup, reference, ModelError.ofLevel(setup, reference))
        : ofThreshold(setup, reference);
  }

  private static Calibration ofThreshold(SensingSetup setup, PingLog reference) {
    CalibratedLog given = new CalibratedLog(setup, List.of(), reference);
    Calibrator calibrator = new Calibrator(new Fitter(given, Fold.ALL), setup);
    return new Calibration(
        Optional.of(given), calibrator.fit(), Optional.empty(), Optional.empty());
  }

  private static Calibration ofLevel(SensingSetup setup, PingLog reference, ModelError error) {
    CalibratedLog given =
        new CalibratedLog(setup, List.of(), reference).divided(error.echoes(), error.ranges());
    LevelCalibration fitted = new LevelCalibrator(setup, reference).fit(Fold.ALL);
    Leeway leeway = fitted.leeway(error.excessDb(), error.rangeM());
    return new Calibration(
        Optional.of(given), fitted.setup(), Optional.of(error), Optional.of(leeway));
  }

  /** Returns the set-up as the simulator believes it, under the law that was taken. */
  public SensingSetup believed(SensingSetup stated) {
    return reference.map(CalibratedLog::setup).orElse(stated);
  }

  /** Returns by which law the set-up hears. */
  public SensorLaw.Model model() {
    boolean level = reference.isPresent() && reference.get().setup().sensor().law().isLevel();
    return level ? SensorLaw.Model.LEVEL : SensorLaw.Model.THRESHOLD;
  }

  /** Returns a log before this set-up, its evidence divided by what the set-up is off by. */
  public CalibratedLog given(SensingSetup stated, PingLog log) {
    CalibratedLog plain = new CalibratedLog(believed(stated), setup.changes(), log);
    return heldOut.map(error -> plain.divided(error.echoes(), error.ranges())).orElse(plain);
  }

  /**
   * Returns by how many nats a log would be likelier if the set-up moved as far as its reference
   * leaves open; 0 under the threshold rule.
   *
   * @param given of the log
   * @param hypothesis that stays as it is
   */
  public double leewayNats(CalibratedLog given, Hypothesis hypothesis) {
    return leeway.map(open -> leewayNats(open, given, hypothesis)).orElse(0.0);
  }

  private static double leewayNats(Leeway open, CalibratedLog given, Hypothesis hypothesis) {
    SetupMove move = new SetupMove(open, given, hypothesis);
    return move.nats(move.levels());
  }

  /** A log before a set-up whose levels have moved to where they and it are likeliest together. */
  private static CalibratedLog settled(Leeway open, CalibratedLog given) {
    Leeway.Moved levels = new SetupMove(open, given, Hypothesis.NONE).levels();
    return given.calibrated(new LevelShift(levels.shiftsDb()).and(given.calibration()));
  }

  /**
   * Returns a log before a set-up that has moved to where log, reference and an explanation are
   * most probable together. Under the level law only while nothing is explained: its levels move
   * within the search already.
   *
   * @param given of the log
   * @param explanation that stays as it is
   */
  public CalibratedLog opened(CalibratedLog given, Hypothesis explanation) {
    return leeway
        .map(open -> explanation.forms().isEmpty() ? settled(open, given) : given)
        .orElseGet(() -> loosened(given, explanation));
  }

  @Override
  public Optional<Leeway> leeway() {
    return leeway;
  }

  @Override
  public double[] blocksVary() {
    return heldOut
        .map(error -> new double[] {error.echoes(), error.ranges()})
        .orElse(new double[] {clumping, rangeClumping});
  }

  @Override
  public double misfitTimes(double chance, int rows) {
    return heldOut.map(error -> error.misfitTimes(chance, rows)).orElse(1.0);
  }

  @Override
  public double gapTimes() {
    return heldOut.map(ModelError::gapTimes).orElse(1.0);
  }

  @Override
  public boolean isHeldOut() {
    return heldOut.isPresent();
  }

  /**
   * Returns how far the level law is off on rows that it was not fitted on; none for thresholds.
   */
  public Optional<ModelError> modelError() {
    return heldOut;
  }

  /** Returns the calibrated forms with their values; none without a reference. */
  public Hypothesis setup() {
    return setup;
  }

  /**
   * Returns by how much sums over blocks of echoes vary more than those of independent readings
   * would; 1 without a reference.
   */
  public double clumping() {
    return clumping;
  }

  /**
   * Returns by what nats are divided where sets of effects are weighed: likelihoods of models that
   * are all a little wrong say too much, and more so where readings hang together.
   */
  public double temperature() {
    return Constants.own().under(model()).temperature() * clumping;
  }

  /** Returns the same of where ranges lie in their distributions. */
  double rangeClumping() {
    return rangeClumping;
  }

  /**
   * Asks the reference whether it shows what an explanation of the log says, or leaves it open
   * where it is small: that belongs to the set-up then, and is no effect.
   *
   * @param log calibrated as this is
   * @param explanation of the log
   * @return this if nothing of it belongs to the set-up
   */
  public Calibration with(CalibratedLog log, Hypothesis explanation) {
    if (reference.isEmpty() || explanation.forms().isEmpty()) {
      return this;
    }
    Suspicion suspicion = new Suspicion(reference.get(), log, explanation, clumping);
    Hypothesis more = heldOut.isPresent() ? withinDays(setup, explanation) : setup;
    for (int i = 0; i < explanation.forms().size(); i++) {
      more = suspicion.settled(more, i);
    }
    if (more.equals(setup) && heldOut.isPresent() && isFarOff(log)) {
      return this;
    }
    return more.equals(setup)
        ? rivalled(log, explanation)
        : new Calibration(reference, more, heldOut, leeway);
  }

  /**
   * A set-up with what of an explanation differs from one day to the next though nothing was
   * changed: the air's temperature by half a degree and its absorption with it, a supply's voltage,
   * what was put up again by tape and protractor. A set-up that is known to a decibel would show
   * each of these as an effect.
   */
  private static Hypothesis withinDays(Hypothesis setup, Hypothesis explanation) {
    Hypothesis taken = setup;
    for (int i = 0; i < explanation.forms().size(); i++) {
      Form form = explanation.forms().get(i);
      double[] values = explanation.valuesOf(i);
      Form asSetup = SetupForms.of(form);
      if (Definitions.of(form.effect()).isWithinDays(form, values)
          && !setup.forms().contains(asSetup)) {
        taken = taken.and(asSetup, values);
      }
    }
    return taken;
  }

  /**
   * Whether a log's gap is more than its reference leaves open. A law of many strengths that moved
   * so far would take up anything, and the gap would be gone from sight.
   */
  private static boolean isFarOff(CalibratedLog log) {
    return GapGain.of(log, new Blocks(log.log()), Hypothesis.NONE).leavesMuch();
  }

  /** Whether a set-up that fits reference and log together makes an effect superfluous. */
  private Calibration rivalled(CalibratedLog log, Hypothesis explanation) {
    CalibratedLog raw = log.calibrated(List.of());
    Rival whole = rival(raw, explanation);
    for (Effect effect : explanation.effects()) {
      Rival less = rival(raw, explanation.without(effect));
      if (whole.nats - less.nats < SUPERFLUOUS_NATS * clumping) {
        return new Calibration(reference, less.setup, heldOut, leeway);
      }
    }
    return this;
  }

  /** A set-up fitted to reference and log together, and how well it fits. */
  private record Rival(Hypothesis setup, double nats) {}

  private Rival rival(CalibratedLog raw, Hypothesis effects) {
    if (model() == SensorLaw.Model.LEVEL) {
      return levelRival(raw, effects);
    }
    Calibrator calibrator =
        new Calibrator(new JointFitter(reference.orElseThrow(), raw, effects), raw.setup());
    Hypothesis fitted = calibrator.again(setup);
    return new Rival(fitted, calibrator.given(fitted));
  }

  private Rival levelRival(CalibratedLog raw, Hypothesis effects) {
    CalibratedLog own = reference.orElseThrow();
    LevelCalibration fitted =
        new LevelCalibrator(raw.setup(), own.log()).fitWith(raw.log(), setup, effects.changes());
    Hypothesis both = fitted.setup();
    for (int i = 0; i < setup.forms().size(); i++) {
      if (!both.forms().contains(setup.forms().get(i))) {
        both = both.and(setup.forms().get(i), setup.valuesOf(i));
      }
    }
    double nats = new JointFitter(own, raw, effects).logLikelihood(both);
    return new Rival(both, nats - fitted.priorCost());
  }

  /**
   * Lets the set-up move as far as the reference leaves open: the places of a log are not those of
   * its reference, and what a set-up is off by is no effect.
   *
   * @param given of the log, calibrated
   * @param explanation that stays as it is
   * @return the log before a set-up that is fitted to it and the reference together
   */
  CalibratedLog loosened(CalibratedLog given, Hypothesis explanation) {
    if (reference.isEmpty()) {
      return given;
    }
    CalibratedLog raw = given.calibrated(List.of());
    Hypothesis loose = rival(raw, explanation).setup;
    return given.calibrated(loose.changes());
  }
}
