/**
 * Batches: the product, or a sample of it, of obstacles, sensors, effects, controllers, speeds and
 * seeds; one row of results per run.
 *
 * <p>A batch is what its spec and the files that the spec names say, and nothing else: a run is
 * found by its number alone, wherever it is done. Who does the runs is the business of {@code
 * simbad.experiments.workers}.
 */
@NullMarked
package simbad.experiments.batch;

import org.jspecify.annotations.NullMarked;
