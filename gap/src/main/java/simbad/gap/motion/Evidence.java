package simbad.gap.motion;

import java.util.ArrayList;
import java.util.List;
import simbad.motion.Displacement;
import simbad.motion.MotionChain;
import simbad.motion.MotionRun;
import simbad.motion.Way;

/**
 * Windows of one horizon, in blocks that are left out together: what hangs together within some
 * seconds must not stand on both sides of a check.
 */
final class Evidence {
  /** Long against every lag and slip that is looked for. */
  private static final double BLOCK_S = 10;

  static final int FOLDS = 5;

  private final List<MotionRun> runs;
  private final List<Window> windows;
  private final int[] blocks;
  private final int blockCount;

  Evidence(List<MotionRun> runs, double horizonS) {
    this.runs = runs;
    windows = Windows.of(runs, horizonS);
    blocks = new int[windows.size()];
    int block = -1;
    long key = Long.MIN_VALUE;
    for (int i = 0; i < blocks.length; i++) {
      Window window = windows.get(i);
      long here = (long) Math.floor(window.startS() / BLOCK_S) * runs.size() + window.run();
      if (here != key) {
        block++;
        key = here;
      }
      blocks[i] = block;
    }
    blockCount = block + 1;
  }

  List<MotionRun> runs() {
    return runs;
  }

  int size() {
    return blocks.length;
  }

  int blockCount() {
    return blockCount;
  }

  int block(int window) {
    return blocks[window];
  }

  int fold(int window) {
    return blocks[window] % FOLDS;
  }

  Window window(int index) {
    return windows.get(index);
  }

  /** Returns the ways that a model expects, by run. */
  static List<Way> ways(List<MotionRun> runs, MotionChain chain) {
    List<Way> ways = new ArrayList<>();
    for (MotionRun run : runs) {
      double from = run.commands().get(0).timeS();
      double to = from;
      if (!run.track().isEmpty()) {
        to = Math.max(from, run.track().get(run.track().size() - 1).timeS());
      }
      ways.add(Way.of(run, chain, from, to + 1));
    }
    return ways;
  }

  /** Returns what was seen less what a model expects: by window along, across, turn. */
  double[][] residuals(MotionChain chain) {
    return residuals(ways(runs, chain));
  }

  double[][] residuals(List<Way> ways) {
    double[][] residuals = new double[windows.size()][];
    for (int i = 0; i < residuals.length; i++) {
      Window window = windows.get(i);
      Displacement seen = window.way();
      Displacement expected = ways.get(window.run()).between(window.startS(), window.endS());
      residuals[i] =
          new double[] {
            seen.alongM() - expected.alongM(),
            seen.acrossM() - expected.acrossM(),
            Math.IEEEremainder(seen.turnRad() - expected.turnRad(), 2 * Math.PI)
          };
    }
    return residuals;
  }
}
