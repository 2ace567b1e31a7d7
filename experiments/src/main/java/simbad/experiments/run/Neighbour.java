package simbad.experiments.run;

import simbad.obstacles.ObstacleType;
import simbad.sonar.frame.Placement;

/**
 * An obstacle that stands near the one that is circled.
 *
 * @param type what it is
 * @param placement where it stands, in the frame of the obstacle that is circled
 */
public record Neighbour(ObstacleType type, Placement placement) {}
