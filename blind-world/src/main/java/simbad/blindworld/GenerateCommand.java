package simbad.blindworld;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import simbad.blindworld.file.FormatException;
import simbad.blindworld.generate.Generator;
import simbad.blindworld.generate.Kind;
import simbad.blindworld.generate.Order;
import simbad.blindworld.generate.Plan;
import simbad.blindworld.generate.Worlds;

/** {@code generate --cases N --seed S --out DIR ...}, and what was drawn so once more. */
final class GenerateCommand {

  private static final List<String> OPTIONS =
      List.of(
          "--cases",
          "--seed",
          "--out",
          "--mix",
          "--reference",
          "--effects",
          "--withheld",
          "--rows",
          "--seconds",
          "--repeats",
          "--level",
          "--sizes",
          ReadAgain.AT,
          ReadAgain.WORLD,
          Finished.OPTION);
  private static final String WITHHELD_MIX =
      "none:0.2,single:0.2,pair:0.1,unknown:0.1,withheld:0.4";

  /** Here the names of the vocabulary are those of the program that diagnoses. */
  private static final String KNOWN = "; expected one that simbad effects lists";

  private GenerateCommand() {}

  static void run(String[] arguments, PrintStream err) throws FormatException, IOException {
    Options options = new Options(arguments, OPTIONS);
    Order order = order(options);
    if (ReadAgain.isAsked(options)) {
      ReadAgain.run(options, order, err);
      return;
    }
    Finished finished = new Finished(options, order.cases(), err);
    Generator.run(order, Path.of(options.required("--out")), finished);
  }

  private static Order order(Options options) throws FormatException {
    Worlds worlds = worlds(options);
    List<String> withheld = withheld(options.text("--withheld").orElse(""), worlds);
    Map<Kind, Double> mix =
        mix(options.text("--mix").orElse(withheld.isEmpty() ? worlds.mix() : WITHHELD_MIX));
    if (mix.getOrDefault(Kind.WITHHELD, 0.0) > 0 && withheld.isEmpty()) {
      throw new FormatException("--mix: withheld cases, expected --withheld with their effects");
    }
    List<String> effects = effects(options.text("--effects").orElse(""), worlds);
    if (!effects.isEmpty()) {
      checkChoice(effects, mix, worlds);
    }
    return new Order(
        (int) options.number("--cases", 40, 1, 100_000),
        options.whole("--seed", 1),
        mix,
        options.number("--reference", 0, 0, 1),
        effects,
        withheld,
        rows(options, worlds),
        (int) options.number("--repeats", worlds == Worlds.MOTION ? 200 : 400, 40, 100_000),
        worlds,
        sizes(options.text("--sizes")),
        Set.of());
  }

  /** Waves have no other levels, and always come with a reference. */
  private static Worlds worlds(Options options) throws FormatException {
    String level = options.text("--level").orElse("");
    if (level.isEmpty()) {
      return Worlds.EQUATIONS;
    }
    if (level.equals("motion")) {
      return Worlds.MOTION;
    }
    if (!level.equals("wave")) {
      throw new FormatException("--level: '" + level + "', expected wave or motion");
    }
    if (options.text("--reference").isPresent()) {
      throw new FormatException(
          "--reference: every case of --level wave comes with one, expected none of the two");
    }
    return Worlds.WAVE;
  }

  private static Optional<Order.Sizes> sizes(Optional<String> text) throws FormatException {
    if (text.isEmpty()) {
      return Optional.empty();
    }
    String[] ends = text.get().split("-", -1);
    double least = Options.inside("--sizes", ends[0], 0.01, 100);
    return Optional.of(
        new Order.Sizes(least, Options.inside("--sizes", ends[ends.length - 1], least, 100)));
  }

