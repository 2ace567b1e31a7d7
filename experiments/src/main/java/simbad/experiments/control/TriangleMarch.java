package simbad.experiments.control;

/**
 * Walks along the edge on a lattice of equilateral triangles, turning on the spot.
 *
 * <p>The triangle between a place that hears, a place that does not and the place ahead of both is
 * left through the side whose ends differ. So the line between heard and unheard places of the
 * lattice is followed without ever missing a turn, however jagged (marching triangles, after Hilton
 * et al., 1996, on the plane). It is slow and ugly, and meant for places where smooth steering is
 * caught, or where a sensor says now this, now that: there the robot stands at each place of the
 * lattice until one answer leads.
 */
final class TriangleMarch implements Steering {
  private static final double SAME_SIDE_RAD = Math.PI / 3;
  private static final double OTHER_SIDE_RAD = 2 * Math.PI / 3;

  /** A fine march is over after so many steps. */
  private static final int FINE_STEPS = 4000;

  /** About as wide as an SRF04's edge is soft. */
  private static final double SIDE_M = 0.02;

  private static final int LEAD = 3;
  private static final int MOST_READINGS = 9;

  /** So many turns after equal answers lead once round one place. */
  private static final int ROUND_PLACES = 6;

  private final Tuning tuning;
  private final int stepsOfASide;
  private final Ballot ballot;
  private final boolean patient;
  private boolean heardBefore;
  private double leftToTurnRad;
  private int leftToGo;
  private int steps;
  private int equalTurns;
  private int straight;

  private TriangleMarch(
      Tuning tuning, boolean heard, int stepsOfASide, Ballot ballot, boolean patient) {
    this.tuning = tuning;
    heardBefore = heard;
    this.stepsOfASide = stepsOfASide;
    this.ballot = ballot;
    this.patient = patient;
  }

  /** One step a side, and one reading decides; for a while. */
  static TriangleMarch fine(Tuning tuning, boolean heard) {
    return new TriangleMarch(tuning, heard, 1, new Ballot(1, 1), false);
  }

  /** Sides of 2 cm, and several readings decide; for good. */
  static TriangleMarch patient(Tuning tuning, boolean heard) {
    int side = (int) Math.max(1, Math.round(SIDE_M / tuning.stepM()));
    return new TriangleMarch(tuning, heard, side, new Ballot(LEAD, MOST_READINGS), true);
  }

  @Override
  public boolean isOver() {
    return !patient && steps >= FINE_STEPS;
  }

  @Override
  public void steer(boolean heard, Odometry odometry, Command command) {
    steps++;
    if (leftToGo == 0) {
      ballot.add(heard);
      if (!ballot.isDecided()) {
        command.set(0, 0);
        return;
      }
      leave(ballot.close());
    }
    if (leftToTurnRad == 0) {
      leftToGo--;
      command.set(tuning.speedMPerS(), 0);
    } else {
      turn(command);
    }
  }

  /**
   * From one place of the lattice to the next one. A place that was taken for what it is not is
   * left on a spiral, not circled for ever.
   */
  private void leave(boolean heard) {
    if (heard != heardBefore) {
      equalTurns = 0;
      straight = 0;
      leftToTurnRad = heard ? -OTHER_SIDE_RAD : OTHER_SIDE_RAD;
    } else if (straight > 0) {
      straight--;
    } else {
      equalTurns++;
      straight = patient ? equalTurns / ROUND_PLACES : 0;
      leftToTurnRad = heard ? -SAME_SIDE_RAD : SAME_SIDE_RAD;
    }
    heardBefore = heard;
    leftToGo = stepsOfASide;
  }

  private void turn(Command command) {
    double most = tuning.mostRadPerStep();
    double turnRad = Math.max(-most, Math.min(most, leftToTurnRad));
    leftToTurnRad -= turnRad;
    command.set(0, turnRad / tuning.stepS());
  }
}
