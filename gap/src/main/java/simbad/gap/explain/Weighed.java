package simbad.gap.explain;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import simbad.gap.fit.Evidence;
import simbad.sonar.effect.Effect;

/**
 * Sets of effects weighed against each other. A set that makes the gap of rows larger that it was
 * not fitted on explains nothing, however much likelier it makes them: the next one takes its
 * place.
 *
 * @param probabilities of the sets that are left
 * @param gain of the most probable one
 * @param enlarging sets that would have been taken, but for the gap that they enlarge
 */
public record Weighed(Probabilities probabilities, Gain gain, List<Scored> enlarging) {
  /** Copies the list. */
  public Weighed {
    enlarging = List.copyOf(enlarging);
  }

  /**
   * Weighs sets, the nominal model among them.
   *
   * @param evidence the log
   * @param sets that were fitted
   * @param worthNats what a further effect must gain to be as probable as its absence
   * @param clumping by how much the readings hang together
   */
  public static Weighed of(
      Evidence evidence, List<Scored> sets, double worthNats, double clumping) {
    PracticalSize size = new PracticalSize(evidence, sets);
    Blocks blocks = new Blocks(evidence.log());
    double most = (1 + Probabilities.UNSEEN) * worthNats;
    Set<Effect> unseen = EnumSet.noneOf(Effect.class);
    List<Scored> left = new ArrayList<>(sets);
    List<Scored> enlarging = new ArrayList<>();
    while (true) {
      Probabilities probabilities = new Probabilities(left, worthNats, clumping, unseen);
      Scored best = probabilities.best();
      if (unseen.addAll(size.unseen(best, most))) {
        continue;
      }
      Gain gain = Gain.of(evidence, blocks, best.hypothesis());
      if (gain.afterM() <= gain.beforeM()) {
        return new Weighed(probabilities, gain, enlarging);
      }
      left.remove(best);
      enlarging.add(best);
    }
  }
}
