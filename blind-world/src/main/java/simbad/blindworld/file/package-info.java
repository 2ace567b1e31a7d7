/** The files: JSON, CSV and salted hashes. Knows nothing of worlds. */
@NullMarked
package simbad.blindworld.file;

import org.jspecify.annotations.NullMarked;
