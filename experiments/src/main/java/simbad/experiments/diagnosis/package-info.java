/** The files of a diagnosis's folder, and predictions. The same diagnosis gives the same bytes. */
@NullMarked
package simbad.experiments.diagnosis;

import org.jspecify.annotations.NullMarked;
