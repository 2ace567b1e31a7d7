package simbad.obstacles;

import simbad.sonar.format.TableDocument;
import simbad.sonar.shape.Outline;

/**
 * A kind of obstacle: its cross-section and the distances at which a sonar loses it.
 *
 * @param name short, as on the command line
 * @param outline cross-section in its own frame, metres
 * @param thresholds table in the same frame, with its provenance
 */
public record ObstacleType(String name, Outline outline, TableDocument thresholds) {}
