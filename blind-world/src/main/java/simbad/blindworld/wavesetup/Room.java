package simbad.blindworld.wavesetup;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import simbad.blindworld.check.Checks;
import simbad.blindworld.wave.Air;
import simbad.blindworld.wave.Burst;
import simbad.blindworld.wave.Counter;
import simbad.blindworld.wave.Gear;
import simbad.blindworld.wave.Outline;
import simbad.blindworld.wave.Target;
import simbad.blindworld.wave.Upright;
import simbad.blindworld.wave.WaveWorld;
import simbad.blindworld.world.Chance;
import simbad.blindworld.world.Point;
import simbad.blindworld.world.Pose;

/**
 * What really is there: a sonar, air, and articles with their places.
 *
 * @param parts on a day of mean temperature, with a counter that nobody has set yet
 * @param articles what stands there
 * @param targets the same as sound meets them, in the same order
 * @param turnsRad their turns
 * @param mountHeightM of the sonar over the floor
 * @param maxRangeM what its maker promises
 */
public record Room(
    WaveWorld.Parts parts,
    List<Article> articles,
    List<Target> targets,
    List<Double> turnsRad,
    double mountHeightM,
    double maxRangeM) {

  private static final double APART_M = 0.6;

  /** The air scatters a level by so much from ping to ping. */
  private static final double SCATTER_DB = 0.3;

  /** One day's temperature differs from the mean by so much. */
  private static final double DAY_K = 0.5;

  /** Copies the lists. */
  public Room {
    Checks.notNegative("height of the sonar", mountHeightM);
    Checks.positive("greatest range", maxRangeM);
    articles = List.copyOf(articles);
    targets = List.copyOf(targets);
    turnsRad = Checks.numbers("turns", turnsRad);
  }

  /** A room drawn at random. */
  public static Room draw(Chance random) {
    double mount = 0.01 * random.nextInt(10, 16);
    double maxRange = random.nextBoolean() ? 3 : 4;
    Air air =
        new Air(random.nextDouble(14, 28), random.nextDouble(25, 70), random.nextDouble(97, 102.5));
    Gear gear = gear(random, air, maxRange);
    List<Article> articles = new ArrayList<>();
    List<Target> targets = new ArrayList<>();
    List<Double> turns = new ArrayList<>();
    int count = random.nextInt(3) == 0 ? 2 : 1;
    while (articles.size() < count) {
      Point place = place(random, targets);
      Article article = Article.draw(random);
      double turn = Math.toRadians(random.nextInt(-180, 180));
      articles.add(article);
      turns.add(turn);
      targets.add(new Target(article.outline(), article.upright(mount), place, turn));
    }
    WaveWorld.Parts parts =
        new WaveWorld.Parts(
            gear,
            air,
            new Counter(air.soundSpeedMPerS(), 0, tick(random), 0),
            SCATTER_DB,
            List.copyOf(targets));
    return new Room(parts, articles, targets, turns, mount, maxRange);
  }

  private static double tick(Chance random) {
    return new double[] {1e-6, 4e-6, 1e-6, 12.8e-6, 29e-6}[random.nextInt(5)];
  }

  private static Point place(Chance random, List<Target> others) {
    Optional<Point> place = Optional.empty();
    while (place.isEmpty()) {
      Point tried =
          new Point(
              Math.round(100 * random.nextDouble(-1, 1)) / 100.0,
              Math.round(100 * random.nextDouble(-1, 1)) / 100.0);
      boolean free =
          others.stream()
              .map(Target::place)
              .allMatch(o -> StrictMath.hypot(o.xM() - tried.xM(), o.zM() - tried.zM()) > APART_M);
      place = free ? Optional.of(tried) : place;
    }
    return place.get();
  }

  /** A ranger whose maker set the threshold so that a pole is found at a drawn distance. */
  private static Gear gear(Chance random, Air air, double maxRangeM) {
    double frequency = random.nextDouble(39_500, 40_500);
    Burst burst =
        new Burst(
            frequency,
            random.nextInt(6, 17),
            resonance(random, frequency),
            resonance(random, frequency),
            0);
    double radius = random.nextDouble(0.007, 0.0086);
    double timeout = 2 * maxRangeM / 340 + random.nextDouble(0.001, 0.006);
    Gear.Receiver open =
        new Gear.Receiver(1e-9, 1e-9, 1, random.nextDouble(0.0004, 0.0007), timeout, 1e-12);
    Gear deaf = new Gear(burst, new Gear.Pistons(radius, radius, 0, 0), open, 0);
    double floor = poleAt(random.nextDouble(1.7, 2.3), deaf, air);
    double start = floor * StrictMath.pow(10, random.nextDouble(20, 25) / 20);
    double noise = floor / random.nextDouble(12, 20);
    return deaf.with(
        new Gear.Receiver(
            floor, start, random.nextDouble(0.002, 0.003), open.armS(), timeout, noise));
  }

  private static Burst.Resonance resonance(Chance random, double carrierHz) {
    return new Burst.Resonance(
        carrierHz * (1 + 0.003 * random.nextGaussian()), random.nextDouble(13, 24));
  }

  /** The pressure of a pole's echo. */
  private static double poleAt(double distanceM, Gear gear, Air air) {
    Target pole =
        new Target(Outline.round(0.03), new Upright(-0.15, 1), new Point(distanceM, 0), 0);
    Counter counter = new Counter(air.soundSpeedMPerS(), 0, 0, 0);
    WaveWorld.Parts parts = new WaveWorld.Parts(gear, air, counter, SCATTER_DB, List.of(pole));
    double excess = new WaveWorld(parts, List.of()).standing(new Pose(0, 0, 0)).excessDb();
    return gear.receiver().floor() * StrictMath.pow(10, excess / 20);
  }

  /** The same room on another day. */
  public WaveWorld.Parts onSomeDay(Chance random) {
    return parts.in(parts.air().warmer(DAY_K * random.nextGaussian()));
  }
}
