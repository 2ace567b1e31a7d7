package simbad.obstacles;

import java.util.List;

/**
 * Adds obstacle types to the catalogue: a class with a public constructor without arguments that a
 * jar names in {@code META-INF/services/simbad.obstacles.ObstacleTypeProvider}.
 */
public interface ObstacleTypeProvider {
  /** Returns the types to add; names that are taken already are passed over. */
  List<ObstacleType> types();
}
