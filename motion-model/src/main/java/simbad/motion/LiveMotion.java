package simbad.motion;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;

/**
 * A robot that is commanded as it goes: the same chain as {@link Way} has for a recorded run. What
 * the tracker would report of it has no part here, since it does not move the robot.
 */
public final class LiveMotion {
  private final MotionChain chain;
  private final List<Response> responses;
  private final double lateS;

  /** Commands that act now or are yet to act, oldest first. */
  private final Deque<Piece> ahead = new ArrayDeque<>();

  /** What each change made of the command before. */
  private final Command[] before;

  /** After each response. */
  private final double[] speedsMPerS;

  private final double[] turnsRadPerS;
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
    before = new Command[chain.changes().size()];
    responses = chain.responses();
    speedsMPerS = new double[responses.size()];
    turnsRadPerS = new double[responses.size()];
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
    Arrays.fill(before, Command.STAND);
    Arrays.fill(speedsMPerS, 0);
    Arrays.fill(turnsRadPerS, 0);
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
    if (durationS == 0) {
      return;
    }
    Command taken = taken(new Command(0, commandedMPerS, commandedRadPerS));
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

  private Command taken(Command command) {
    Command taken = command;
    for (int k = 0; k < before.length; k++) {
      taken = chain.changes().get(k).commanded(taken, before[k]);
      before[k] = taken;
    }
    return taken;
  }

  /** In steps of at most {@link Way#STEP_S}; in one where speeds follow at once. */
  private void hold(Piece piece, double durationS) {
    boolean atOnce = responses.isEmpty();
    int steps = atOnce ? 1 : (int) Math.max(1, Math.ceil(durationS / Way.STEP_S - 1e-9));
    double stepS = durationS / steps;
    List<Response.Step> follow = responses.stream().map(one -> one.over(stepS)).toList();
    for (int i = 0; i < steps; i++) {
      double speed = piece.speedMPerS();
      double turn = piece.turnRadPerS();
      for (int k = 0; k < speedsMPerS.length; k++) {
        Response.Step step = follow.get(k);
        double half = turn * step.rimBaseM() / 2;
        boolean rims = step.rimBaseM() > 0;
        double first = followed(step.speed(), speedsMPerS, k, speed - half);
        double second = followed(step.turn(), turnsRadPerS, k, rims ? speed + half : turn);
        speed = rims ? Unicycle.speedOfWheels(first, second) : first;
        turn = rims ? Unicycle.turnOfWheels(first, second, step.rimBaseM()) : second;
      }
      double overGround = chain.speed(speed, turn);
      wayM += overGround * stepS;
      turnRad += chain.turn(turn, overGround) * stepS;
    }
  }

  /** Moves a rate on towards a target, and returns its mean over the step. */
  private static double followed(Response.Rate rate, double[] rates, int index, double target) {
    double now = rates[index];
    rates[index] = rate.next(now, target);
    return rate.mean(now, target, rates[index]);
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
