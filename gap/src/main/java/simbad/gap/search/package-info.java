/**
 * Searches the sets of effects: which are possible, which of them predict rows that they were not
 * fitted on, which one is concluded upon, and what of it is sure.
 */
@NullMarked
package simbad.gap.search;

import org.jspecify.annotations.NullMarked;
