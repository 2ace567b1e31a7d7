package simbad.gap.calibrate.level;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.hipparchus.linear.RealMatrix;
import simbad.gap.fit.Fold;
import simbad.gap.fit.Hypothesis;
import simbad.sonar.catalogue.LevelForms;
import simbad.sonar.catalogue.SetupForms;
import simbad.sonar.effect.Form;
import simbad.sonar.level.LevelLaw;
import simbad.sonar.ping.Change;
import simbad.sonar.ping.EchoChange;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.LevelChange;
import simbad.sonar.ping.LevelRule;
import simbad.sonar.ping.LossChange;
import simbad.sonar.ping.PingLog;
import simbad.sonar.ping.RangeChange;
import simbad.sonar.ping.Scenes;
import simbad.sonar.predict.ChangedModel;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;

/**
 * Calibrates the level law of a set-up on a reference log: target strengths, beam, spreading,
 * absorption, receiver, scatter, misses, walk and noise. See docs/method/level-model.md.
 */
public final class LevelCalibrator {
  /** So many ranges scatter far more than the others do, and by so many times their noise. */
  private static final double TAIL_SHARE = 0.03;

  private static final double TAIL_TIMES = 4;
  private static final double LEAST_REFERENCE_M = 0.2;
  private static final double MOST_REFERENCE_M = 3;

  private final SensingSetup setup;
  private final Hypothesis nearFields;
  private final Geometry geometry;
  private final LevelLaw believed;
  private final List<Believed> targets = new ArrayList<>();
  private final Layout layout;
  private final Prior prior;

  /**
   * Prepares the calibration of a set-up.
   *
   * @param setup as the scene believes it
   * @param reference a log of it
   */
  public LevelCalibrator(SensingSetup setup, PingLog reference) {
    this.setup = setup;
    believed = setup.sensor().levelLaw();
    setup.scene().obstacles().forEach(one -> targets.add(new Believed(one, setup.sensor())));
    layout = new Layout(targets);
    prior = new Prior(layout, setup.sensor(), targets, reference.sensors().size());
    nearFields = nearFields(reference);
    geometry = geometry(reference, nearFields);
  }

  /** Where an echo comes from near by, of those obstacles of which the reference says that. */
  private Hypothesis nearFields(PingLog reference) {
    Hypothesis chosen = Hypothesis.NONE;
    double evidence = evidence(geometry(reference, chosen));
    for (String label : Scenes.labels(setup.scene())) {
      Hypothesis with = chosen.and(LevelForms.nearField(setup, label), 1);
      double its = evidence(geometry(reference, with));
      if (its > evidence) {
        chosen = with;
        evidence = its;
      }
    }
    return chosen;
  }

  private Geometry geometry(PingLog reference, Hypothesis known) {
    List<Change> changes = known.changes();
    changes.add(LevelRule.of(setup.sensor()));
    return new Geometry(reference, setup, changes);
  }

  /**
   * Fits the law.
   *
   * @param fold pings that count
   */
  public LevelCalibration fit(Fold fold) {
    Limits limits = Limits.of(geometry, setup.sensor(), fold);
    List<Trials.Trial> trials = Trials.of(geometry, limits.of(setup.sensor()), fold, List.of());
    return fit(limits, trials, trials);
  }

  /**
   * Fits the law to the reference and to a log together, while the log's effects stay as they are.
   * What is a matter of ranges comes from the reference alone where an effect changes ranges.
   *
   * @param log of the same set-up
   * @param known the set-up as calibrated on the reference
   * @param effects at work in the log
   */
  public LevelCalibration fitWith(PingLog log, Hypothesis known, List<? extends Change> effects) {
    Limits limits = Limits.of(geometry, setup.sensor(), Fold.ALL);
    SonarSpec sensor = limits.of(setup.sensor());
    List<Trials.Trial> trials = Trials.of(geometry, sensor, Fold.ALL, List.of());
    Geometry there = new Geometry(log, setup, ChangedModel.changes(known.changes(), effects));
    List<Trials.Trial> both = new ArrayList<>(trials);
    both.addAll(Trials.of(there, sensor, Fold.ALL, effects));
    boolean sameRanges = effects.stream().allMatch(LevelCalibrator::leavesRanges);
    return fit(limits, both, sameRanges ? both : trials);
  }

  private static boolean leavesRanges(Change effect) {
    return !(effect instanceof RangeChange)
        && (effect instanceof LevelChange
            || effect instanceof LossChange
            || effect instanceof EchoChange);
  }

  /** How probable the whole reference is where echoes come from as they do there. */
  private double evidence(Geometry here) {
    Limits limits = Limits.of(here, setup.sensor(), Fold.ALL);
    SonarSpec sensor = limits.of(setup.sensor());
    return levels(predictor(), Trials.of(here, sensor, Fold.ALL, List.of())).evidence();
  }

  private Predictor predictor() {
    return new Predictor(layout, believed, targets, LevelForms.wavenumberPerM(setup));
  }

