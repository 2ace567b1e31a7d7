package simbad.sonar.effect;

import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.ServiceLoader;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The definitions of all effects: those of this program, and those of the jars beside it. */
public final class Definitions {
  private Definitions() {}

  /** Loads once: a definition has no state, and all threads shall see the same ones. */
  private static final class Loaded {
    private static final List<Definition> ALL = load();

    private static List<Definition> load() {
      // Threads may have a class loader of their own that knows a jar, or one that knows nothing.
      Stream<Definition> own = of(Definitions.class.getClassLoader());
      Stream<Definition> others = of(Thread.currentThread().getContextClassLoader());
      Set<Effect> seen = new HashSet<>();
      return Stream.concat(own, others)
          .filter(definition -> seen.add(definition.effect()))
          .sorted((one, other) -> one.effect().compareTo(other.effect()))
          .toList();
    }

    private static Stream<Definition> of(ClassLoader loader) {
      return ServiceLoader.load(Definition.class, loader).stream()
          .map(ServiceLoader.Provider::get);
    }
  }

  /**
   * Returns all: the project's own ones in the order of the vocabulary, then those of jars by name.
   * Of two for one effect the first stands.
   *
   * @throws java.util.ServiceConfigurationError if a jar names a definition that it does not hold
   */
  public static List<Definition> all() {
    return Loaded.ALL;
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
