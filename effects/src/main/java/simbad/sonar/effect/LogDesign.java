package simbad.sonar.effect;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.IntStream;
import simbad.definition.Effect;
import simbad.definition.Trait;
import simbad.sonar.check.Checks;
import simbad.sonar.frame.Angles;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Point;
import simbad.sonar.ping.PingLog;
import simbad.sonar.ping.Scenes;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.UniformDetection;

/**
 * How a log was taken: what it can show at all.
 *
 * @param setup as the simulator believes it
 * @param log itself
 * @param isRepeated whether things were put in place and read again and again
 * @param isFurtherOff whether, there, placements may be off by more than is said of them
 * @param isNoisier whether readings at one placement scatter more than believed; true where nothing
 *     was repeated
 * @param wayM how far sound goes and comes back between two pings, metres; 0 where there are none
 * @param round labels of the uniform obstacles that look the same from all sides
 * @param isOfOneDistance whether all that could be heard is about as far away
 */
public record LogDesign(
    SensingSetup setup,
    PingLog log,
    boolean isRepeated,
    boolean isFurtherOff,
    boolean isNoisier,
    double wayM,
    Set<String> round,
    boolean isOfOneDistance) {
  private static final double STILL_RAD = Math.toRadians(0.1);
  private static final double TURNED_RAD = Math.toRadians(1);
  private static final double TURNED_AWAY_DEG = 15;

  /** Checks the way and copies the set. */
  public LogDesign {
    Checks.number("wayM", wayM);
    round = Set.copyOf(round);
  }

  /**
   * Returns how far sound goes and comes back from when an echo was read until the next ping,
   * metres, in the middle; 0 where no echo is followed by a ping.
   */
  public double pauseM() {
    double perSecond = setup.sensor().assumedSoundSpeedMPerS() / 2;
    double[] pauses =
        IntStream.range(1, log.size())
            .filter(i -> log.sequenceStart(i) < i && log.isTimed(i) && log.echo(i - 1))
            .mapToDouble(i -> perSecond * (log.timeS(i) - log.timeS(i - 1)) - log.rangeM(i - 1))
            .sorted()
            .toArray();
    return pauses.length == 0 ? 0 : Modes.quantile(pauses, 0.5);
  }

  /**
   * Returns what does to ranges what an effect does, where they are all of one distance; seen from
   * one place an obstacle that is further away, too.
   *
   * @param effect one that makes ranges longer or shorter
   */
  public Set<Effect> alikeInRange(Effect effect) {
    if (!isOfOneDistance) {
      return Set.of();
    }
    Set<Effect> others = new TreeSet<>(Definitions.with(Trait.MOVES_RANGES));
    others.remove(effect);
    if (isOneBearing()) {
      others.addAll(Definitions.with(Trait.MOVES_OBSTACLES));
    }
    return others;
  }

  /** Tells whether any reading has a time: without times nothing says which ping came before. */
  public boolean isTimed() {
    return IntStream.range(0, log.size()).anyMatch(log::isTimed);
  }

  /**
   * Tells whether a form turns or shades nothing but what looks the same from all sides.
   *
   * @param form of one obstacle by its label, or of all
   * @param ofAll whether it is about every obstacle, or about uniform ones only
   */
  public boolean isOfRoundOnes(Form form, boolean ofAll) {
    List<String> labels = Scenes.labels(setup.scene());
    Optional<String> one =
        labels.stream()
            .filter(
                label ->
                    form.name().equals("only:" + label) || form.name().contains(":" + label + "#"))
            .findFirst();
    long about =
        setup.scene().obstacles().stream()
            .filter(obstacle -> ofAll || obstacle.detection() instanceof UniformDetection)
            .count();
    return one.map(round::contains).orElse(!round.isEmpty() && round.size() == about);
  }

  /**
   * Tells whether all obstacles that are believed uniform were looked at from one side each: then
   * nothing that depends on the side can be told from what does not.
   *
   * @param leastDeg by how much the bearing must change to be another side, in (0, 180) degrees
   */
  public boolean isFromOneSide(double leastDeg) {
    return setup.scene().obstacles().stream()
        .filter(obstacle -> obstacle.detection() instanceof UniformDetection)
        .map(Obstacle::worldFromObstacle)
        .allMatch(place -> spreadDeg(new Point(place.xM(), place.zM())) < leastDeg);
  }

  /**
   * Tells whether a sensor stood at one place and looked around at one obstacle: whether that is
   * aside of where it should be or the sensor turned is the same then.
   */
  public boolean isOneBearing() {
    return setup.scene().obstacles().size() == 1 && log.isOfOnePlace();
  }

  /**
   * Tells whether that sensor looked past the obstacle once, always turning the same way and by no
   * more than once round: heading and time go together then.
   */
  public boolean isOnePass() {
    double left = 0;
    double right = 0;
    for (int ping = 1; ping < log.size(); ping++) {
      double turn = Angles.signed(log.headingRad(ping) - log.headingRad(ping - 1));
      left += Math.max(0, turn);
      right += Math.max(0, -turn);
    }
    return isOneBearing() && Math.min(left, right) < STILL_RAD && left + right <= 2 * Math.PI;
  }

  /**
   * Tells whether a lone obstacle was turned before a sensor, as on a turntable: seen from it the
   * sensor went round and always looked the same way past its middle. It was turned so far at least
   * that a plate's edges are heard instead of its face.
   */
  public boolean isTurnedBefore() {
    if (setup.scene().obstacles().size() != 1) {
      return false;
    }
    Point middle = middle();
    double first = asideRad(middle, 0);
    return spreadDeg(middle) >= TURNED_AWAY_DEG
        && IntStream.range(0, log.size())
            .allMatch(ping -> Math.abs(Angles.signed(asideRad(middle, ping) - first)) < TURNED_RAD);
  }

  /**
   * Returns how far aside of its place an obstacle that is turned before a sensor may be: who aims
   * at it has its middle in the cone.
   *
   * @return metres, at the middle one of the distances; infinite where nothing is turned and aimed
   *     at
   */
  public double mostAsideM() {
    double halfRad = setup.sensor().coneHalfAngleRad();
    if (halfRad >= Math.PI / 2
        || !isTurnedBefore()
        || Math.abs(Angles.signed(asideRad(middle(), 0))) > halfRad) {
      return Double.POSITIVE_INFINITY;
    }
    Point middle = middle();
    double[] distances =
        IntStream.range(0, log.size())
            .mapToDouble(ping -> Math.hypot(log.xM(ping) - middle.xM(), log.zM(ping) - middle.zM()))
            .sorted()
            .toArray();
    return Math.tan(halfRad) * Modes.quantile(distances, 0.5);
  }

  /** Of the first obstacle. */
  private Point middle() {
    Placement place = setup.scene().obstacles().get(0).worldFromObstacle();
    return new Point(place.xM(), place.zM());
  }

  private double asideRad(Point middle, int ping) {
    double toMiddleRad = Math.atan2(log.zM(ping) - middle.zM(), middle.xM() - log.xM(ping));
    return log.headingRad(ping) - toMiddleRad;
  }

  /** Of the directions from a point to the sensors, from the first one. */
  private double spreadDeg(Point from) {
    double least = 0;
    double most = 0;
    double first = bearingDeg(from, 0);
    for (int ping = 1; ping < log.size(); ping++) {
      double off = Math.IEEEremainder(bearingDeg(from, ping) - first, 360);
      least = Math.min(least, off);
      most = Math.max(most, off);
    }
    return most - least;
  }

  private double bearingDeg(Point from, int ping) {
    return Math.toDegrees(Math.atan2(log.zM(ping) - from.zM(), log.xM(ping) - from.xM()));
  }
}
