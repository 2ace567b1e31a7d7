package simbad.sim;

/** Measures how many steps are done per second of wall-clock time. The simulation never asks it. */
public class FrameMeter {
  private int rate = 20;
  private int frames;
  private long sinceNs;
  private float framesPerSecond;
  private long totalFrames;
  private long startNs;
  private float meanFramesPerSecond;

  FrameMeter() {}

  /** Forgets what was measured. */
  void reset() {
    frames = 0;
    framesPerSecond = 0;
    totalFrames = 0;
    meanFramesPerSecond = 0;
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
      startNs = totalFrames == 0 ? sinceNs : startNs;
    }
    frames++;
    totalFrames++;
    if (frames > rate) {
      long nowNs = System.nanoTime();
      framesPerSecond = perSecond(rate, nowNs - sinceNs);
      meanFramesPerSecond = perSecond(totalFrames - 1, nowNs - startNs);
      frames = 0;
    }
  }

  private static float perSecond(long count, long elapsedNs) {
    return (float) (count * 1e9 / Math.max(1, elapsedNs));
  }

  /** Returns the mean steps per second since the reset; 0 before the first measurement. */
  float meanFramesPerSecond() {
    return meanFramesPerSecond;
  }

  /** Returns the last measured steps per second; 0 before the first measurement. */
  float framesPerSecond() {
    return framesPerSecond;
  }
}
