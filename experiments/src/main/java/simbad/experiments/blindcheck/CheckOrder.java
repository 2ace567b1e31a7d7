package simbad.experiments.blindcheck;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import simbad.sonar.check.Checks;

/**
 * What a withheld check was asked for. Two checks of equal order have equal results.
 *
 * @param version of the program that diagnoses
 * @param source where the cases come from
 * @param withheld names of effects that the diagnosis is not told of
 */
public record CheckOrder(String version, Source source, List<String> withheld) {

  /** Where cases come from. */
  public sealed interface Source permits Drawn, Benchmark, Foreign {}

  /**
   * Cases that blind-world draws.
   *
   * @param cases how many
   * @param seed of all chance
   * @param referenceShare the share of cases whose set-up is itself a little off and that come with
   *     a reference
   * @param options what else blind-world is told, as its command line has it
   */
  public record Drawn(int cases, long seed, double referenceShare, List<String> options)
      implements Source {
    /** Checks the share and copies the list. */
    public Drawn {
      Checks.share("referenceShare", referenceShare);
      options = List.copyOf(options);
    }

    /** The options as the command of the check has them. */
    private List<String> shown() {
      List<String> shown = new ArrayList<>(options);
      int level = shown.indexOf("motion") - 1;
      if (level >= 0) {
        shown.subList(level, level + 2).clear();
        shown.add(level, "--motion");
      }
      return shown;
    }

    /** True for worlds of waves, all of which come with a reference. */
    public boolean isWave() {
      return options.contains("wave");
    }
  }

  /**
   * A part of the benchmark SRB-1.
   *
   * @param part L1, L2, L2w or motion
   * @param first how many of its cases, where not all
   * @param seed of the second half; absent for the first, which everybody may draw
   * @param practice seed of cases of the same kind that are none of the benchmark
   */
  public record Benchmark(
      String part, Optional<Integer> first, Optional<Long> seed, Optional<Integer> practice)
      implements Source {
    /** How blind-world's command line has it. */
    public List<String> options() {
      List<String> options = new ArrayList<>(List.of("--part", part));
      first.ifPresent(n -> options.addAll(List.of("--first", "" + n)));
      seed.ifPresent(s -> options.addAll(List.of("--seed", "" + s)));
      practice.ifPresent(s -> options.addAll(List.of("--practice", "" + s)));
      return options;
    }
  }

  /**
   * Data sets of others.
   *
   * @param folder as the user named it
   * @param level of independence, as the user states it
   */
  public record Foreign(String folder, Optional<String> level) implements Source {}

  /** Copies the list. */
  public CheckOrder {
    withheld = List.copyOf(withheld);
  }

  /** The order as a JSON object. */
  public ObjectNode json() {
    ObjectNode json = CheckJson.object();
    json.put("version", version);
    if (source instanceof Drawn drawn) {
      json.put("cases", drawn.cases());
      json.put("seed", drawn.seed());
      if (!drawn.isWave()) {
        json.put("reference_share", drawn.referenceShare());
      }
      drawn.options().forEach(json.putArray("options")::add);
    } else if (source instanceof Benchmark benchmark) {
      json.put("benchmark", benchmark.part());
      benchmark.first().ifPresent(n -> json.put("first", n));
      benchmark.seed().ifPresent(s -> json.put("seed", s));
      benchmark.practice().ifPresent(s -> json.put("practice", s));
    } else if (source instanceof Foreign foreign) {
      json.put("foreign", foreign.folder());
      foreign.level().ifPresent(level -> json.put("level", level));
    }
    withheld.forEach(json.putArray("withheld")::add);
    return json;
  }

  /** The command that repeats the check, less its folder. */
  public String command() {
    List<String> words = new ArrayList<>(List.of("./simbad blind-check"));
    if (source instanceof Drawn drawn) {
      words.add("--cases " + drawn.cases() + " --seed " + drawn.seed());
      if (!drawn.isWave()) {
        words.add("--reference " + drawn.referenceShare());
      }
      words.addAll(drawn.shown());
    } else if (source instanceof Benchmark benchmark) {
      words.add("--benchmark " + benchmark.part());
      benchmark.first().ifPresent(n -> words.add("--first " + n));
      benchmark.seed().ifPresent(s -> words.add("--seed " + s));
      benchmark.practice().ifPresent(s -> words.add("--practice " + s));
    } else if (source instanceof Foreign foreign) {
      words.add("--foreign " + foreign.folder());
      foreign.level().ifPresent(level -> words.add("--level '" + level + "'"));
    }
    if (!withheld.isEmpty()) {
      words.add("--withhold " + String.join(",", withheld));
    }
    return String.join(" ", words) + " --out DIR";
  }
}
