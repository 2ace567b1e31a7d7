/** How far diagnoses reach on logs of real robots, whose causes nobody knows. */
@NullMarked
package simbad.benchmarks.reach;

import org.jspecify.annotations.NullMarked;
