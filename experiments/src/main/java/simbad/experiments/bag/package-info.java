/**
 * Recordings of ROS 2, MCAP or SQLite, as tables of ranges and poses. Knows the messages that it
 * needs and no more; what is made of the table is the business of {@code dataset}.
 */
@NullMarked
package simbad.experiments.bag;

import org.jspecify.annotations.NullMarked;
