/**
 * The diagnosis of joint logs: what a robot was told, where it then was, and what its sonars heard
 * at the poses that it believed. Each half is searched by its own room's code; what shows in both
 * is one cause with one value.
 */
@NullMarked
package simbad.gap.joint;

import org.jspecify.annotations.NullMarked;
