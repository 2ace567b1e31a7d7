/**
 * Where the gap lies, which effects a log could not have shown, and what to measure next. Knows
 * logs, models and hypotheses; writes no files and draws nothing.
 */
@NullMarked
package simbad.gap.place;

import org.jspecify.annotations.NullMarked;
