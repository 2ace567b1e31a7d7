package simbad.gap.motion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import simbad.motion.Displacement;
import simbad.motion.DrivenSteps;
import simbad.motion.MotionChain;
import simbad.motion.MotionRun;
import simbad.motion.TrackPose;
import simbad.motion.Way;
import simbad.motion.forecast.Exertion;

/**
 * A log as steps from one tracked pose to a later one, each beginning where the one before ends.
 * Nothing is interpolated. What hangs together within some seconds must not stand on both sides of
 * a check: steps belong to blocks that are left out together.
 */
final class MotionSteps {
  static final int FOLDS = 5;
  static final int COMPONENTS = 3;

  /** Long against every lag and slip that is looked for. */
  private static final double BLOCK_S = 10;

  /** Long enough that a log has not more steps than it needs, short against a lag. */
  private static final double STEP_S = 0.2;

  /** Over a longer hole nothing hangs together. */
  private static final double HOLE_S = 3;

  /** By so much the moment at which a command acts may vary. */
  private static final double UNSTEADY_S = 0.15;

  /** A sample of a long log has some more. */
  private static final int SAMPLED_BLOCKS = 20;

  /** What was commanded longer ago hardly acts. */
  private static final double SETTLING_S = 4;

  /** Even a robot that stands is not known to stand still. */
  private static final double STANDING = 0.05;

  private final List<MotionRun> runs;
  private final List<Stretch> left;
  private final List<Step> steps = new ArrayList<>();

  /** The first step of each run, and its steps as a model drives them. */
  private final int[] firsts;

  private final List<DrivenSteps> driven;
  private final double[] loads;
  private final double[] durationsS;
  private final boolean[] chained;
  private final int[] blocks;
  private final int[] folds;

  /** What was seen, by component and step. */
  private final double[][] seen;

  /**
   * A step.
   *
   * @param run index of the run
   * @param from pose at its start
   * @param to pose at its end
   * @param chained whether it begins where the one before ends
   * @param load how much is asked of the robot, over the mean of all steps
   */
  record Step(int run, TrackPose from, TrackPose to, boolean chained, double load) {
    double durationS() {
      return to.timeS() - from.timeS();
    }
  }

  /**
   * A stretch of a run.
   *
   * @param run index of the run
   * @param fromS its start
   * @param toS its end
   */
  record Stretch(int run, double fromS, double toS) {
    boolean meets(int other, double startS, double endS) {
      return run == other && endS > fromS && startS < toS;
    }
  }

  MotionSteps(List<MotionRun> runs) {
    this(runs, List.of());
  }

  private MotionSteps(List<MotionRun> runs, List<Stretch> left) {
    this.runs = runs;
    this.left = left;
    firsts = new int[runs.size()];
    for (int run = 0; run < runs.size(); run++) {
      firsts[run] = steps.size();
      cut(run);
    }
    weigh();
    driven = IntStream.range(0, runs.size()).mapToObj(this::driven).toList();
    loads = steps.stream().mapToDouble(Step::load).toArray();
    durationsS = steps.stream().mapToDouble(Step::durationS).toArray();
    chained = new boolean[steps.size()];
    seen = new double[COMPONENTS][steps.size()];
    for (int i = 0; i < steps.size(); i++) {
      chained[i] = steps.get(i).chained;
      Displacement own = Displacement.between(steps.get(i).from, steps.get(i).to);
      for (int c = 0; c < COMPONENTS; c++) {
        seen[c][i] = own.component(c);
      }
    }
    blocks = new int[steps.size()];
    int block = -1;
    long key = Long.MIN_VALUE;
    for (int i = 0; i < blocks.length; i++) {
      Step step = steps.get(i);
      long here = (long) Math.floor(step.from.timeS() / BLOCK_S) * runs.size() + step.run;
      if (here != key) {
        block++;
        key = here;
      }
      blocks[i] = block;
    }
    folds = new int[block + 1];
    for (int i = 0; i < blocks.length; i++) {
      folds[blocks[i]] = fold(steps.get(i).run, steps.get(i).from.timeS());
    }
  }

  private void cut(int run) {
    List<TrackPose> track = runs.get(run).track();
    double firstS = runs.get(run).commands().get(0).timeS();
    boolean chained = false;
    int from = 0;
    for (int to = 1; to < track.size(); to++) {
      double held = track.get(to).timeS() - track.get(from).timeS();
      if (held >= STEP_S - 1e-6) {
        boolean known =
            held <= HOLE_S
                && track.get(from).timeS() >= firstS
                && !isLeftOut(run, track.get(from).timeS(), track.get(to).timeS());
        if (known) {
          steps.add(new Step(run, track.get(from), track.get(to), chained, 1));
        }
        chained = known;
        from = to;
      }
    }
  }

  private DrivenSteps driven(int run) {
    int end = run + 1 < firsts.length ? firsts[run + 1] : steps.size();
    List<Step> own = steps.subList(firsts[run], end);
    return new DrivenSteps(
        runs.get(run),
        own.stream().mapToDouble(step -> step.from.timeS()).toArray(),
        own.stream().mapToDouble(step -> step.to.timeS()).toArray());
  }

  private boolean isLeftOut(int run, double fromS, double toS) {
    return left.stream().anyMatch(stretch -> stretch.meets(run, fromS, toS));
  }

