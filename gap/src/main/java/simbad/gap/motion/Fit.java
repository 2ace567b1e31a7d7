package simbad.gap.motion;

/**
 * A hypothesis with its best values.
 *
 * @param hypothesis with the values
 * @param residuals by window and component
 * @param scatter of the residuals that were fitted
 * @param score sum of the fitted windows' log densities
 */
@SuppressWarnings("ArrayRecordComponent") // Numbers by window, never compared.
record Fit(Hypothesis hypothesis, double[][] residuals, Scatter scatter, double score) {}
