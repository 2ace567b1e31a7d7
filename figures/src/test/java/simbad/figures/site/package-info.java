@NullMarked
package simbad.figures.site;

import org.jspecify.annotations.NullMarked;
