package simbad.blindworld.wave;

import simbad.blindworld.check.Checks;

/**
 * A sonar.
 *
 * @param burst what it sends
 * @param pistons how it looks
 * @param receiver when it takes something for an echo
 * @param levelDb of what it sends and amplifies; 0 is a pressure of 1 at 1 m before it
 */
public record Gear(Burst burst, Pistons pistons, Receiver receiver, double levelDb) {
  /** Refuses what is no such thing. */
  public Gear {
    Checks.finite("level", levelDb);
  }

  /**
   * Transmitter and receiver.
   *
   * @param senderRadiusM of the transmitter's piston
   * @param receiverRadiusM of the receiver's
   * @param axisRad of both beside the heading, counter-clockwise
   * @param receiverAxisRad of the receiver beside that axis
   */
  public record Pistons(
      double senderRadiusM, double receiverRadiusM, double axisRad, double receiverAxisRad) {
    /** Refuses what is no such thing. */
    public Pistons {
      Checks.notNegative("sender's radius", senderRadiusM);
      Checks.notNegative("receiver's radius", receiverRadiusM);
      Checks.finite("axis", axisRad);
      Checks.finite("receiver's axis", receiverAxisRad);
    }

    /** Both pistons larger by a factor. */
    public Pistons scaled(double factor) {
      return new Pistons(
          factor * senderRadiusM, factor * receiverRadiusM, axisRad, receiverAxisRad);
    }

    /** Both turned by so much. */
    public Pistons turned(double byRad) {
      return new Pistons(senderRadiusM, receiverRadiusM, axisRad + byRad, receiverAxisRad);
    }

    /** The receiver turned by so much. */
    public Pistons receiverTurned(double byRad) {
      return new Pistons(senderRadiusM, receiverRadiusM, axisRad, receiverAxisRad + byRad);
    }
  }

  /**
   * A comparator whose threshold falls after the burst.
   *
   * @param floor its threshold at last, a pressure
   * @param start its threshold at the trigger
   * @param decayS the time constant of its fall
   * @param armS from the trigger until ringing is over and it listens
   * @param timeoutS from the trigger until it gives up
   * @param noise standard deviation of the noise in phase and in quadrature
   */
  public record Receiver(
      double floor, double start, double decayS, double armS, double timeoutS, double noise) {
    /** Refuses what is no such thing. */
    public Receiver {
      Checks.notNegative("floor", floor);
      Checks.notNegative("start", start);
      Checks.positive("decay", decayS);
      Checks.notNegative("time until it listens", armS);
      Checks.positive("time-out", timeoutS);
      Checks.notNegative("noise", noise);
    }

    /** The threshold at a time after the trigger. */
    public double thresholdAt(double tS) {
      return floor + (start - floor) * StrictMath.exp(-tS / decayS);
    }

    /** The same receiver, listening later. */
    public Receiver armedAt(double tS) {
      return new Receiver(floor, start, decayS, tS, timeoutS, noise);
    }

    /** The same receiver with another time-out. */
    public Receiver withTimeout(double tS) {
      return new Receiver(floor, start, decayS, armS, tS, noise);
    }

    /** The same receiver with so many times the noise. */
    public Receiver noisier(double factor) {
      return new Receiver(floor, start, decayS, armS, timeoutS, factor * noise);
    }
  }

  /** The same sonar with another burst. */
  public Gear with(Burst other) {
    return new Gear(other, pistons, receiver, levelDb);
  }

  /** The same sonar with other pistons. */
  public Gear with(Pistons other) {
    return new Gear(burst, other, receiver, levelDb);
  }

  /** The same sonar with another receiver. */
  public Gear with(Receiver other) {
    return new Gear(burst, pistons, other, levelDb);
  }

  /** The same sonar, louder by so much. */
  public Gear louder(double byDb) {
    return new Gear(burst, pistons, receiver, levelDb + byDb);
  }
}
