package simbad.experiments.fidelity;

/**
 * One limit, and what a run reached of it.
 *
 * @param what the limit is of, in a few words
 * @param limit in words with its unit
 * @param reached in words with its unit
 * @param failing how a verdict names it when it was missed
 * @param isHeld whether the limit was reached
 */
public record LimitCheck(
    String what, String limit, String reached, String failing, boolean isHeld) {}
