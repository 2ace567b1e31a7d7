package simbad.blindworld.wavechange;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import simbad.blindworld.wave.Alteration;
import simbad.blindworld.wave.Burst;
import simbad.blindworld.wave.Outline;
import simbad.blindworld.wave.Reflector;
import simbad.blindworld.wave.Swaying;
import simbad.blindworld.wave.Target;
import simbad.blindworld.world.Point;

/** What no name of the vocabulary means, though some names may do as well. */
final class OutsideChanges {

  private static final String GAIN = "gain";
  private static final String MISALIGNMENT = "beam-misalignment";

  /** A receiver that is turned by less than loses so much is as good as a turned sonar. */
  private static final double SMALL_LOSS_DB = 1;

  private OutsideChanges() {}

  static List<WaveForm> all() {
    return List.of(
        WaveForm.anywhere("wind", OutsideChanges::wind),
        WaveForm.anywhere("wet-membrane", OutsideChanges::wetMembrane),
        WaveForm.anywhere("supply-voltage", OutsideChanges::supply),
        WaveForm.anywhere("short-burst", OutsideChanges::shortBurst),
        WaveForm.anywhere("carrier-shift", OutsideChanges::carrier),
        WaveForm.anywhere("receiver-turned", OutsideChanges::receiver),
        new WaveForm("foam", OutsideChanges::someEdged, OutsideChanges::foam),
        WaveForm.anywhere("sway", OutsideChanges::sway),
        WaveForm.anywhere("fading-transmitter", OutsideChanges::fading));
  }

  private static boolean someEdged(Site site) {
    return site.room().articles().stream().anyMatch(a -> !a.isRound());
  }

  /** Turbulence: what goes out and back through it scatters in level. */
  private static WaveEffect wind(Site site) {
    double db = Math.min(15, site.sized(4));
    return WaveEffect.of(
            "wind",
            Map.of("scatter_db", db),
            new Alteration() {
              @Override
              public double scatterDb(double scatterDb) {
                return StrictMath.hypot(scatterDb, db);
              }
            })
        .near(List.of(Set.of("dropout")));
  }

  /** Water on the membrane dries and comes again. */
  private static WaveEffect wetMembrane(Site site) {
    double db = site.sized(7);
    double wet = site.between(0.15, 0.4);
    double times = site.random().nextInt(1, 4);
    return drifting(
        "wet-membrane",
        Map.of("db", db, "dries_in", wet, "times", times),
        ping -> -db * StrictMath.exp(-(times * ping - Math.floor(times * ping)) / wet));
  }

  /** A battery gives way while the log is taken: the threshold rises with it. */
  private static WaveEffect supply(Site site) {
    double db = site.sized(7);
    double power = site.between(1.5, 4);
    return drifting(
        "supply-voltage",
        Map.of("db", db, "power", power),
        share -> -db * StrictMath.pow(share, power));
  }

  /** The transmitter's coupling comes and goes. */
  private static WaveEffect fading(Site site) {
    double db = site.sized(5);
    double waves = site.between(1.5, 5);
    return drifting(
        "fading-transmitter",
        Map.of("db", db, "waves", waves),
        share -> -db * (1 + StrictMath.sin(2 * Math.PI * waves * share)) / 2);
  }

  private interface Course {
    double db(double share);
  }

  private static WaveEffect drifting(String name, Map<String, Object> parameters, Course course) {
    return WaveEffect.of(
            name, parameters, Alterations.louder(0, (zero, ping) -> course.db(ping.share())))
        .near(List.of(Set.of(GAIN), Set.of("dropout"), Set.of("absorption")));
  }

  /** Fewer cycles reach less of the resonances' height; what is lost is found a little later. */
  private static WaveEffect shortBurst(Site site) {
    int before = site.parts().gear().burst().cycles();
    double left = Math.rint(before * StrictMath.pow(0.55, site.size()));
    int cycles = (int) Math.max(1, Math.min(before - 1.0, left));
    WaveEffect effect =
        WaveEffect.of(
            "short-burst",
            Map.of("cycles", cycles, "before", before),
            Alterations.gear(g -> g.with(g.burst().withCycles(cycles))));
    return weaker(effect, site);
  }