  private static Map<Kind, Double> mix(String text) throws FormatException {
    Map<Kind, Double> mix = new EnumMap<>(Kind.class);
    for (String part : text.split(",", -1)) {
      String[] words = part.split(":", -1);
      Kind kind =
          Arrays.stream(Kind.values())
              .filter(k -> k.name().toLowerCase(Locale.ROOT).equals(words[0]))
              .findFirst()
              .orElseThrow(
                  () ->
                      new FormatException(
                          "--mix: '"
                              + part
                              + "', expected none:, single:, pair:, triple:, unknown: or withheld:"));
      if (words.length != 2) {
        throw new FormatException("--mix: '" + part + "', expected kind:weight");
      }
      mix.put(kind, Options.inside("--mix", words[1], 0, 1e6));
    }
    if (mix.values().stream().allMatch(weight -> weight == 0)) {
      throw new FormatException("--mix: '" + text + "', expected a weight above 0");
    }
    return mix;
  }

  private static List<String> effects(String text, Worlds worlds) throws FormatException {
    List<String> names = text.isEmpty() ? List.of() : List.of(text.split(",", -1));
    Set<String> strange = worlds.unknownAmong(names);
    if (!strange.isEmpty()) {
      String given = String.join(", ", strange);
      if (strange.stream().allMatch(worlds::contains)) {
        throw new FormatException(
            "--effects: "
                + given
                + ": these worlds cannot have it; expected one of "
                + String.join(", ", worlds.all()));
      }
      throw new FormatException(
          "--effects: no such effect: "
              + given
              + KNOWN
              + " or "
              + String.join(", ", worlds.outside()));
    }
    return names;
  }

  /** Every kind of the mix needs names to choose from. */
  private static void checkChoice(List<String> effects, Map<Kind, Double> mix, Worlds worlds)
      throws FormatException {
    List<String> inside = effects.stream().filter(worlds::contains).toList();
    boolean pairs = mix.getOrDefault(Kind.PAIR, 0.0) + mix.getOrDefault(Kind.TRIPLE, 0.0) > 0;
    if (inside.isEmpty() && (pairs || mix.getOrDefault(Kind.SINGLE, 0.0) > 0)) {
      throw new FormatException(
          "--effects: none is of the vocabulary, expected one for --mix's single, pair and triple");
    }
    if (inside.size() == effects.size() && mix.getOrDefault(Kind.UNKNOWN, 0.0) > 0) {
      throw new FormatException(
          "--effects: all are of the vocabulary, expected one outside it for --mix's unknown");
    }
    for (String one : inside) {
      if (pairs && inside.stream().noneMatch(other -> worlds.isFairPair(one, other))) {
        throw new FormatException(
            "--effects: " + one + " makes a fair pair with none of them, which --mix's pair needs");
      }
    }
    if (mix.getOrDefault(Kind.TRIPLE, 0.0) > 0 && !Plan.hasTripleForEach(inside, worlds)) {
      throw new FormatException(
          "--effects: not every one of them is fair beside two others, which --mix's triple needs");
    }
  }

  private static List<String> withheld(String text, Worlds worlds) throws FormatException {
    List<String> names = text.isEmpty() ? List.of() : List.of(text.split(",", -1));
    for (String name : names) {
      if (!worlds.names().contains(name)) {
        throw new FormatException("--withheld: no such effect: " + name + KNOWN);
      }
    }
    return names;
  }

  /** Rows of readings, or seconds of driving. */
  private static Order.Rows rows(Options options, Worlds worlds) throws FormatException {
    boolean motion = worlds == Worlds.MOTION;
    String name = motion ? "--seconds" : "--rows";
    String other = motion ? "--rows" : "--seconds";
    if (options.text(other).isPresent()) {
      throw new FormatException(other + ": not of these worlds, expected " + name);
    }
    String usual =
        switch (worlds) {
          case EQUATIONS -> "2000-4500";
          case WAVE -> "700-2500";
          case MOTION -> "120-600";
        };
    String[] ends = options.text(name).orElse(usual).split("-", -1);
    int least = (int) Options.inside(name, ends[0], motion ? 60 : 100, 1e6);
    int most = (int) Options.inside(name, ends[ends.length - 1], least, motion ? 3600 : 1e6);
    return new Order.Rows(least, most);
  }
}