  private LevelFit levels(Predictor predictor, List<Trials.Trial> trials) {
    List<Trials.Trial> cones = Cones.of(setup.scene(), setup.sensor().coneHalfAngleRad());
    return new LevelFit(prior, predictor, trials, cones, setup.sensor().missRate());
  }

  private LevelCalibration fit(
      Limits limits, List<Trials.Trial> trials, List<Trials.Trial> ofRanges) {
    Predictor predictor = predictor();
    LevelFit fit = levels(predictor, trials);
    predictor.set(fit.values());
    Ranges ranges = Ranges.of(predictor, ofRanges, targets, setup.sensor());
    RealMatrix covariance = fit.covariance();
    double[] law = law(fit, covariance, ranges, limits);
    Form form = LevelForms.law(setup);
    Hypothesis calibrated = Hypothesis.NONE.and(form, law);
    LevelLaw fitted = ((LevelRule) form.with(law)).law();
    List<String> labels = Scenes.labels(setup.scene());
    for (int target = 0; target < labels.size(); target++) {
      calibrated =
          calibrated.and(
              LevelForms.strength(labels.get(target)),
              strengths(target, fit.values(), covariance, fitted));
      PathFit path = ranges.byBearing().get(target);
      calibrated = calibrated.and(LevelForms.path(labels.get(target)), path.values());
    }
    calibrated = calibrated.and(LevelForms.nearRange(), ranges.nearM());
    double noise = ranges.byLevel().noiseM()[1];
    calibrated = calibrated.and(tails(), TAIL_SHARE, Math.min(0.25, TAIL_TIMES * noise));
    for (Form near : nearFields.forms()) {
      calibrated = calibrated.and(near, 1);
    }
    List<Named> values = Named.of(layout, fit, covariance);
    Leeway.Known known = new Leeway.Known(layout, predictor, covariance, ranges);
    return new LevelCalibration(calibrated, values, trials.size(), fit.priorCost(), known);
  }

  private Form tails() {
    return SetupForms.all(setup).stream()
        .filter(form -> form.name().equals("tails"))
        .findFirst()
        .orElseThrow();
  }

  /** In the order of the form's parameters. */
  private double[] law(LevelFit fit, RealMatrix covariance, Ranges ranges, Limits limits) {
    double[] v = fit.values();
    List<Double> all = new ArrayList<>();
    all.add(Math.max(0, v[0]));
    all.add(Math.max(0, v[1]));
    all.add(Math.exp(v[layout.aperture()]));
    all.add(deviation(covariance, layout.aperture()));
    all.add(Math.toDegrees(v[layout.squint()]));
    all.add(Math.toDegrees(deviation(covariance, layout.squint())));
    all.add(Math.exp(v[layout.scatter()]));
    all.add(fit.missRate());
    for (int knot = 0; knot < LevelForms.RECEIVER_M.size(); knot++) {
      all.add(v[Layout.RECEIVER + knot]);
    }
    Arrays.stream(ranges.byLevel().walkM()).forEach(all::add);
    Arrays.stream(ranges.byLevel().noiseM()).forEach(all::add);
    all.add(limits.leastM());
    all.add(limits.mostM());
    all.add(ranges.scale());
    return all.stream().mapToDouble(Double::doubleValue).toArray();
  }

  private static double deviation(RealMatrix covariance, int index) {
    return Math.sqrt(Math.max(0, covariance.getEntry(index, index)));
  }

  /** Strengths at all bearings and how far each may be off, where the target is just lost. */
  private double[] strengths(int target, double[] v, RealMatrix covariance, LevelLaw law) {
    Believed own = targets.get(target);
    double[][] byOrbit = new double[3][own.orbits()];
    for (int orbit = 0; orbit < own.orbits(); orbit++) {
      int lobe = layout.lobe(target, orbit);
      double strength = own.loss(orbit).decibels(v) + v[Layout.LEVEL] + v[lobe] - law.levelDb();
      double lost = law.firstLossM(strength, MOST_REFERENCE_M);
      double[] weight =
          weights(
              own.loss(orbit).minus(Loss.at(Math.max(LEAST_REFERENCE_M, lost), believed)), lobe);
      double[] product = covariance.operate(weight);
      double variance = 0;
      for (int i = 0; i < weight.length; i++) {
        variance += weight[i] * product[i];
      }
      byOrbit[0][orbit] = strength;
      byOrbit[1][orbit] = Math.sqrt(Math.max(0, variance));
      byOrbit[2][orbit] = product[layout.aperture()] / deviation(covariance, layout.aperture());
    }
    double[] all = new double[3 * LevelForms.BEARINGS];
    for (int i = 0; i < all.length; i++) {
      int orbit = own.symmetry().orbit(i % LevelForms.BEARINGS);
      all[i] = byOrbit[i / LevelForms.BEARINGS][orbit];
    }
    return all;
  }

  private double[] weights(Loss apart, int lobe) {
    double[] weights = new double[layout.size()];
    System.arraycopy(apart.weights(), 0, weights, 0, Loss.SIZE);
    weights[Layout.LEVEL] = 1;
    weights[lobe] = 1;
    return weights;
  }
}
