package simbad.gap.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import simbad.gap.diagnosis.Interval;
import simbad.motion.Command;
import simbad.motion.CommandUse;
import simbad.motion.MotionChain;
import simbad.motion.MotionRun;
import simbad.motion.TrackPose;
import simbad.motion.effect.MotionForm;
import simbad.motion.effect.MotionForms;

/** Sets of effects weighed by figures that are set by hand, and what follows from drives. */
class MotionFiguresTest {
  private static final double EXACT = 1e-9;
  private static final MotionForm LATE = form("actuation-latency");
  private static final MotionForm SCALE = form("speed-scale");
  private static final MotionForm TURN = form("turn-scale");
  private static final MotionForm STEPS = form("command-quantization");
  private static final List<MotionRun> RUNS = runs(drives -> drives.seconds = 40);
  private static final MotionSteps GIVEN = new MotionSteps(RUNS);
  private static final MotionHypothesis NONE =
      new MotionHypothesis(MotionChain.EXACT, List.of(), new double[0]);
  private static final ScoredMotion NOMINAL =
      ScoredMotion.of(GIVEN, new MotionFitter(GIVEN, CommandUse.of(RUNS, 0)).asItIs(NONE));

  private static MotionForm form(String name) {
    return MotionForms.find(name).orElseThrow();
  }

  private static List<MotionRun> runs(Consumer<Drives> world) {
    Drives drives = new Drives(61);
    world.accept(drives);
    return drives.data().runs();
  }

  /** A set with the log densities of blocks that are said. */
  private static ScoredMotion set(MotionHypothesis hypothesis, double... blocks) {
    MotionFit own = NOMINAL.fit();
    MotionFit fit = new MotionFit(hypothesis, own.residuals(), own.noises(), 0);
    return new ScoredMotion(fit, NOMINAL.slopes(), blocks);
  }

  private static double[] tenOf(double each) {
    double[] all = new double[10];
    Arrays.fill(all, each);
    return all;
  }

  private static final MotionHypothesis WITH_LATE = NONE.with(LATE, new double[] {0.3});
  private static final MotionHypothesis WITH_SCALE = NONE.with(SCALE, new double[] {1.2});

  /** 6 nats for each effect, over 1.5 and what hangs together. */
  @Test
  void setsAreWeighedByWhatTheyForetell() {
    double[] late = tenOf(3 * NOMINAL.slopes().linear().clumping());
    Odds odds = new Odds(List.of(set(NONE, tenOf(0)), set(WITH_LATE, late)));
    double one = Math.exp((30 - 6) / 1.5);

    assertEquals(Map.of(LATE.effect(), one / (1 + one)), odds.ofEffects());
    assertEquals(WITH_LATE, odds.best().hypothesis());
    assertEquals(NONE, odds.nominal().hypothesis());
    assertEquals(1 / (1 + Math.exp(-2 / 1.5)), odds.ofGain(8 * odds.clumping()), EXACT);
    assertEquals(NONE, odds.without(LATE.effect()).best().hypothesis());
    assertSame(odds.nominal(), odds.lacking(LATE.effect()));
    assertEquals(WITH_LATE, odds.bestWith(LATE.effect()).hypothesis());
    assertEquals(WITH_LATE, odds.bestWith("no-such-effect").hypothesis());
  }

  /** Two values that jump cost 2 nats each beside the effect's 6. */
  @Test
  void whatJumpsCostsMore() {
    MotionHypothesis steps = NONE.with(STEPS, new double[] {0.04, 0});
    ScoredMotion jumping = set(steps, tenOf(0.9 * NOMINAL.slopes().linear().clumping()));
    long count = STEPS.parameters().stream().filter(p -> p.stepped()).count();
    Odds odds = new Odds(List.of(set(NONE, tenOf(0)), jumping));
    double share = Math.exp((9 - 6 - 2 * count) / 1.5);

    assertEquals(count, jumping.jumping());
    assertTrue(count > 0);
    assertEquals(0, set(WITH_LATE, 1, 2, 4).jumping());
    assertEquals(7, set(WITH_LATE, 1, 2, 4).heldOut(), 0);
    assertEquals(
        share / (1 + share), Objects.requireNonNull(odds.ofEffects().get(STEPS.effect())), EXACT);
  }

  private static List<String> ties(double... scale) {
    double clumping = NOMINAL.slopes().linear().clumping();
    double[] blocks = Arrays.stream(scale).map(nats -> nats * clumping).toArray();
    Odds odds =
        new Odds(
            List.of(
                set(NONE, tenOf(-9 * clumping)),
                set(WITH_LATE, tenOf(3 * clumping)),
                set(WITH_SCALE, blocks)));
    return odds.tiesOf(LATE.effect());
  }

