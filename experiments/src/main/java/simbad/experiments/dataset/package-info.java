/**
 * Gap data sets made of other things: of a threshold table, and of two kinds of logs that others
 * published. What a log does not say is decided here and said in its converter's Javadoc and in
 * docs/guide/diagnose.md.
 */
@NullMarked
package simbad.experiments.dataset;

import org.jspecify.annotations.NullMarked;
