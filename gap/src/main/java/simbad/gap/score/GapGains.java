package simbad.gap.score;

import java.util.HashMap;
import java.util.Map;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Hypothesis;

/**
 * What explanations of one log take away of its gap, each measured once. For one thread: several
 * work on each measure.
 */
public final class GapGains {
  private final CalibratedLog given;
  private final Blocks blocks;
  private final Map<Hypothesis, GapGain> known = new HashMap<>();

  /** Creates for a log. */
  public GapGains(CalibratedLog given) {
    this.given = given;
    blocks = new Blocks(given.log());
  }

  /** Returns the log. */
  public CalibratedLog given() {
    return given;
  }

  /** Returns the log's blocks. */
  public Blocks blocks() {
    return blocks;
  }

  /** Returns what an explanation takes away. */
  public GapGain of(Hypothesis explanation) {
    GapGain before = known.get(explanation);
    if (before != null) {
      return before;
    }
    GapGain gain = GapGain.of(given, blocks, explanation);
    known.put(explanation, gain);
    return gain;
  }
}
