package simbad.blindworld.generate;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import simbad.blindworld.check.Checks;
import simbad.blindworld.world.Chance;

/**
 * What to generate.
 *
 * @param cases how many cases
 * @param seed of all chance
 * @param mix the weight of each kind
 * @param referenceShare the share of cases whose set-up is off and that come with a reference
 * @param effects the names to choose from, of the vocabulary or outside it; all when empty
 * @param withheld names of the vocabulary that are put in by kind WITHHELD and by no other
 * @param rows least and most rows of a data set; of worlds of motion, seconds of driving
 * @param repeats how many simulated repeats make an oracle's forecast
 * @param worlds of which kind they are
 * @param sizes of what is put in; where they are asked for nothing has to show
 * @param plain kinds of case whose effects have to show even then
 */
public record Order(
    int cases,
    long seed,
    Map<Kind, Double> mix,
    double referenceShare,
    List<String> effects,
    List<String> withheld,
    Rows rows,
    int repeats,
    Worlds worlds,
    Optional<Sizes> sizes,
    Set<Kind> plain) {

  /** Least and most size of an effect, 1 for a practical one; drawn log-uniform between. */
  public record Sizes(double least, double most) {
    /** Refuses what is no such thing. */
    public Sizes {
      Checks.positive("least size", least);
      Checks.positive("greatest size", most);
    }

    /** One of them, log-uniform. */
    double draw(Chance random) {
      double log = StrictMath.log(least);
      return StrictMath.exp(log + (StrictMath.log(most) - log) * random.nextDouble());
    }
  }

  /** Least and most rows of a data set. */
  public record Rows(int least, int most) {}

  /** Copies the collections. */
  public Order {
    Checks.share("share of references", referenceShare);
    mix = Map.copyOf(mix);
    effects = List.copyOf(effects);
    withheld = List.copyOf(withheld);
    plain = Set.copyOf(plain);
  }

  /** Whether each effect of a case has to show in its readings. */
  boolean hasToShow(Kind kind) {
    return sizes.isEmpty() || plain.contains(kind);
  }

  /**
   * A size for an effect, 1 for a practical one.
   *
   * @param kind of the case
   * @param grown by how many powers of two sizes have grown where effects have to show
   */
  double size(Kind kind, double grown, Chance random) {
    double growth = hasToShow(kind) ? grown : 0;
    return sizes.isPresent()
        ? sizes.get().draw(random) * StrictMath.pow(2, growth)
        : StrictMath.pow(2, random.nextDouble(-1, 1) + growth);
  }
}
