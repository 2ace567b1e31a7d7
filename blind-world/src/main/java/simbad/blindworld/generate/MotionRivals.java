package simbad.blindworld.generate;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.random.RandomGenerator;
import simbad.blindworld.motionchange.MotionEffect;
import simbad.blindworld.motionchange.MotionSite;
import simbad.blindworld.motionchange.MotionVocabulary;
import simbad.blindworld.world.Chance;

/** Whether another effect would have done the same. */
final class MotionRivals {

  private static final int REPEATS = 40;
  private static final int FEW_REPEATS = 24;

  /** What shows by less cannot be told apart, what shows by more can. */
  private static final double SAME = 2;

  private static final double NEAR = 4;

  /** Something without a name has to be better than any name by so many standard errors. */
  private static final double APART = 4;

  private static final double[] SIZES = {0.3, 0.6, 1.2, 2.4};

  /** What a diagnosis would try for something that it has no name for. */
  private static final List<String> ANY =
      List.of(
          "speed-scale",
          "turn-scale",
          "wheel-scale",
          "wheel-asymmetry",
          "turn-bias",
          "actuation-latency",
          "actuation-lag",
          "motion-noise",
          "slip",
          "capture-offset");

  private static final Set<String> WITHOUT_SIGN =
      Set.of(
          "actuation-latency",
          "actuation-lag",
          "motion-noise",
          "slip",
          "saturation",
          "dead-band",
          "command-quantization");

  private MotionRivals() {}

  /** The sets of names by which an effect may be called, and by which it nearly may. */
  static MotionCase.Called called(MotionDrawing.Shown shown, MotionEffect effect, long seed) {
    Chance random = new Chance(seed);
    List<Set<String>> accept = new ArrayList<>(MotionVocabulary.accept(effect.name()));
    List<Set<String>> also = new ArrayList<>();
    for (String rival : MotionVocabulary.rivals(effect.name())) {
      double z = leastZ(shown, effect, rival, REPEATS, random);
      if (z < SAME) {
        accept.add(Set.of(rival));
      } else if (z < NEAR) {
        also.add(Set.of(rival));
      }
    }
    return new MotionCase.Called(accept, also);
  }

  /** True when an effect of the vocabulary forecasts as well as something that has no name. */
  static boolean hides(MotionDrawing.Shown shown, MotionEffect effect, long seed) {
    Chance random = new Chance(seed);
    Set<String> there = Set.copyOf(shown.effects().stream().map(MotionEffect::name).toList());
    return ANY.stream()
        .filter(name -> !there.contains(name))
        .anyMatch(name -> leastZ(shown, effect, name, FEW_REPEATS, random) < APART);
  }

  /**
   * By how many standard errors the truth is better than a rival of whatever size suits it best.
   */
  private static double leastZ(
      MotionDrawing.Shown shown, MotionEffect effect, String rival, int repeats, Chance random) {
    double least = Double.POSITIVE_INFINITY;
    String form = MotionVocabulary.forms(rival).get(0);
    for (double size : SIZES) {
      for (long sign : WITHOUT_SIGN.contains(rival) ? new long[] {0} : new long[] {0, -1}) {
        RandomGenerator fixed = () -> sign;
        MotionDrawing.Ground ground = shown.ground();
        MotionSite site = new MotionSite(ground.setup().robot(), ground.outing(), fixed, size);
        List<MotionEffect> others = new ArrayList<>(shown.without(effect));
        others.add(MotionVocabulary.draw(rival, form, site));
        least = Math.min(least, shown.over(others, repeats, random.nextLong()).standardErrors());
      }
    }
    return least;
  }
}
