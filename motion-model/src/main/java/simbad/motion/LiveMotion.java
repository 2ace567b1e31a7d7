package simbad.motion;

import java.util.ArrayDeque;
import java.util.Deque;

/**
 * A robot that is commanded as it goes: the same chain as {@link Way} has for a recorded run. What
 * the tracker would report of it has no part here, since it does not move the robot.
 */
public final class LiveMotion {
  private final MotionChain chain;
  private final Response response;
  private final double lateS;

  /** Commands that act now or are yet to act, oldest first. */
  private final Deque<Piece> ahead = new ArrayDeque<>();

  private double speedMPerS;
  private double turnRadPerS;
  private double wayM;
  private double turnRad;

  /** A command as the drive takes it, and how long it still holds. */
  private record Piece(double speedMPerS, double turnRadPerS, double durationS) {
    Piece shorter(double byS) {
      return new Piece(speedMPerS, turnRadPerS, durationS - byS);
    }
  }

  /**
   * Creates a robot that stands.
   *
   * @param chain how it moves
   */
  public LiveMotion(MotionChain chain) {
    this.chain = chain;
    response = chain.response();
    // Nothing acts before it is commanded.
    lateS = Math.max(0, chain.delayS());
    stop();
  }

  /** Stands still, and forgets what was commanded. */
  public void stop() {
    ahead.clear();
    if (lateS > 0) {
      ahead.add(new Piece(0, 0, lateS));
    }
    speedMPerS = 0;
    turnRadPerS = 0;
    wayM = 0;
    turnRad = 0;
  }

  /**
   * Moves on; {@link #wayM} and {@link #turnRad} then say by how much.
   *
   * @param commandedMPerS speed ahead that is commanded meanwhile
   * @param commandedRadPerS rate of turning that is commanded, counter-clockwise
   * @param durationS at least 0
   */
  public void step(double commandedMPerS, double commandedRadPerS, double durationS) {
    if (!(durationS >= 0)) {
      throw new IllegalArgumentException("durationS = " + durationS + " is not at least 0");
    }
    wayM = 0;
    turnRad = 0;
    Command taken = chain.commanded(new Command(0, commandedMPerS, commandedRadPerS));
    ahead.add(new Piece(taken.speedMPerS(), taken.turnRadPerS(), durationS));
    double left = durationS;
    while (left > 0) {
      Piece piece = ahead.removeFirst();
      double held = Math.min(left, piece.durationS());
      hold(piece, held);
      left -= held;
      if (piece.durationS() > held) {
        ahead.addFirst(piece.shorter(held));
      }
    }
  }

  /** In steps of at most {@link Way#STEP_S}; in one where speeds follow at once. */
  private void hold(Piece piece, double durationS) {
    boolean atOnce = response.equals(Response.AT_ONCE);
    int steps = atOnce ? 1 : (int) Math.max(1, Math.ceil(durationS / Way.STEP_S - 1e-9));
    double stepS = durationS / steps;
    Response.Step follow = response.over(stepS);
    for (int i = 0; i < steps; i++) {
      double speed = follow.speed().next(speedMPerS, piece.speedMPerS());
      double turn = follow.turn().next(turnRadPerS, piece.turnRadPerS());
      double mean = follow.speed().mean(speedMPerS, piece.speedMPerS(), speed);
      double meanTurn = follow.turn().mean(turnRadPerS, piece.turnRadPerS(), turn);
      double overGround = chain.speed(mean);
      wayM += overGround * stepS;
      turnRad += chain.turn(meanTurn, overGround) * stepS;
      speedMPerS = speed;
      turnRadPerS = turn;
    }
  }

  /** Returns how far it went in the last step, metres; negative backwards. */
  public double wayM() {
    return wayM;
  }

  /** Returns by how much it turned in the last step, radians, counter-clockwise. */
  public double turnRad() {
    return turnRad;
  }
}
