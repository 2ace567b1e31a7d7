package simbad.gap.score;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.Worlds;
import simbad.gap.score.HeldOut.Scored;

class PracticalSizeTest {
  private static Set<Effect> unseen(double offsetM, double gainedNats, double nats) {
    Hypothesis offset = Worlds.effect(Effect.RANGE_OFFSET, "constant", offsetM);
    // Six blocks of 25 rows.
    CalibratedLog given = Worlds.given(Worlds.read(Worlds.poses(150, 0.3, 1.3, 5), offset, 6));
    Scored set = new Scored(offset, 0, gainedNats);
    List<Scored> sets = List.of(new Scored(Hypothesis.NONE, 0, 0), set);
    return new PracticalSize(new GapGains(given), sets).unseen(set, nats);
  }

  @Test
  void whatShrinksTheGapOfEveryBlock_isSeen() {
    assertEquals(Set.of(), unseen(0.05, 20, 30));
  }

  /** A tenth of a millimetre, where a reading scatters by 5 mm and counts in steps of 1 cm. */
  @Test
  void whatDoesNotShrinkTheGap_isUnseen() {
    assertEquals(Set.of(Effect.RANGE_OFFSET), unseen(1e-4, 20, 30));
  }

  @Test
  void whatHasMoreEvidence_isThereHoweverSmall() {
    assertEquals(Set.of(), unseen(1e-4, 30, 30));
  }

  /** Without the set that lacks it there is nothing to compare with. */
  @Test
  void whatStandsAlone_isNotJudged() {
    Hypothesis offset = Worlds.effect(Effect.RANGE_OFFSET, "constant", 1e-4);
    CalibratedLog given = Worlds.given(Worlds.read(Worlds.poses(150, 0.3, 1.3, 5), offset, 6));
    Scored set = new Scored(offset, 0, 1);
    assertEquals(Set.of(), new PracticalSize(new GapGains(given), List.of(set)).unseen(set, 30));
  }
}
