package simbad.sonar.effect;

import java.util.Collections;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.ServiceLoader;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/** The definitions of all effects: those of this program, and those of the jars beside it. */
public final class Definitions {
  /** Loaded once: a definition has no state, and all threads shall see the same ones. */
  private static volatile List<Definition> all = List.of();

  private Definitions() {}

  private static synchronized List<Definition> loaded() {
    if (all.isEmpty()) {
      // A thread may have a class loader of its own that knows a jar, or one that knows nothing.
      Stream<Definition> own = of(Definitions.class.getClassLoader());
      Stream<Definition> others = of(Thread.currentThread().getContextClassLoader());
      Set<Effect> seen = new HashSet<>();
      all =
          Stream.concat(own, others)
              .filter(definition -> seen.add(definition.effect()))
              .sorted(Comparator.comparing(Definition::effect))
              .toList();
    }
    return all;
  }

  private static Stream<Definition> of(@Nullable ClassLoader loader) {
    return ServiceLoader.load(Definition.class, loader).stream().map(ServiceLoader.Provider::get);
  }

  /**
   * Returns all: the project's own ones in the order of the vocabulary, then those of jars by name.
   * Of two for one effect the first stands.
   *
   * @throws java.util.ServiceConfigurationError if a jar names a definition that it does not hold
   */
  public static List<Definition> all() {
    List<Definition> known = all;
    return known.isEmpty() ? loaded() : known;
  }

  /** Returns the effects that are defined, in the same order. */
  public static List<Effect> effects() {
    return all().stream().map(Definition::effect).toList();
  }

  /**
   * Returns the definition of an effect.
   *
   * @throws IllegalArgumentException for an effect that none defines
   */
  public static Definition of(Effect effect) {
    return find(effect)
        .orElseThrow(() -> new IllegalArgumentException("nothing defines the effect " + effect));
  }

  private static Optional<Definition> find(Effect effect) {
    return all().stream().filter(definition -> definition.effect() == effect).findFirst();
  }

  /** Returns the effects that have a trait, in the same order. */
  public static Set<Effect> with(Trait trait) {
    Set<Effect> effects =
        all().stream()
            .filter(definition -> definition.traits().contains(trait))
            .map(Definition::effect)
            .collect(Collectors.toCollection(TreeSet::new));
    return Collections.unmodifiableSet(effects);
  }
}
