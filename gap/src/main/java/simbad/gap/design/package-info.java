/**
 * What to measure next, and which effects a log could not have shown however strong they were.
 * Writes no files and draws nothing.
 */
@NullMarked
package simbad.gap.design;

import org.jspecify.annotations.NullMarked;
