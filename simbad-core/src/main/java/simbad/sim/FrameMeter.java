package simbad.sim;

/** Measures how many steps are done per second of wall-clock time. The simulation never asks it. */
public class FrameMeter {
  /** The last measured steps per second; 0 before the first measurement. */
  public float fps;

  /** The mean steps per second since the reset; 0 before the first measurement. */
  public float fpsSinceStart;

  private int rate = 20;
  private int frames;
  private long sinceNs;
  private long totalFrames;
  private long startNs;

  /** Creates a meter that has measured nothing. */
  public FrameMeter() {}

  /** Forgets what was measured. */
  public void reset() {
    frames = 0;
    fps = 0;
    totalFrames = 0;
    fpsSinceStart = 0;
  }

  /** Returns over how many steps is measured. */
  public int getUpdateRate() {
    return rate;
  }

  /** Sets over how many steps to measure; at least 1. */
  public void setUpdateRate(int newRate) {
    if (newRate < 1) {
      throw new IllegalArgumentException("rate = " + newRate + " is not in [1, infinity)");
    }
    rate = newRate;
  }

  /** Counts some steps at once. */
  public void measurePoint(int steps) {
    for (int i = 0; i < steps; i++) {
      countFrame();
    }
  }

  /** Counts a step; looks at the clock once per measurement only. */
  void countFrame() {
    if (frames == 0) {
      sinceNs = System.nanoTime();
      startNs = totalFrames == 0 ? sinceNs : startNs;
    }
    frames++;
    totalFrames++;
    if (frames > rate) {
      long nowNs = System.nanoTime();
      fps = perSecond(rate, nowNs - sinceNs);
      fpsSinceStart = perSecond(totalFrames - 1, nowNs - startNs);
      frames = 0;
    }
  }

  private static float perSecond(long count, long elapsedNs) {
    return (float) (count * 1e9 / Math.max(1, elapsedNs));
  }
}
