@NullMarked
package simbad.experiments.site;

import org.jspecify.annotations.NullMarked;
