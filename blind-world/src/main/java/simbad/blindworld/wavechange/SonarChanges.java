package simbad.blindworld.wavechange;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import simbad.blindworld.wave.Air;
import simbad.blindworld.wave.Alteration;
import simbad.blindworld.wave.Ear;
import simbad.blindworld.wave.Gear;
import simbad.blindworld.wave.WavePing;

/** What happens to air, sonar and timer. */
final class SonarChanges {

  private static final String GAIN = "gain";
  private static final String ABSORPTION = "absorption";

  private SonarChanges() {}

  static List<WaveForm> all() {
    return List.of(
        WaveForm.anywhere("sound-speed", SonarChanges::temperature),
        WaveForm.anywhere(ABSORPTION, SonarChanges::humidity),
        WaveForm.anywhere(GAIN, SonarChanges::amplifier),
        WaveForm.anywhere("early-timeout", SonarChanges::timeout),
        WaveForm.anywhere("dead-zone", SonarChanges::ringing),
        WaveForm.anywhere("beam-pattern", site -> membrane("beam-pattern", site)),
        WaveForm.anywhere("beam-width", site -> membrane("beam-width", site)),
        WaveForm.anywhere("beam-misalignment", SonarChanges::bump),
        WaveForm.anywhere("range-offset", SonarChanges::timer),
        WaveForm.anywhere("range-noise", SonarChanges::jitter),
        WaveForm.anywhere("range-drift", SonarChanges::warmUp),
        WaveForm.anywhere("wave-hop", SonarChanges::hops),
        WaveForm.anywhere("coarse-resolution", SonarChanges::coarse));
  }

  /** The air is warmer or colder: sound is faster or slower, and absorbed otherwise. */
  private static WaveEffect temperature(Site site) {
    Air air = site.parts().air();
    double kelvin =
        Math.max(-35 - air.temperatureC(), Math.min(65 - air.temperatureC(), site.eitherWay(11)));
    Air other = air.warmer(kelvin);
    double hz = site.parts().gear().burst().frequencyHz();
    Map<String, Object> parameters =
        Map.of("kelvin", kelvin, "c", other.soundSpeedMPerS(), "alpha", other.absorptionDbPerM(hz));
    WaveEffect effect =
        WaveEffect.of("sound-speed", parameters, Alterations.air(a -> a.warmer(kelvin)));
    return effect
        .accepting(List.of(Set.of("sound-speed", GAIN), Set.of("sound-speed", ABSORPTION)))
        .near(List.of(Set.of("odometry-scale")));
  }

  /** The air is damper or drier. Of all humidities the one that comes nearest to what is wanted. */
  private static WaveEffect humidity(Site site) {
    Air air = site.parts().air();
    double hz = site.parts().gear().burst().frequencyHz();
    double before = air.absorptionDbPerM(hz);
    double wanted = site.sized(0.5);
    double best = air.humidityPercent();
    double least = Double.POSITIVE_INFINITY;
    for (double percent = 2; percent <= 99; percent += 0.5) {
      double differs = Math.abs(air.withHumidity(percent).absorptionDbPerM(hz) - before);
      // The first of equal ones; dry air and damp air may absorb alike.
      if (Math.abs(differs - wanted) < least) {
        least = Math.abs(differs - wanted);
        best = percent;
      }
    }
    double percent = best;
    Map<String, Object> parameters =
        Map.of(
            "rh",
            percent,
            "alpha",
            air.withHumidity(percent).absorptionDbPerM(hz),
            "before",
            before);
    return lost(
        WaveEffect.of(ABSORPTION, parameters, Alterations.air(a -> a.withHumidity(percent))), site);
  }

  /** With what loses the same echoes. */
  static WaveEffect lost(WaveEffect effect, Site site) {
    List<Set<String>> same = Rivals.of(effect, site);
    List<Set<String>> others =
        new ArrayList<>(List.of(Set.of(GAIN), Set.of(ABSORPTION), Set.of("early-timeout")));
    others.removeAll(same);
    others.remove(Set.of(effect.name()));
    return effect.accepting(same).near(others);
  }

