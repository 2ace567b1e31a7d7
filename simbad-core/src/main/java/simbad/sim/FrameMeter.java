package simbad.sim;

/** Measures how many steps are done per second of wall-clock time. The simulation never asks it. */
public class FrameMeter {
  private int rate = 20;
  private int frames;
  private long sinceNs;
  private float framesPerSecond;

  FrameMeter() {}

  /** Forgets what was measured. */
  void reset() {
    frames = 0;
    framesPerSecond = 0;
  }

  /** Sets over how many steps to measure; at least 1. */
  void setRate(int newRate) {
    if (newRate < 1) {
      throw new IllegalArgumentException("rate = " + newRate + " is not in [1, infinity)");
    }
    rate = newRate;
  }

  /** Counts a step; looks at the clock once per measurement only. */
  void countFrame() {
    if (frames == 0) {
      sinceNs = System.nanoTime();
    }
    frames++;
    if (frames > rate) {
      framesPerSecond = (float) (rate * 1e9 / Math.max(1, System.nanoTime() - sinceNs));
      frames = 0;
    }
  }

  /** Returns the last measured steps per second; 0 before the first measurement. */
  float framesPerSecond() {
    return framesPerSecond;
  }
}
