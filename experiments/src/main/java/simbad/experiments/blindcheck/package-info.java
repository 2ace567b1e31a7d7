/**
 * The results of a withheld check: its order, the scorer's figures as tables. What is counted how
 * is the scorer's business (blind-world, a program of its own); this package reads its JSON. The
 * same scores give the same bytes.
 */
@NullMarked
package simbad.experiments.blindcheck;

import org.jspecify.annotations.NullMarked;
