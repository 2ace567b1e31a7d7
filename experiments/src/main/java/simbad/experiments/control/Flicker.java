package simbad.experiments.control;

/**
 * Tells a sensor that says now this, now that at one place from one that is certain.
 *
 * <p>A robot that has just crossed the edge must turn before it can cross it back. Where one side
 * after the other lasts but a step or two, the sensor may be uncertain, or the edge have a needle:
 * the robot stands still and asks. Only a sensor that contradicts itself at one place is uncertain.
 */
final class Flicker {
  private static final int SHORT_STEPS = 2;

  /** Single short sides count for nothing, since an edge has corners. */
  private static final int SUSPICIOUS = 4;

  private static final int QUESTIONS = 10;

  private boolean heardBefore;
  private int steps = Integer.MAX_VALUE / 2;
  private int score;
  private int questionsLeft;
  private boolean proven;

  /** Takes a reading; tells whether the robot shall stand still for another one. */
  boolean asks(boolean heard) {
    if (questionsLeft > 0) {
      proven = heard != heardBefore;
      questionsLeft = proven ? 0 : questionsLeft - 1;
    } else if (heard == heardBefore) {
      steps++;
    } else {
      cross(heard);
    }
    return questionsLeft > 0;
  }

  private void cross(boolean heard) {
    score = steps <= SHORT_STEPS ? score + 1 : Math.max(0, score - 1);
    heardBefore = heard;
    steps = 1;
    if (score >= SUSPICIOUS) {
      score = 0;
      questionsLeft = QUESTIONS;
    }
  }

  /** Tells whether the sensor contradicted itself while the robot stood still. */
  boolean isProven() {
    return proven;
  }
}