  private static WaveEffect carrier(Site site) {
    Burst burst = site.parts().gear().burst();
    double hz = burst.frequencyHz() * (1 + Math.max(-0.3, Math.min(0.3, site.eitherWay(0.03))));
    WaveEffect effect =
        WaveEffect.of(
            "carrier-shift",
            Map.of("hz", hz, "before", burst.frequencyHz()),
            Alterations.gear(g -> g.with(g.burst().withFrequency(hz))));
    return weaker(effect, site);
  }

  /** A burst that is only weaker may be called so, with the ranges that go with it. */
  private static WaveEffect weaker(WaveEffect effect, Site site) {
    List<Set<String>> same = new ArrayList<>();
    for (Set<String> names : Rivals.of(effect, site)) {
      String name = names.iterator().next();
      same.add(names);
      same.add(Set.of(name, "range-offset"));
      same.add(Set.of(name, "range-walk"));
    }
    return effect.accepting(same).near(same.isEmpty() ? List.of(Set.of(GAIN)) : List.of());
  }

  /** The receiver alone is turned: the beam looks half as far aside, and hears less. */
  private static WaveEffect receiver(Site site) {
    double deg = site.eitherWay(18);
    Alteration turned =
        Alterations.gear(g -> g.with(g.pistons().receiverTurned(Math.toRadians(deg))));
    double half = StrictMath.sin(Math.toRadians(Math.min(90, Math.abs(deg) / 2)));
    double ka =
        2
            * Math.PI
            * site.parts().gear().burst().frequencyHz()
            / site.parts().air().soundSpeedMPerS()
            * site.parts().gear().pistons().receiverRadiusM();
    // A piston is about a Gaussian, exp(-(ka sin)^2 / 8), and two of them aside are one, weaker.
    double lossDb = 2 * ka * ka * half * half / 8 * 20 / StrictMath.log(10);
    List<Set<String>> accept = new ArrayList<>(List.of(Set.of(MISALIGNMENT, GAIN)));
    if (lossDb < SMALL_LOSS_DB) {
      accept.add(Set.of(MISALIGNMENT));
    }
    return WaveEffect.of("receiver-turned", Map.of("deg", deg, "loss_db", lossDb), turned)
        .accepting(accept)
        .near(lossDb < SMALL_LOSS_DB ? List.of() : List.of(Set.of(MISALIGNMENT)));
  }

  /** One face of an obstacle, or some, are covered with something soft. */
  private static WaveEffect foam(Site site) {
    int index = site.someObstacle();
    while (site.room().articles().get(index).isRound()) {
      index = site.someObstacle();
    }
    List<Point> corners = site.room().articles().get(index).corners();
    double db = Math.min(60, site.sized(10));
    double centre = site.between(-Math.PI, Math.PI);
    double half = Math.toRadians(site.between(30, 75));
    List<Double> shares = new ArrayList<>();
    for (int i = 0; i < corners.size(); i++) {
      Point a = corners.get(i);
      Point b = corners.get((i + 1) % corners.size());
      double bearing = StrictMath.atan2(a.xM() + b.xM(), a.zM() + b.zM());
      boolean covered = Math.abs(Math.IEEEremainder(bearing - centre, 2 * Math.PI)) < half;
      shares.add(covered ? StrictMath.pow(10, -db / 20) : 1);
    }
    Outline outline = Outline.covered(corners, shares);
    return WaveEffect.of(
            "foam",
            Map.of(
                "obstacle",
                index,
                "centre",
                Math.toDegrees(centre),
                "half",
                Math.toDegrees(half),
                "db",
                db),
            Alterations.instead(index, r -> r instanceof Target t ? t.with(outline) : r))
        .near(List.of(Set.of("obstacle-turn"), Set.of(GAIN)));
  }

  /** An obstacle hangs and swings. */
  private static WaveEffect sway(Site site) {
    int index = site.someObstacle();
    double m = site.sized(0.05);
    double direction = site.between(0, 2 * Math.PI);
    double periodS = site.between(1.3, 9);
    return WaveEffect.of(
            "sway",
            Map.of("obstacle", index, "m", m, "period_s", periodS),
            Alterations.instead(index, r -> swaying(r, m, direction, periodS)))
        .near(List.of(Set.of("range-noise"), Set.of("obstacle-offset")));
  }

  private static Reflector swaying(Reflector reflector, double m, double direction, double s) {
    return reflector instanceof Target target
        ? new Swaying(target, m * StrictMath.cos(direction), m * StrictMath.sin(direction), s)
        : reflector;
  }
}
