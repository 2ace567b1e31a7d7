/**
 * How long sensing, stepping and whole runs take. Prints figures; none of them is a pass or a fail,
 * for they depend on the machine. The figures and how to get them: {@code docs/performance.md}.
 *
 * <p>May use every other room; nothing depends on it.
 */
@NullMarked
package simbad.benchmarks;

import org.jspecify.annotations.NullMarked;
