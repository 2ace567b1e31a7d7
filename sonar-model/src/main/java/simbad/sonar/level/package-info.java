/**
 * The level law: how strong the echo of a target is, in decibels over the receiver's threshold.
 *
 * <p>Plain values: air, beam, curves, target strength by bearing, and the law that puts them
 * together (docs/method/level-model.md). What a sensor reads by it is the business of {@code
 * simbad.sonar.model}; this package knows no scenes, no sensors and no files.
 */
@NullMarked
package simbad.sonar.level;

import org.jspecify.annotations.NullMarked;
