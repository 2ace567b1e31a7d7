package simbad.gap.explain;

import java.util.Arrays;
import java.util.Map;
import java.util.Optional;
import simbad.gap.fit.Evidence;
import simbad.gap.fit.Fitter;
import simbad.gap.fit.Fold;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fit.JointFitter;
import simbad.sonar.effect.Effect;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.PingLog;
import simbad.sonar.effect.SetupForms;
import simbad.sonar.scene.SensingSetup;

/**
 * What a reference log says of the set-up: in what it is a little off while the simulation is
 * trusted, and how far its readings hang together.
 */
public final class Calibration {
  /** What an effect must gain beside a set-up that is fitted to the log as well. */
  private static final double SUPERFLUOUS_NATS = 15;

  private final Optional<Evidence> reference;
  private final Hypothesis setup;
  private final Map<Form, double[]> freedom;
  private final double clumping;

  private Calibration(Optional<Evidence> reference, Hypothesis setup, Map<Form, double[]> freedom) {
    this.reference = reference;
    this.setup = setup;
    this.freedom = Map.copyOf(freedom);
    clumping = reference.map(evidence -> clumping(evidence, setup)).orElse(1.0);
  }

  /** Returns the calibration of a set-up without a reference: it is as it is believed to be. */
  public static Calibration none() {
    return new Calibration(Optional.empty(), Hypothesis.NONE, Map.of());
  }

  /** Calibrates. */
  public static Calibration of(SensingSetup setup, PingLog reference) {
    Evidence evidence = new Evidence(setup, java.util.List.of(), reference);
    Calibrator calibrator = new Calibrator(new Fitter(evidence, Fold.ALL), setup);
    Hypothesis fitted = calibrator.fit();
    return new Calibration(Optional.of(evidence), fitted, calibrator.freedom());
  }

  /** Returns the calibrated forms with their values; none without a reference. */
  public Hypothesis setup() {
    return setup;
  }

  /**
   * Returns by how much sums over blocks of readings vary more than those of independent readings
   * would; 1 without a reference.
   */
  public double clumping() {
    return clumping;
  }

  /**
   * Asks the reference whether it shows what an explanation of the log says, or leaves it open
   * where it is small: that belongs to the set-up then, and is no effect.
   *
   * @param log calibrated as this is
   * @param explanation of the log
   * @return this if nothing of it belongs to the set-up
   */
  public Calibration with(Evidence log, Hypothesis explanation) {
    if (reference.isEmpty() || explanation.forms().isEmpty()) {
      return this;
    }
    Suspicion suspicion = new Suspicion(reference.get(), log, explanation, clumping);
    Hypothesis more = setup;
    for (int i = 0; i < explanation.forms().size(); i++) {
      more = suspicion.settled(more, i);
    }
    return more.equals(setup)
        ? rivalled(log, explanation)
        : new Calibration(reference, more, freedom);
  }

  /** Whether a set-up that fits reference and log together makes an effect superfluous. */
  private Calibration rivalled(Evidence log, Hypothesis explanation) {
    Evidence raw = new Evidence(log.setup(), java.util.List.of(), log.log());
    Rival whole = rival(raw, explanation);
    for (Effect effect : explanation.effects()) {
      Rival less = rival(raw, explanation.without(effect));
      if (whole.nats - less.nats < SUPERFLUOUS_NATS * clumping) {
        return new Calibration(reference, less.setup, less.freedom);
      }
    }
    return this;
  }

  /** A set-up fitted to reference and log together, and how well it fits. */
  private record Rival(Hypothesis setup, Map<Form, double[]> freedom, double nats) {}

  private Rival rival(Evidence raw, Hypothesis effects) {
    Calibrator calibrator =
        new Calibrator(new JointFitter(reference.orElseThrow(), raw, effects), raw.setup());
    Hypothesis fitted = calibrator.again(setup);
    return new Rival(fitted, calibrator.freedom(), calibrator.evidence(fitted));
  }

  /**
   * Lets the thresholds move as far as the reference leaves open: the bearings of a log are not
   * those of its reference, and what a set-up is off by is no effect.
   *
   * @param evidence of the log, calibrated
   * @param explanation that stays as it is
   * @return the explanation and the thresholds' waves
   */
  public Hypothesis loosened(Evidence evidence, Hypothesis explanation) {
    Fitter fitter = new Fitter(evidence, Fold.ALL);
    Hypothesis loose = explanation;
    for (Form form : SetupForms.all(evidence.setup())) {
      double[] variance = freedom.get(form);
      if (variance != null) {
        Waves waves = new Waves(fitter, form);
        loose = waves.moved(waves.moved(loose, variance), variance);
      }
    }
    return loose;
  }

  /** Mean square of the blocks' sums of surprises, each in units of what chance gives. */
  private static double clumping(Evidence evidence, Hypothesis setup) {
    Surprise surprise = new Surprise(evidence, setup);
    Blocks blocks = new Blocks(evidence.log());
    double[] sum = new double[blocks.count()];
    double[] variance = new double[blocks.count()];
    for (int i = 0; i < evidence.log().size(); i++) {
      sum[blocks.of(i)] += (evidence.log().echo(i) ? 1 : 0) - surprise.expected[i];
      variance[blocks.of(i)] += surprise.expected[i] * (1 - surprise.expected[i]);
    }
    double[] square = new double[sum.length];
    int count = 0;
    for (int i = 0; i < sum.length; i++) {
      if (variance[i] > 0.5) {
        square[count++] = sum[i] * sum[i] / variance[i];
      }
    }
    return count == 0 ? 1 : Math.max(1, Arrays.stream(square, 0, count).average().orElse(1));
  }
}
