package simbad.gap.fit;

/**
 * A hypothesis with the values that fit best.
 *
 * @param hypothesis with its values
 * @param logLikelihood of the pings that counted, natural
 */
public record Fit(Hypothesis hypothesis, double logLikelihood) {}
