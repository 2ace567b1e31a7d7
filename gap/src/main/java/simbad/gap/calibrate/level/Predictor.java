package simbad.gap.calibrate.level;

import java.util.List;
import simbad.sonar.catalogue.LevelForms;
import simbad.sonar.frame.Angles;
import simbad.sonar.level.LevelLaw;
import simbad.sonar.level.PistonBeam;
import simbad.sonar.ping.LevelEars;

/** The excess of trials under values of the level law, and how it changes with each value. */
final class Predictor {
  private static final double APERTURE_STEP = 0.01;
  private static final double SQUINT_STEP_RAD = Math.toRadians(0.1);

  private final Layout layout;
  private final LevelLaw believed;
  private final List<Believed> targets;
  private final double wavenumberPerM;
  private double[] values = {};
  private PistonBeam beam;
  private double scatterDb;

  Predictor(Layout layout, LevelLaw believed, List<Believed> targets, double wavenumberPerM) {
    this.layout = layout;
    this.believed = believed;
    this.targets = targets;
    this.wavenumberPerM = wavenumberPerM;
    beam = PistonBeam.of(LevelForms.APERTURE_M, wavenumberPerM);
  }

  /**
   * A trial with all that does not depend on the values.
   *
   * @param trial what was heard of an obstacle
   * @param loss what the believed strength makes up for, less what the distance takes
   * @param here parameter of the departure at the bearing before
   * @param next parameter of that at the bearing behind
   * @param share of the way from the one to the other
   * @param ringingDb by how much the sender's ringing makes the level stray
   */
  record Row(Trials.Trial trial, Loss loss, int here, int next, double share, double ringingDb) {}

  /** Prepares a trial. */
  Row row(Trials.Trial trial) {
    double place = trial.bearingRad() / Angles.TURN_RAD * LevelForms.BEARINGS;
    int cell = Math.min((int) place, LevelForms.BEARINGS - 1);
    Believed own = targets.get(trial.target());
    int here = own.symmetry().orbit(cell);
    int next = own.symmetry().orbit((cell + 1) % LevelForms.BEARINGS);
    Loss strength = own.loss(here).towards(own.loss(next), place - cell);
    return new Row(
        trial,
        strength.minus(Loss.at(trial.centreM(), believed)).plus(trial.addedDb()),
        layout.lobe(trial.target(), here),
        layout.lobe(trial.target(), next),
        place - cell,
        LevelEars.ringingDb(trial.nearestM()));
  }

  /**
   * By how much an echo exceeds the threshold.
   *
   * @param decibels expected
   * @param deviationDb how much that scatters
   */
  record Excess(double decibels, double deviationDb) {
    double inDeviations() {
      return decibels / deviationDb;
    }
  }

  /** Takes values; they are not copied. */
  void set(double[] newValues) {
    values = newValues;
    beam = PistonBeam.of(Math.exp(values[layout.aperture()]), wavenumberPerM);
    scatterDb = Math.exp(values[layout.scatter()]);
  }

  /** Returns the excess of a trial. */
  Excess excess(Row row) {
    double offAxis = row.trial.offAxisRad() - values[layout.squint()];
    double lobe = values[row.here] + row.share * (values[row.next] - values[row.here]);
    double level =
        row.loss.decibels(values) + values[Layout.LEVEL] + lobe + LevelEars.beamDb(beam, offAxis);
    double aim = LevelEars.aimDb(beam, offAxis);
    double variance = scatterDb * scatterDb + aim * aim + row.ringingDb * row.ringingDb;
    return new Excess(level, Math.sqrt(variance));
  }

  /** Returns by how much the excess of a trial rises with its bearing, decibels per radian. */
  double perTurnDb(Row row) {
    Believed own = targets.get(row.trial.target());
    double rise =
        strengthDb(own, row.next, row.trial.target())
            - strengthDb(own, row.here, row.trial.target());
    return rise * LevelForms.BEARINGS / Angles.TURN_RAD;
  }

  private double strengthDb(Believed own, int lobe, int target) {
    return own.loss(lobe - layout.lobe(target, 0)).decibels(values) + values[lobe];
  }

  /** How an excess, in units of its deviation, changes with the values. */
  static final class Slope {
    private final int[] index = new int[Loss.SIZE + 6];
    private final double[] value = new double[index.length];
    private int size;

    int size() {
      return size;
    }

    int index(int i) {
      return index[i];
    }

    double value(int i) {
      return value[i];
    }

    private void put(int at, double slope) {
      index[size] = at;
      value[size] = slope;
      size++;
    }
  }

  /**
   * Finds how the excess of a trial changes.
   *
   * @param row the trial
   * @param excess of it
   * @param into takes the slopes
   */
  void slope(Row row, Excess excess, Slope into) {
    into.size = 0;
    for (int i = 0; i < Loss.SIZE; i++) {
      into.put(i, row.loss.weights()[i]);
    }
    into.put(Layout.LEVEL, 1);
    into.put(row.here, 1 - row.share);
    into.put(row.next, row.share);
    double offAxis = row.trial.offAxisRad() - values[layout.squint()];
    double wider = LevelEars.widenedDb(beam, offAxis, 1 + APERTURE_STEP);
    double rise = wider - LevelEars.widenedDb(beam, offAxis, 1 - APERTURE_STEP);
    into.put(layout.aperture(), rise / (2 * APERTURE_STEP));
    double turned =
        LevelEars.beamDb(beam, offAxis - SQUINT_STEP_RAD)
            - LevelEars.beamDb(beam, offAxis + SQUINT_STEP_RAD);
    into.put(layout.squint(), turned / (2 * SQUINT_STEP_RAD));
    double part = scatterDb / excess.deviationDb();
    into.put(layout.scatter(), -excess.decibels() * part * part);
  }
}
