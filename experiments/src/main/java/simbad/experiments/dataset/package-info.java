/**
 * Gap data sets made of other things: of a threshold table, and of logs that others wrote.
 *
 * <p>A log is read in steps that know little of each other: {@code LogText} its characters, {@code
 * LogLines} its fields, {@code LogTable} its columns; {@code LogGuess} completes what a person said
 * of it; {@code LogPlans} turns that into rules for rows, {@code LogRows} follows them. What a log
 * does not say is an assumption, and written as such.
 */
@NullMarked
package simbad.experiments.dataset;

import org.jspecify.annotations.NullMarked;
