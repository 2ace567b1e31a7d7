/**
 * The simulated board: gpsim runs the ranger's real program, its SRF04 and its serial port are
 * modules of firmware-pic18, and Java decides what each ping meets.
 *
 * <p>This package starts and drives a process; what a sensor reads is the sonar model's business,
 * and the program's lines are not looked at here.
 */
@NullMarked
package simbad.bench.board;

import org.jspecify.annotations.NullMarked;