  /** 2 nats behind is as good; 10 nats are not, unless blocks do not agree on that. */
  @Test
  void whatIsNearlyAsLikelyIsATie() {
    double[] torn = {12, -8, 12, -8, 12, -8, 12, -8, 12, -8};

    assertEquals(List.of(SCALE.effect()), ties(tenOf(2.8)));
    assertEquals(List.of(), ties(tenOf(2)));
    assertEquals(List.of(SCALE.effect()), ties(torn));
  }

  @Test
  void anEffectOrItsTieIsAtWork() {
    double[] late = tenOf(3 * NOMINAL.slopes().linear().clumping());
    Odds odds = new Odds(List.of(set(NONE, tenOf(0)), set(WITH_LATE, late), set(WITH_SCALE, late)));
    double one = Math.exp((30 - 6) / 1.5);

    assertEquals(one / (1 + 2 * one), odds.ofAny(LATE.effect(), List.of()), EXACT);
    assertEquals(
        2 * one / (1 + 2 * one), odds.ofAny(LATE.effect(), List.of(SCALE.effect())), EXACT);
    assertEquals(Set.of(LATE.effect(), SCALE.effect()), odds.ofEffects().keySet());
  }

  @Test
  void aNextDriveTellsTwoSetsApart() {
    NextDrives next = new NextDrives(CommandUse.of(RUNS, 0));
    List<String> names = List.of("a", "b");
    assertEquals(Optional.empty(), next.between(NOMINAL, NOMINAL, names));
    for (MotionForm form : List.of(SCALE, TURN)) {
      ScoredMotion other = set(NONE.with(form, new double[] {1.2}));
      MotionDiagnosis.NextDrive drive = next.between(NOMINAL, other, names).orElseThrow();
      List<Command> commands = drive.commands();
      int last = commands.size() - 1;
      assertEquals(names, drive.separates());
      assertTrue(drive.expectedLogOdds() > 1);
      assertEquals(0, commands.get(0).timeS(), 0);
      assertTrue(commands.get(last).asksTheSameAs(Command.STAND));
      for (int i = 1; i <= last; i++) {
        assertTrue(commands.get(i).timeS() >= commands.get(i - 1).timeS() + 1.2 - EXACT);
      }
      assertTrue(commands.stream().allMatch(c -> Math.abs(c.speedMPerS()) <= 0.3));
      boolean turns = commands.stream().anyMatch(c -> c.turnRadPerS() != 0);
      assertTrue(form.equals(SCALE) || turns);
    }
  }

  private static List<MotionDiagnosis.Hidden> hidden(double speed, MotionForm... forms) {
    List<TrackPose> track = new ArrayList<>();
    for (int i = 0; i <= 300; i++) {
      track.add(new TrackPose(0.1 * i, 0.1 * i * speed, 0, 0));
    }
    MotionRun run = new MotionRun("a", List.of(new Command(0, speed, 0)), track);
    MotionSteps given = new MotionSteps(List.of(run));
    CommandUse use = CommandUse.of(List.of(run), 0);
    double[][] residuals = given.residuals(MotionChain.EXACT);
    Noise[] noises = {Noise.believed(1e-3), Noise.believed(1e-3), Noise.believed(1e-3)};
    ScoredMotion best = ScoredMotion.of(given, new MotionFit(NONE, residuals, noises, 0));
    return new MotionUndetectables(given, new Odds(List.of(best))).among(List.of(forms), use);
  }

  /** A robot that stands shows no scale at all, one that goes straight on none of its turns. */
  @Test
  void whatNoStepShowsIsHidden() {
    List<MotionDiagnosis.Hidden> standing = hidden(0, SCALE, TURN, SCALE);
    assertEquals(
        List.of(
            new MotionDiagnosis.Hidden("speed-scale", "speed_factor", Double.POSITIVE_INFINITY),
            new MotionDiagnosis.Hidden("turn-scale", "turn_factor", Double.POSITIVE_INFINITY)),
        standing);
    assertEquals(List.of("turn-scale"), effects(hidden(0.2, SCALE, TURN)));
    // The slower it goes, the less a scale shows: in proportion.
    double slow = hidden(0.0002, SCALE).get(0).leastSize();
    double slower = hidden(0.0001, SCALE).get(0).leastSize();
    assertEquals(2, slower / slow, 1e-3);
  }

  private static List<String> effects(List<MotionDiagnosis.Hidden> hidden) {
    return hidden.stream().map(MotionDiagnosis.Hidden::effect).toList();
  }

