/**
 * Jobs on Apache Spark. The one package that knows Spark; it knows nothing of what the jobs are.
 */
@NullMarked
package simbad.cluster;

import org.jspecify.annotations.NullMarked;
