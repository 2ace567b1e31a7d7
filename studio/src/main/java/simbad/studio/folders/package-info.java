/**
 * What runs, batches, captures and diagnoses have left in a folder, as JSON for the page. Reads
 * files, and computes from a diagnosis' model what its pages show; writes nothing.
 *
 * <p>May not know: the web server.
 */
@NullMarked
package simbad.studio.folders;

import org.jspecify.annotations.NullMarked;
