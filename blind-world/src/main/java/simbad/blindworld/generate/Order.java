package simbad.blindworld.generate;

import java.util.List;
import java.util.Map;

/**
 * What to generate.
 *
 * @param cases how many cases
 * @param seed of all chance
 * @param mix the weight of each kind
 * @param referenceShare the share of cases whose set-up is off and that come with a reference
 * @param effects the names to choose from, of the vocabulary or outside it; all when empty
 * @param withheld names of the vocabulary that are put in by kind WITHHELD and by no other
 * @param rows least and most rows of a data set
 * @param repeats how many simulated repeats make an oracle's forecast
 */
public record Order(
    int cases,
    long seed,
    Map<Kind, Double> mix,
    double referenceShare,
    List<String> effects,
    List<String> withheld,
    Rows rows,
    int repeats) {

  /** Least and most rows of a data set. */
  public record Rows(int least, int most) {}

  /** Copies the collections. */
  public Order {
    mix = Map.copyOf(mix);
    effects = List.copyOf(effects);
    withheld = List.copyOf(withheld);
  }
}
