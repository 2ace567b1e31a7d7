package simbad.experiments.batch;

import java.io.Serializable;

/**
 * What came of a run.
 *
 * @param number of the run in its batch
 * @param failed whether the row tells an error
 * @param row of the results, a line of csv without line breaks inside
 * @param trace the text of its file; empty when none is kept
 */
public record BatchOutcome(long number, boolean failed, String row, String trace)
    implements Serializable {}
