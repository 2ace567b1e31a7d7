package simbad.gap.motion;

/**
 * What a log says, slips left out or not.
 *
 * @param given steps that were explained
 * @param odds of sets of effects
 * @param gap before and after the most probable set
 * @param scatter beside it
 */
record Told(MotionSteps given, Odds odds, MotionGap gap, NoiseFindings scatter) {}
