/** Checks of arguments, which every public constructor and factory makes. Knows nothing else. */
@NullMarked
package simbad.sonar.check;

import org.jspecify.annotations.NullMarked;
