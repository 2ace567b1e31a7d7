package simbad.blindworld.wave;

import java.util.HashMap;
import java.util.Map;

/** A sonar in air of some kind, with what can be computed before any echo. Not thread-safe. */
public final class Medium {

  private final Gear gear;
  private final double soundSpeedMPerS;
  private final double perM;
  private final double lossPerM;
  private final double level;
  private final Piston sender;
  private final Piston receiver;
  private final Complex[] pulse;
  private final Map<Upright, VerticalSum> sums = new HashMap<>();

  /** A sonar in the air. */
  public Medium(Gear gear, Air air) {
    this.gear = gear;
    soundSpeedMPerS = air.soundSpeedMPerS();
    double frequency = gear.burst().frequencyHz();
    perM = 2 * Math.PI * frequency / soundSpeedMPerS;
    lossPerM = air.absorptionDbPerM(frequency) * StrictMath.log(10) / 20;
    level = StrictMath.pow(10, gear.levelDb() / 20);
    sender = new Piston(gear.pistons().senderRadiusM(), perM);
    receiver = new Piston(gear.pistons().receiverRadiusM(), perM);
    pulse = gear.burst().pulse();
  }

  /** The sonar. */
  public Gear gear() {
    return gear;
  }

  /** The speed of sound in metres per second. */
  public double soundSpeedMPerS() {
    return soundSpeedMPerS;
  }

  /** The wave number, in radians per metre. */
  double perM() {
    return perM;
  }

  /** What is left of a pressure after a way, by absorption and the sonar's level. */
  double leftAfter(double wayM) {
    return level * StrictMath.exp(-lossPerM * wayM);
  }

  /** The time after the trigger of what came a way, in carrier cycles. */
  double cyclesAfter(double wayM) {
    return (wayM / soundSpeedMPerS + gear.burst().delayS()) * gear.burst().frequencyHz();
  }

  /** By how much the carrier's phase is later for the burst's delay. */
  double delayPhaseRad() {
    return 2 * Math.PI * gear.burst().frequencyHz() * gear.burst().delayS();
  }

  /** The transmitter's directivity at an angle with the sine. */
  double sent(double sine) {
    return sender.at(sine);
  }

  /** The receiver's directivity at an angle with the sine. */
  double received(double sine) {
    return receiver.at(sine);
  }

  /** The height of a single arrival's echo over the arrival. */
  double pulsePeak() {
    double most = 0;
    for (Complex value : pulse) {
      most = Math.max(most, value.size());
    }
    return most;
  }

  /** What a target's height adds up to. */
  VerticalSum over(Upright upright) {
    return sums.computeIfAbsent(upright, u -> new VerticalSum(u, this));
  }

  /** Echoes as the receiver has them. */
  Trace drawn(Trace arrivals) {
    return arrivals.drawn(pulse);
  }
}
