package simbad.gap.search;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.Worlds;
import simbad.gap.score.HeldOut.Scored;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.frame.Pose;
import simbad.sonar.sensing.ReadingRow;

/** What two effects do together, one that fits neither may seem to do alone. */
class SearchTest {
  /** The most probable pair. */
  private static Set<Effect> found(Hypothesis truth) {
    CalibratedLog given = Worlds.given(Worlds.read(Worlds.poses(1000, 0.3, 1.7, 51), truth, 52));
    List<Scored> sets = new Search(given, Set.of(), 10, Optional.empty()).run();
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

  /** What an effect takes up is asked of the others once it is excluded. */
  @Test
  void excluded_isInNoSet() {
    Hypothesis offset = Worlds.effect(Effect.RANGE_OFFSET, "constant", 0.05);
    CalibratedLog given = Worlds.given(Worlds.read(Worlds.poses(80, 0.3, 1.7, 51), offset, 52));
    List<Scored> sets = new Search(given, Set.of(Effect.RANGE_OFFSET), 10, Optional.empty()).run();
    assertTrue(sets.size() > 1);
    assertTrue(sets.stream().noneMatch(set -> set.hypothesis().has(Effect.RANGE_OFFSET)));
  }

  /** Each changes something else: how far, how wide, how often. */
  @Test
  void threeEffectsThatAreLarge_areFoundTogether() {
    Hypothesis speed = Worlds.effect(Effect.SOUND_SPEED, "scale", 330);
    Hypothesis two = both(speed, Effect.BEAM_WIDTH, "cone", 8);
    Hypothesis truth = both(two, Effect.DROPOUT, "single", 0.3);
    Random random = new Random(55);
    List<ReadingRow> poses =
        Worlds.poses(400, 0.3, 1.7, 53).stream()
            .map(row -> turned(row, random.nextDouble(-0.7, 0.7)))
            .toList();
    CalibratedLog given = Worlds.given(Worlds.read(poses, truth, 54));
    List<Scored> sets = new Search(given, Set.of(), 10, Optional.empty()).run();
    Scored best =
        sets.stream().filter(set -> set.hypothesis().forms().size() == 3).findFirst().orElseThrow();
    assertEquals(Set.copyOf(truth.effects()), Set.copyOf(best.hypothesis().effects()));
  }

  private static ReadingRow turned(ReadingRow row, double byRad) {
    Pose pose = row.pose();
    double heading = pose.heading().radians() + byRad;
    Pose turned = Pose.of(pose.position().xM(), pose.position().zM(), heading);
    return new ReadingRow(row.run(), row.sensor(), row.timeS(), turned, row.reading());
  }
}
