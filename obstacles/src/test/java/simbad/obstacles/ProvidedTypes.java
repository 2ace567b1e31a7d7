package simbad.obstacles;

import java.util.List;

/** Adds a type to the catalogue, and one whose name is taken. */
public final class ProvidedTypes implements ObstacleTypeProvider {
  @Override
  public List<ObstacleType> types() {
    return List.of(
        new ObstacleType("provided", CrossSections.square(), Catalogue.angleTable()),
        new ObstacleType("round", CrossSections.square(), Catalogue.angleTable()));
  }
}