  private static Events events(Consumer<Drives> world) {
    List<MotionRun> runs = runs(world);
    MotionSteps given = new MotionSteps(runs);
    return Events.of(given, new MotionFitter(given, CommandUse.of(runs, 0)).asItIs(NONE));
  }

  /** Ten slips in a minute, two and a half minutes long; now and then it stands. */
  @Test
  void slipsAreEventsThatMakeTheWayShorter() {
    Events slips = events(drives -> drives.slips = 10);
    assertTrue(slips.shorter() >= 8 && slips.shorter() <= 25, slips::toString);
    assertEquals(slips.shorter(), slips.slips().size());
    assertTrue(slips.other() + slips.late() <= 3, slips::toString);
    assertTrue(slips.heavy() > 2);
    for (MotionSteps.Stretch slip : slips.slips()) {
      double seconds = slip.toS() - slip.fromS();
      // A step at least, and what follows within 1.2 s.
      assertTrue(seconds >= 1.4 - EXACT && seconds < 6, () -> seconds + " s");
    }
    Events exact = events(drives -> {});
    assertEquals(0, exact.shorter() + exact.late() + exact.other());
    assertTrue(exact.heavy() > 0.6 && exact.heavy() < 1.6, exact::toString);
  }

  /** What is unsteady by up to 0.3 s is off just as a command has changed. */
  @Test
  void unsteadyMomentsAreLate() {
    Events late = events(drives -> drives.unsteadyS = 0.3);

    assertTrue(late.late() > 5 && late.late() > 3 * late.other(), late::toString);
    assertEquals(late.shorter(), late.slips().size());
  }

  /** A gap that shrinks from 1 to 0.4 shrinks by 0.6. */
  @Test
  void aGapShrinksByWhatIsGone() {
    double[][] none = new double[3][3];
    MotionDiagnosis.Gap gap =
        new MotionDiagnosis.Gap(
            7, none, none, none, 0.4, new Interval(0.3, 0.5), new Interval(0.1, 0.8), 0.2);
    assertEquals(0.6, gap.shrink(), EXACT);
    assertEquals(new Interval(0.5, 0.7), gap.shrinkHere95());
    assertEquals(0.2, gap.shrinkCi95().low(), EXACT);
    assertEquals(0.9, gap.shrinkCi95().high(), EXACT);
    // Of 0.4 a half is scatter's. Nothing is surer than one in a thousand.
    MotionConclusion nothing =
        new MotionConclusion(
            List.of(), List.of(), List.of(), new MotionUnknown(List.of(), 0), true, 0.4, 0.2);
    MotionSigns signs = MotionSigns.of(nothing, gap, Map.of());
    assertEquals(new MotionSigns(false, Math.log(0.001 / 0.999), 0.5, Map.of()), signs);
  }

  /** The right chain beside a nominal one whose commands act 0.3 s too early. */
  @Test
  void aGapIsWhatIsLeftOfTheNominalOne() {
    List<MotionRun> runs = runs(drives -> drives.lateS = 0.3);
    MotionChain right = WITH_LATE.chain();
    List<MotionChain> folds = Collections.nCopies(MotionSteps.FOLDS, right);
    MotionGap gap = MotionGap.of(runs, MotionGap.forecast(RUNS, MotionChain.EXACT), folds);
    assertTrue(gap.ratio() > 0 && gap.ratio() < 0.6, () -> "ratio " + gap.ratio());
    assertTrue(gap.fitted(right) < 0.7 * gap.fitted(MotionChain.EXACT));
    assertEquals(gap.windows(), gap.shortest().size());
    Interval here = gap.ci95();
    assertEquals(gap.ratio(), (here.low() + here.high()) / 2, EXACT);
    assertTrue(here.high() > here.low());
    Interval other = gap.onAnotherDrive95(0.3);
    assertEquals(gap.ratio() * gap.ratio(), other.low() * other.high(), EXACT);
    double relative = (here.high() - gap.ratio()) / gap.ratio();
    assertEquals(Math.hypot(0.3, relative), Math.log(other.high() / gap.ratio()), EXACT);
    double mean = 0;
    for (int h = 0; h < 3; h++) {
      for (int c = 0; c < 3; c++) {
        mean += gap.after()[h][c] / gap.before()[h][c] / 9;
        assertTrue(gap.coverage()[h][c] > 0.6 && gap.coverage()[h][c] <= 1 + EXACT);
      }
    }
    assertEquals(mean, gap.ratio(), EXACT);
    Noise[] small = {Noise.believed(1e-4), Noise.believed(1e-4), Noise.believed(1e-4)};
    Noise[] twice = {Noise.believed(2e-4), Noise.believed(2e-4), Noise.believed(2e-4)};
    assertEquals(2, gap.floor(twice) / gap.floor(small), 1e-6);
  }
}
