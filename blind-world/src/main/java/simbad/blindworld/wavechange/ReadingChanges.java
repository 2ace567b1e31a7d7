package simbad.blindworld.wavechange;

import static simbad.blindworld.wavechange.Alterations.isEcho;

import java.util.List;
import java.util.Map;
import java.util.Set;
import simbad.blindworld.effect.Effect;
import simbad.blindworld.effect.Vocabulary;
import simbad.blindworld.wave.Alteration;
import simbad.blindworld.wave.WavePing;
import simbad.blindworld.world.Change;
import simbad.blindworld.world.Pose;
import simbad.blindworld.world.Recording;

/** What happens to poses and to what is read and reported. */
final class ReadingChanges {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  private ReadingChanges() {}

  static List<WaveForm> all() {
    return List.of(
        pose("latency", "seconds", List.of()),
        pose("odometry-scale", "from the start", List.of(Set.of("sound-speed"))),
        pose("heading-drift", "in place", List.of(Set.of("beam-misalignment"))),
        WaveForm.anywhere("dropout", ReadingChanges::dropout),
        WaveForm.anywhere("crosstalk", ReadingChanges::crosstalk),
        WaveForm.anywhere("stale-reading", ReadingChanges::stale),
        WaveForm.anywhere("near-clamp", ReadingChanges::clamp),
        WaveForm.anywhere("no-echo-code", ReadingChanges::code));
  }

  /** Where a robot really is has nothing to do with waves: the forms are those of other worlds. */
  private static WaveForm pose(String name, String form, List<Set<String>> also) {
    return new WaveForm(
        name,
        true,
        Site::driven,
        site -> {
          Effect effect = Vocabulary.draw(name, form, site.circumstances());
          return WaveEffect.of(name, effect.parameters(), moved(effect.change(), site)).near(also);
        });
  }

  private static Alteration moved(Change change, Site site) {
    return new Alteration() {
      @Override
      public List<Pose> poses(Recording recording, List<Pose> poses) {
        return change.poses(recording, poses, site.random());
      }
    };
  }

  /** A loose wire: echoes are lost singly or in bursts. */
  private static WaveEffect dropout(Site site) {
    double share = Math.min(0.9, site.sized(0.2));
    boolean single = site.random().nextBoolean();
    double length = single ? 1 : site.between(3, 12);
    double ends = 1 / length;
    double begins = Math.min(1, share / (1 - share) * ends);
    return WaveEffect.of(
        "dropout",
        Map.of("share", share, "mean_length", length),
        Alterations.arrival(
            () -> {
              boolean[] lost = {false};
              return (t, ping) -> {
                double draw = ping.random().nextDouble();
                boolean begun = ping.indexInTrack() > 0 && !single;
                boolean on = begun ? (lost[0] ? draw >= ends : draw < begins) : draw < share;
                lost[0] = on;
                return on ? NEVER : t;
              };
            }));
  }

  /** Another sonar pings by its own clock, or something hisses. */
  private static WaveEffect crosstalk(Site site) {
    return site.random().nextBoolean() ? otherSonar(site) : hiss(site);
  }

  private static WaveEffect otherSonar(Site site) {
    double otherS = site.between(0.05, 0.2);
    double chance = Math.min(1, site.sized(0.5));
    double drift = site.between(-0.02, 0.02);
    double openS = site.parts().gear().receiver().timeoutS();
    double armS = site.parts().gear().receiver().armS();
    return WaveEffect.of(
        "crosstalk",
        Map.of("period_s", otherS, "chance", chance),
        Alterations.arrival(
            () -> {
              double[] phase = {Double.NaN};
              return (t, ping) -> {
                if (Double.isNaN(phase[0])) {
                  phase[0] = ping.random().nextDouble();
                }
                double turns = phase[0] - ping.tS() * (1 + drift) / otherS;
                double at = (turns - Math.floor(turns)) * otherS;
                boolean heard = ping.random().nextDouble() < chance;
                return heard && at > armS && at < openS ? Math.min(t, at) : t;
              };
            }));
  }

  /** Broadband noise, as of compressed air, that is now and then over the threshold by itself. */
  private static WaveEffect hiss(Site site) {
    double ratio = site.parts().gear().receiver().floor() / site.parts().gear().receiver().noise();
    // Of so many standard deviations the threshold is when one ping in seven is false.
    double over = 3.6 / StrictMath.pow(site.size(), 0.1);
    double times = Math.max(1, ratio / over);
    return WaveEffect.of(
        "crosstalk",
        Map.of("noise_times", times),
        Alterations.gear(g -> g.with(g.receiver().noisier(times))));
  }

  private static WaveEffect stale(Site site) {
    int most = (int) Math.max(1, Math.round(site.sized(4)));
    return WaveEffect.of(
        "stale-reading", Map.of("n", most), Alterations.report(() -> new Held(most)));
  }

  /** Repeats the last real reading for so many misses. */
  private static final class Held implements Alterations.Value {

    private final int most;
    private double heldM = NEVER;
    private int used;

    Held(int most) {
      this.most = most;
    }

    @Override
    public double of(double readingM, WavePing ping) {
      if (isEcho(readingM)) {
        heldM = readingM;
        used = 0;
        return readingM;
      }
      used++;
      heldM = used <= most ? heldM : NEVER;
      return heldM;
    }
  }

  private static WaveEffect clamp(Site site) {
    double least = site.heardM(Math.min(0.7, site.sized(0.22)));
    return WaveEffect.of(
        "near-clamp",
        Map.of("m", least),
        Alterations.report(() -> (r, ping) -> isEcho(r) ? Math.max(r, least) : r));
  }

  /** Nothing heard is said by a number. */
  private static WaveEffect code(Site site) {
    double maxM = site.scene().sensor().maxRangeM();
    boolean asNought = site.random().nextBoolean() || site.scene().noEchoM() == maxM;
    double m = asNought ? 0 : maxM;
    return WaveEffect.of(
        "no-echo-code", Map.of("m", m), Alterations.report(() -> (r, ping) -> isEcho(r) ? r : m));
  }
}
