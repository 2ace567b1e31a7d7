/** Tests of the command line, in this process except where a process is what is tested. */
@NullMarked
package simbad.cli;

import org.jspecify.annotations.NullMarked;
