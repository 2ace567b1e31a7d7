package simbad.gap.motion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import simbad.motion.Command;
import simbad.motion.MotionChain;
import simbad.motion.MotionRun;

/**
 * Commands that the robot may not have carried out, each lost or not: a mixture whose parts are the
 * expected steps with and without the command (expectation-maximization with independent commands;
 * Neal and Hinton 1998). A lag of the whole robot acts on every command alike; a link that loses
 * some acts on them fully or not at all.
 */
final class LostCommands {
  /** So long after the next command arrives nothing is left of one that did not. */
  private static final double SETTLES_S = 1.5;

  private static final int ROUNDS = 8;

  /** Rounds in which the scatter is searched afresh, as it was fitted with the losses in it. */
  private static final int AFRESH = 3;

  /** Commands whose loss shows by less than a standard error say nothing. */
  private static final double SHOWS = 1;

  /** Of fewer no share can be told. */
  private static final int FEWEST = 10;

  private static final double RAREST = 0.02;
  private static final double OFTENEST = 0.8;

  private final MotionSteps given;
  private final double[][] residuals;

  /** By which commands are left out, component and step: how the expected steps change. */
  private final double[][][] without = new double[2][][];

  private final List<Sent> sent = new ArrayList<>();
  private double rate = 0.2;
  private double before;
  private double after;

  /** A command, the steps in which its loss shows, and how probable it is that it was lost. */
  private static final class Sent {
    private final int parity;
    private final int from;
    private final int to;
    private double lost;

    Sent(int parity, int from, int to) {
      this.parity = parity;
      this.from = from;
      this.to = to;
    }
  }

  /**
   * Fits.
   *
   * @param given steps
   * @param runs with every command that was sent, also those that repeat the one before
   * @param chain by which commands act that are not lost
   */
  LostCommands(MotionSteps given, List<MotionRun> runs, MotionChain chain) {
    this.given = given;
    residuals = given.residuals(chain);
    double[][] expected = given.expected(chain);
    for (int parity = 0; parity < without.length; parity++) {
      without[parity] = given.told(losing(runs, parity)).expected(chain);
      for (int c = 0; c < expected.length; c++) {
        for (int i = 0; i < given.size(); i++) {
          without[parity][c][i] = MotionSteps.wrapped(without[parity][c][i] - expected[c][i]);
        }
      }
      find(runs, parity, chain.delayS());
    }
    fit();
  }

  /** The same runs without every second command: what was held goes on till the next one. */
  private static List<MotionRun> losing(List<MotionRun> runs, int parity) {
    List<MotionRun> losing = new ArrayList<>();
    for (MotionRun run : runs) {
      List<Command> kept = new ArrayList<>();
      for (int k = 0; k < run.commands().size(); k++) {
        if (k == 0 || k % 2 != parity) {
          kept.add(run.commands().get(k));
        }
      }
      losing.add(new MotionRun(run.name(), kept, run.track()).withoutRepeats());
    }
    return losing;
  }

  private void find(List<MotionRun> runs, int parity, double delayS) {
    int end = 0;
    for (int run = 0; run < runs.size(); run++) {
      int from = end;
      while (end < given.size() && given.step(end).run() == run) {
        end++;
      }
      List<Command> commands = runs.get(run).commands();
      for (int k = 2 - parity; k < commands.size(); k += 2) {
        double startS = commands.get(k).timeS() + delayS;
        double stopS =
            Math.min(actsS(commands, k + 1, delayS) + SETTLES_S, actsS(commands, k + 2, delayS));
        while (from < end && given.step(from).to().timeS() <= startS) {
          from++;
        }
        int to = from;
        while (to < end && given.step(to).from().timeS() < stopS) {
          to++;
        }
        if (to > from && !commands.get(k).asksTheSameAs(commands.get(k - 1))) {
          sent.add(new Sent(parity, from, to));
        }
      }
    }
  }

  private static double actsS(List<Command> commands, int index, double delayS) {
    return index < commands.size()
        ? commands.get(index).timeS() + delayS
        : Double.POSITIVE_INFINITY;
  }

  private void fit() {
    Noise[] noises = NoiseFit.afresh(given, residuals);
    before = Whitening.logDensity(given, noises, residuals);
    after = before;
    if (weigh(noises, residuals, false) < FEWEST) {
      return;
    }
    for (int round = 0; round < ROUNDS; round++) {
      double[][] left = left();
      noises = round < AFRESH ? NoiseFit.afresh(given, left) : NoiseFit.near(given, left, noises);
      after = Whitening.logDensity(given, noises, left);
      weigh(noises, left, true);
    }
  }

  /** What the chain leaves over, less what is lost, each as probable as it is. */
  private double[][] left() {
    double[][] left = Arrays.stream(residuals).map(double[]::clone).toArray(double[][]::new);
    for (Sent one : sent) {
      for (int c = 0; one.lost > 0 && c < left.length; c++) {
        for (int i = one.from; i < one.to; i++) {
          left[c][i] -= one.lost * without[one.parity][c][i];
        }
      }
    }
    return left;
  }

  /** Weighs each command anew, and the bound of the log density; returns how many say something. */
  private int weigh(Noise[] noises, double[][] left, boolean robust) {
    Whitening[] white = new Whitening[left.length];
    double[][][] columns = new double[without.length][left.length][];
    for (int c = 0; c < left.length; c++) {
      white[c] = new Whitening(given, noises[c], left[c]);
      for (int parity = 0; parity < without.length; parity++) {
        columns[parity][c] = white[c].of(without[parity][c]);
      }
    }
    double sum = 0;
    int shown = 0;
    for (Sent one : sent) {
      double pull = 0;
      double information = 0;
      for (int c = 0; c < left.length; c++) {
        double[] column = columns[one.parity][c];
        for (int i = one.from; i < one.to; i++) {
          double weight = robust ? white[c].weights[i] : 1;
          pull += weight * white[c].white[i] * column[i];
          information += weight * column[i] * column[i];
        }
      }
      after += robust ? bound(one.lost, information) : 0;
      double odds = Math.log(rate / (1 - rate)) + pull + (one.lost - 0.5) * information;
      double now = NormalChance.ofLogOdds(odds);
      one.lost = robust ? (now + one.lost) / 2 : now;
      if (information > SHOWS) {
        sum += one.lost;
        shown++;
      }
    }
    rate = Math.min(OFTENEST, Math.max(RAREST, (sum + 0.5) / (shown + 2)));
    return shown;
  }

  /** What one command adds to the bound: its variance, its prior and its entropy. */
  private double bound(double lost, double information) {
    return entropy(lost, rate) + entropy(1 - lost, 1 - rate) - lost * (1 - lost) * information / 2;
  }

  private static double entropy(double posterior, double prior) {
    return posterior > 0 ? posterior * (Math.log(prior) - Math.log(posterior)) : 0;
  }

  /** Returns a lower bound of the log density of all steps. */
  double logDensity() {
    return after;
  }

  /** Returns by how many nats the steps are likelier than if no command were lost. */
  double gain() {
    return after - before;
  }

  /** Returns what losses add to what was seen, by component and step. */
  double[][] part() {
    double[][] part = left();
    for (int c = 0; c < part.length; c++) {
      for (int i = 0; i < given.size(); i++) {
        part[c][i] = residuals[c][i] - part[c][i];
      }
    }
    return part;
  }
}
