package simbad.bench.board;

import simbad.sonar.shape.Outline;
import simbad.sonar.shape.ThresholdTable;

/**
 * A kind of obstacle as the bench knows it.
 *
 * @param outline cross-section in its own frame, metres
 * @param thresholds at which distances it is lost, in the same frame
 */
public record BenchTarget(Outline outline, ThresholdTable thresholds) {}
