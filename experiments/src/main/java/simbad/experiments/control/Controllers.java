package simbad.experiments.control;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.ServiceLoader;
import java.util.stream.Collectors;

/** The kinds of controllers that this program and the jars beside it have. */
public final class Controllers {
  private Controllers() {}

  /** Returns all kinds by their names; those of one name in the order of the class path. */
  public static List<ControllerMaker> all() {
    return ServiceLoader.load(ControllerMaker.class).stream()
        .map(ServiceLoader.Provider::get)
        .sorted(Comparator.comparing(ControllerMaker::name))
        .toList();
  }

  /** Finds a kind by its name; of two with one name the first stands. */
  public static Optional<ControllerMaker> find(String name) {
    return all().stream().filter(maker -> maker.name().equals(name)).findFirst();
  }

  /** Returns the standard values of a kind's parameters by name. */
  public static Map<String, Double> standard(ControllerMaker maker) {
    return maker.parameters().stream()
        .collect(
            Collectors.toUnmodifiableMap(ControllerParameter::name, ControllerParameter::standard));
  }
}