  /** Returns the same log without the steps that meet some stretches. */
  MotionSteps without(List<Stretch> stretches) {
    return new MotionSteps(runs, List.copyOf(stretches));
  }

  /**
   * Returns the same steps of a robot that is told something else, from the same time on.
   *
   * @param others the runs with other commands
   */
  MotionSteps told(List<MotionRun> others) {
    return new MotionSteps(others, left);
  }

  /**
   * Returns a part of a long log, some blocks of it with the commands shortly before: what is tried
   * on it costs a part too. A log that is not long is returned as it is.
   */
  MotionSteps sample() {
    int every = blockCount() / SAMPLED_BLOCKS;
    if (every < 2) {
      return this;
    }
    List<MotionRun> parts = new ArrayList<>();
    for (int i = 0; i < size(); ) {
      int end = i + 1;
      while (end < size() && chained[end] && blocks[end] == blocks[i]) {
        end++;
      }
      if (blocks[i] % every == 0) {
        parts.add(part(steps.subList(i, end)));
      }
      i = end;
    }
    return new MotionSteps(parts);
  }

  /** Chained steps as a run of their own. */
  private MotionRun part(List<Step> of) {
    List<TrackPose> track = new ArrayList<>();
    track.add(of.get(0).from);
    of.forEach(step -> track.add(step.to));
    MotionRun run = runs.get(of.get(0).run);
    return new MotionRun(
        run.name(),
        CommandTrail.between(
            run.commands(), track.get(0).timeS() - SETTLING_S, track.get(of.size()).timeS()),
        track);
  }

  private void weigh() {
    List<Exertion> exertions = runs.stream().map(Exertion::of).toList();
    double[] asked =
        steps.stream()
            .mapToDouble(s -> exertions.get(s.run).between(s.from.timeS(), s.to.timeS()))
            .toArray();
    double mean = Arrays.stream(asked).average().orElse(1);
    for (int i = 0; i < asked.length; i++) {
      Step step = steps.get(i);
      double load = mean > 0 ? STANDING + asked[i] / mean : 1;
      steps.set(i, new Step(step.run, step.from, step.to, step.chained, load));
    }
  }

  List<MotionRun> runs() {
    return runs;
  }

  /** Returns how much is asked of the robot in each step, over the mean. */
  double[] loads() {
    return loads;
  }

  /**
   * Returns how much a component's command changes as each step goes on, squared, over the mean:
   * what comes at unsteady moments scatters in proportion to it.
   *
   * @param component 0 for the speed, 2 for the turn
   * @param delayS after which commands act
   */
  double[] changes(int component, double delayS) {
    double[] changes = new double[steps.size()];
    for (int i = 0; i < changes.length; i++) {
      Step step = steps.get(i);
      double fromS = step.from.timeS() - delayS - UNSTEADY_S;
      double toS = step.to.timeS() - delayS + UNSTEADY_S;
      changes[i] = CommandTrail.changed(runs.get(step.run).commands(), component != 0, fromS, toS);
    }
    double mean = Arrays.stream(changes).average().orElse(0);
    return Arrays.stream(changes).map(change -> mean > 0 ? change / mean : 0).toArray();
  }

  int size() {
    return steps.size();
  }

  Step step(int index) {
    return steps.get(index);
  }

  boolean isChained(int step) {
    return chained[step];
  }

  double durationS(int step) {
    return durationsS[step];
  }

  int blockCount() {
    return folds.length;
  }

  int block(int step) {
    return blocks[step];
  }

  /** Returns the ways that a model expects, by run. */
  static List<Way> ways(List<MotionRun> runs, MotionChain chain) {
    return runs.stream().map(run -> Way.of(run, chain)).toList();
  }

  /** Returns what was seen less what a model expects: by component (along, across, turn), step. */
  double[][] residuals(MotionChain chain) {
    double[][] residuals = new double[COMPONENTS][steps.size()];
    for (int run = 0; run < driven.size(); run++) {
      int first = firsts[run];
      driven
          .get(run)
          .drive(
              chain,
              (step, expected) -> {
                int i = first + step;
                residuals[0][i] = seen[0][i] - expected.alongM();
                residuals[1][i] = seen[1][i] - expected.acrossM();
                residuals[2][i] = wrapped(seen[2][i] - expected.turnRad());
              });
    }
    return residuals;
  }

  /** Returns what a model expects by component and step. */
  double[][] expected(MotionChain chain) {
    double[][] expected = residuals(chain);
    for (int i = 0; i < steps.size(); i++) {
      for (int c = 0; c < COMPONENTS; c++) {
        double own = seen[c][i] - expected[c][i];
        expected[c][i] = c == 2 ? wrapped(own) : own;
      }
    }
    return expected;
  }

  static double wrapped(double rad) {
    return Math.abs(rad) <= Math.PI ? rad : Math.IEEEremainder(rad, 2 * Math.PI);
  }

  /** Returns the fold that leaves a block out. */
  int foldOf(int block) {
    return folds[block];
  }

  /** Returns the fold that leaves a time of a run out. */
  static int fold(int run, double timeS) {
    return Math.floorMod((long) Math.floor(timeS / BLOCK_S) + run, FOLDS);
  }
}
