/**
 * The one web server of the program: pages on this computer that only show. The web library stays
 * in here.
 *
 * <p>May not know: what is shown.
 */
@NullMarked
package simbad.studio.web;

import org.jspecify.annotations.NullMarked;