  private static WaveEffect amplifier(Site site) {
    double db = site.random().nextInt(10) < 7 ? -site.sized(3.5) : site.sized(3.5);
    return lost(WaveEffect.of(GAIN, Map.of("db", db), Alterations.gear(g -> g.louder(db))), site);
  }

  private static WaveEffect timeout(Site site) {
    double most = site.heardM(1 - site.sized(0.22));
    double timeS = site.timeS(most);
    return lost(
        WaveEffect.of(
            "early-timeout",
            Map.of("m", most),
            Alterations.gear(g -> g.with(g.receiver().withTimeout(timeS)))),
        site);
  }

  /** The transmitter rings longer, and the receiver waits for it. */
  private static WaveEffect ringing(Site site) {
    double least = site.heardM(Math.min(0.7, site.sized(0.22)));
    double timeS = site.timeS(least);
    return WaveEffect.of(
        "dead-zone",
        Map.of("m", least),
        Alterations.gear(g -> g.with(g.receiver().armedAt(timeS))));
  }

  /** Another opening before the membranes: a wider or narrower beam of the same level ahead. */
  private static WaveEffect membrane(String name, Site site) {
    double times = Math.max(0.3, Math.min(3, StrictMath.exp(site.eitherWay(0.3))));
    Alteration alteration = Alterations.gear((Gear g) -> g.with(g.pistons().scaled(times)));
    String other = name.equals("beam-width") ? "beam-pattern" : "beam-width";
    return WaveEffect.of(name, Map.of("ka_times", times), alteration)
        .accepting(List.of(Set.of(other), Set.of(name, other)));
  }

  private static WaveEffect bump(Site site) {
    double deg = site.eitherWay(7);
    return WaveEffect.of(
        "beam-misalignment",
        Map.of("deg", deg),
        Alterations.gear(g -> g.with(g.pistons().turned(Math.toRadians(deg)))));
  }

  private static WaveEffect timer(Site site) {
    double m = site.eitherWay(0.035);
    return WaveEffect.of("range-offset", Map.of("m", m), Alterations.range((r, ping) -> r + m));
  }

  private static WaveEffect jitter(Site site) {
    double m = site.sized(0.025);
    return WaveEffect.of(
        "range-noise",
        Map.of("m", m),
        Alterations.range((r, ping) -> r + m * ping.random().nextGaussian()));
  }

  private static WaveEffect warmUp(Site site) {
    double m = site.eitherWay(0.06);
    double timeS = Math.max(1, site.recording().longestS()) * site.between(0.2, 0.5);
    return WaveEffect.of(
            "range-drift",
            Map.of("m", m, "time_s", timeS),
            Alterations.range((r, ping) -> r + m * (1 - StrictMath.exp(-ping.tS() / timeS))))
        .near(List.of(Set.of("range-offset")));
  }

  /** The comparator takes now this crest of the carrier, now one of the next. */
  private static WaveEffect hops(Site site) {
    int most = (int) Math.max(1, Math.round(site.sized(5)));
    double periodS = 1 / site.parts().gear().burst().frequencyHz();
    return WaveEffect.of(
            "wave-hop",
            Map.of("most", most),
            Alterations.arrival(() -> (t, ping) -> t + periodS * ping.random().nextInt(most + 1)))
        .accepting(
            List.of(Set.of("wave-hop", "range-offset"), Set.of("range-noise", "range-offset")));
  }

  private static WaveEffect coarse(Site site) {
    double fine = site.scene().sensor().resolutionM();
    double step = Math.max(1, Math.round(site.sized(0.045) / fine)) * fine;
    return WaveEffect.of(
        "coarse-resolution",
        Map.of("m", step),
        Alterations.ear(
            () ->
                new Ear() {
                  @Override
                  public double steppedM(double readingM, double rangeM, WavePing ping) {
                    return Math.floor(rangeM / step + 1e-9) * step;
                  }
                }));
  }
}
