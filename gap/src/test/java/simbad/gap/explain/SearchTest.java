package simbad.gap.explain;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import simbad.gap.fit.Evidence;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.Worlds;
import simbad.sonar.effect.Effect;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;

/** What two effects do together, one that fits neither may seem to do alone. */
class SearchTest {
  /** The most probable pair. */
  private static Set<Effect> found(Hypothesis truth) {
    Evidence evidence = Worlds.evidence(Worlds.read(Worlds.poses(1000, 0.3, 1.7, 51), truth, 52));
    List<Scored> sets = new Search(evidence, Set.of(), 10).run();
    return sets.stream()
        .map(set -> set.hypothesis().effects())
        .filter(effects -> effects.size() == 2)
        .findFirst()
        .map(Set::copyOf)
        .orElseThrow();
  }

  private static Hypothesis both(Hypothesis one, Effect effect, String name, double... values) {
    Form form = Forms.find(effect, name, Worlds.POST, List.of("s")).orElseThrow();
    return one.and(form, values);
  }

  /** Alone either explains little, and noise nearly all. */
  @Test
  void scaleAndPlace_areFoundThroughWhatSoakedThemUp() {
    Hypothesis offset = Worlds.effect(Effect.OBSTACLE_OFFSET, "all", -0.045, -0.055);
    assertEquals(
        Set.of(Effect.OBSTACLE_OFFSET, Effect.SOUND_SPEED),
        found(both(offset, Effect.SOUND_SPEED, "scale", 322)));
  }
}
