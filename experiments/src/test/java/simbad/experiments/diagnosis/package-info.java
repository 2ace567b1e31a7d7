/** Tests of a diagnosis's folder and page. */
@NullMarked
package simbad.experiments.diagnosis;

import org.jspecify.annotations.NullMarked;
