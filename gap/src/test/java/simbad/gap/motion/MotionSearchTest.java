package simbad.gap.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import simbad.motion.MotionChain;
import simbad.motion.Robot;
import simbad.motion.effect.MotionForm;
import simbad.motion.effect.MotionForms;
import simbad.motion.format.MotionData;

/** Sets that are looked for in a drive of a minute. */
class MotionSearchTest {
  private static final MotionHypothesis NONE =
      new MotionHypothesis(MotionChain.EXACT, List.of(), new double[0]);

  private static MotionForm form(String name) {
    return MotionForms.find(name).orElseThrow();
  }

  private static MotionData data(Consumer<Drives> world) {
    Drives drives = new Drives(68);
    drives.seconds = 60;
    world.accept(drives);
    return drives.data();
  }

  private static MotionSearch search(Consumer<Drives> world) {
    MotionData data = data(world);
    return new MotionSearch(new MotionSteps(data.runs()), data.robot());
  }

  /** Clocks that differ are looked for only where they may; wheels where there are some. */
  @Test
  void aRobotSaysWhichFormsThereAre() {
    Robot two = new Robot(false, 0, true, 0, 0, MotionChain.EXACT);
    Robot wheels = new Robot(true, 0.2, false, 0, 0, MotionChain.EXACT);
    List<MotionForm> ofOneClock = MotionForms.ALL.stream().filter(one -> !one.clocks()).toList();

    assertEquals(MotionForms.ALL.size() - 1, ofOneClock.size());
    assertEquals(ofOneClock, MotionSearch.forms(Robot.EXACT_UNICYCLE));
    assertEquals(MotionForms.ALL, MotionSearch.forms(two));
    assertEquals(ofOneClock.size() + 5, MotionSearch.forms(wheels).size());
  }

  private static MotionFit fit(String... forms) {
    MotionHypothesis set = NONE;
    for (String name : forms) {
      set = set.with(form(name), form(name).neutralValues());
    }
    return new MotionFit(set, new double[3][0], new Noise[3], 40);
  }

  /** Members of up to three are exchanged; six effects are enough. */
  @Test
  void largeSetsAreLeftAsTheyAre() {
    MotionSearch search = search(drives -> drives.seconds = 8);
    MotionFit three = fit("speed-scale", "turn-scale", "turn-bias");
    MotionFit four = fit("speed-scale", "turn-scale", "turn-bias", "actuation-latency");
    List<String> six =
        new ArrayList<>(four.hypothesis().forms().stream().map(f -> f.form()).toList());
    six.add("wheel-asymmetry");
    assertFalse(search.isLast(fit(six.toArray(String[]::new))));
    six.add("dead-band");

    assertEquals(three.hypothesis().forms(), search.exchanged(three));
    assertEquals(List.of(), search.exchanged(four));
    assertTrue(search.isLast(fit(six.toArray(String[]::new))));
    assertEquals(List.of(), search.beside(fit(six.toArray(String[]::new)), List.of(), three));
    assertEquals(Set.of("speed-scale", "turn-scale", "turn-bias"), search.effects(three));
    // A value costs a nat where nothing hangs together.
    assertEquals(40 - 3, search.worth(three), 1e-12);
    assertEquals(three, search.settled(three));
  }

  /** The likeliest on left-out blocks first; the empty set is among them. */
  @Test
  void whatIsAtWorkIsFound() {
    List<ScoredMotion> sets =
        search(
                drives -> {
                  drives.lateS = 0.3;
                  drives.turnFactor = 1.1;
                })
            .run(MotionChain.EXACT);
    Odds odds = new Odds(sets);

    assertEquals(Set.of("actuation-latency", "turn-scale"), odds.best().hypothesis().effects());
    assertEquals(0.3, odds.best().hypothesis().values(form("actuation-latency"))[0], 0.01);
    assertEquals(0.1, odds.best().hypothesis().values(form("turn-scale"))[0] - 1, 0.01);
    assertEquals(List.of(), odds.nominal().hypothesis().forms());
    for (int i = 1; i < sets.size(); i++) {
      assertTrue(sets.get(i).heldOut() <= sets.get(i - 1).heldOut());
    }
    // So is the set without each of its effects.
    for (String one : List.of("actuation-latency", "turn-scale")) {
      assertTrue(sets.stream().anyMatch(s -> s.hypothesis().effects().equals(Set.of(one))), one);
    }
    assertTrue(sets.size() <= 12 + 3);
  }

  @Test
  void anEffectIsNoLongerLookedFor() {
    MotionForm late = form("actuation-latency");
    List<ScoredMotion> sets =
        search(
                drives -> {
                  drives.lateS = 0.3;
                  drives.speedFactor = 1.2;
                })
            .without(late.effect())
            .about(MotionChain.EXACT, NONE.with(form("speed-scale"), new double[] {1.1}));

    assertTrue(sets.stream().noneMatch(one -> one.hypothesis().names(late.effect())));
    assertTrue(sets.get(0).hypothesis().names("speed-scale"));
    assertTrue(sets.stream().anyMatch(one -> one.hypothesis().forms().isEmpty()));
  }

  /** Of a set that another one left: nobody may have asked what it would be without each. */
  @Test
  void whatASetWouldBeWithoutEachEffect_isFitted() {
    MotionSearch search =
        search(
            drives -> {
              drives.lateS = 0.3;
              drives.speedFactor = 1.2;
            });
    Odds odds = new Odds(search.run(MotionChain.EXACT));
    ScoredMotion best = odds.best();
    assertEquals(Set.of("actuation-latency", "speed-scale"), best.hypothesis().effects());
    Odds alone = new Odds(List.of(best, odds.nominal()));
    assertEquals(odds.nominal(), alone.lacking("speed-scale"));

    Odds asked = alone.and(search.rests(best));
    ScoredMotion late = asked.lacking("speed-scale");
    assertEquals(Set.of("actuation-latency"), late.hypothesis().effects());
    assertEquals(0.3, late.hypothesis().values(form("actuation-latency"))[0], 0.05);
    assertEquals(Set.of("speed-scale"), asked.lacking("actuation-latency").hypothesis().effects());
    assertEquals(best, asked.best());
    // Once more says nothing new.
    assertEquals(late.heldOut(), asked.and(search.rests(best)).lacking("speed-scale").heldOut());
  }

  /** Whatever makes left-out blocks likelier, and nothing that only large commands show. */
  @Test
  void aReferenceTakesWhatIsSmall() {
    MotionData data = data(drives -> drives.turnFactor = 1.02);
    MotionSteps given = new MotionSteps(data.runs());
    MotionSearch search = new MotionSearch(given, data.robot());
    double[][] residuals = given.residuals(MotionChain.EXACT);
    MotionFit plain = new MotionFit(NONE, residuals, NoiseFit.afresh(given, residuals), 0);
    ScoredMotion none = ScoredMotion.of(given, plain);
    ScoredMotion best = search.calibrated(none);

    assertTrue(best.heldOut() > none.heldOut() + 1);
    assertTrue(best.hypothesis().names("turn-scale"));
    assertEquals(1.02, best.hypothesis().values(form("turn-scale"))[0], 0.005);
    assertTrue(
        Stream.of("dead-band", "saturation").noneMatch(name -> best.hypothesis().names(name)));
  }
}
