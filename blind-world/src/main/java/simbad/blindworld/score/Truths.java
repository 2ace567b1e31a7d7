package simbad.blindworld.score;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import simbad.blindworld.file.Csv;
import simbad.blindworld.file.FormatException;
import simbad.blindworld.file.JsonObject;
import simbad.blindworld.file.Seal;

/**
 * Reads sealed truths: this program's own tree, or folders of foreign data sets with truth.json and
 * sealed.csv in them.
 */
public final class Truths {

  private final Path folder;
  private final Set<String> withheld;
  private final Set<String> known;

  /** Truths below a folder; withheld names count as outside the vocabulary. */
  public Truths(Path folder, Set<String> withheld) {
    this(folder, withheld, Set.of());
  }

  /** Truths below a folder, for a diagnosis that knows further names than the vocabulary's. */
  public Truths(Path folder, Set<String> withheld, Set<String> known) {
    this.folder = folder;
    this.withheld = Set.copyOf(withheld);
    this.known = Set.copyOf(known);
  }

  /** Whether the diagnosis has a name and may use it. */
  private boolean isNamed(String effect) {
    return (Names.contains(effect) || known.contains(effect)) && !withheld.contains(effect);
  }

  /** All truths, in the order of their names. */
  public List<Truth> read() throws IOException, FormatException {
    List<Truth> truths = new ArrayList<>();
    for (Path one : folders()) {
      truths.add(read(one));
    }
    if (truths.isEmpty()) {
      throw new FormatException(folder + ": no folder with a truth.json in it");
    }
    return truths;
  }

  private List<Path> folders() throws IOException, FormatException {
    if (!Files.isDirectory(folder)) {
      throw new FormatException(folder + ": no such folder");
    }
    try (var paths = Files.list(folder)) {
      return paths.filter(p -> Files.isRegularFile(p.resolve("truth.json"))).sorted().toList();
    }
  }

  private Truth read(Path one) throws IOException, FormatException {
    JsonObject json = JsonObject.read(one.resolve("truth.json"));
    List<String> effects = List.copyOf(json.object("effects").fields().keySet());
    Set<String> strange = new HashSet<>();
    for (String effect : effects) {
      if (!isNamed(effect)) {
        strange.add(effect);
      }
    }
    String id = one.getFileName().toString();
    boolean reference =
        json.fields().getOrDefault("reference", false).equals(true)
            || Files.exists(one.resolve("reference.csv"));
    boolean motion = isMotion(json);
    return new Truth(
        id,
        effects,
        strange,
        reference,
        motion ? List.of() : counted(one, noEchoM(one, json)),
        motion ? json.optionalNumber("sealed_gap_nominal") : gapCm(json, "sealed_gap_nominal"),
        motion ? json.optionalNumber("sealed_gap_oracle") : gapCm(json, "sealed_gap_oracle"),
        accept(json, effects, strange),
        json.optionalNumber("z"),
        size(json, effects),
        motion ? Optional.of(MotionSealed.read(one, json)) : Optional.empty());
  }

  private static Optional<Double> size(JsonObject truth, List<String> effects)
      throws FormatException {
    List<Double> sizes = truth.has("sizes") ? truth.numbers("sizes") : List.of();
    return effects.size() == 1 && sizes.size() == 1 ? Optional.of(sizes.get(0)) : Optional.empty();
  }

  private static boolean isMotion(JsonObject truth) throws FormatException {
    return truth.has("worlds") && truth.text("worlds").equals("motion");
  }

  /** A gap in centimetres, which some truths have in metres. */
  private static Optional<Double> gapCm(JsonObject truth, String name) throws FormatException {
    Optional<Double> centimetres = truth.optionalNumber(name + "_cm");
    return centimetres.isPresent()
        ? centimetres
        : truth.optionalNumber(name + "_m").map(m -> 100 * m);
  }

  /**
   * The sets of names that a truth accepts, or else its effects' own; none that holds what the
   * diagnosis has no name for.
   */
  private List<Set<String>> accept(JsonObject truth, List<String> effects, Set<String> strange)
      throws FormatException {
    if (!truth.has("accept")) {
      return strange.isEmpty() ? List.of(Set.copyOf(effects)) : List.of();
    }
    List<Set<String>> accept = new ArrayList<>();
    for (List<String> names : truth.textLists("accept")) {
      if (names.stream().allMatch(this::isNamed)) {
        accept.add(Set.copyOf(names));
      }
    }
    return accept;
  }

  /** From the truth itself, or from the scene that stands beside it in a foreign data set. */
  private static double noEchoM(Path one, JsonObject truth) throws IOException, FormatException {
    return truth.has("no_echo_m")
        ? truth.number("no_echo_m")
        : JsonObject.read(one.resolve("scene.json")).number("no_echo_m");
  }

  private static List<Double> counted(Path one, double noEchoM)
      throws IOException, FormatException {
    Csv csv = Csv.read(one.resolve("sealed.csv"));
    int range = csv.column("range_m");
    List<Double> counted = new ArrayList<>();
    for (int row = 0; row < csv.size(); row++) {
      counted.add(csv.text(row, range).isBlank() ? noEchoM : csv.number(row, range));
    }
    return counted;
  }

  /**
   * Checks every truth, sealed row and data set against the manifest that was written before.
   *
   * @return how many truths were checked
   */
  public int verify(Path manifestFile) throws IOException, FormatException {
    JsonObject manifest = JsonObject.read(manifestFile);
    Map<String, JsonObject> entries = new HashMap<>();
    List<String> leaves = new ArrayList<>();
    for (JsonObject entry : manifest.objects("cases")) {
      entries.put(entry.text("case"), entry);
      leaves.add(entry.text("commitment"));
    }
    same(manifestFile + ", root", manifest.text("root"), Seal.root(leaves));
    Path open = manifestFile.toAbsolutePath().resolveSibling("cases");
    for (Path one : folders()) {
      JsonObject entry = entries.remove(one.getFileName().toString());
      if (entry == null) {
        throw new FormatException(one + ": not in " + manifestFile);
      }
      verify(one, entry, open.resolve(one.getFileName().toString()));
    }
    if (!entries.isEmpty()) {
      throw new FormatException(folder + ": no truth for " + entries.keySet());
    }
    return leaves.size();
  }

  private static void verify(Path one, JsonObject entry, Path open)
      throws IOException, FormatException {
    byte[] truth = Files.readAllBytes(one.resolve("truth.json"));
    byte[] salt = Seal.bytes(Files.readString(one.resolve("salt.txt")));
    same(one + ", truth.json", entry.text("commitment"), Seal.commitment(salt, truth));
    JsonObject json =
        JsonObject.parse(one + "/truth.json", new String(truth, StandardCharsets.UTF_8));
    if (entry.has("sealed")) {
      // A foreign truth says nothing of the files beside it; the manifest does.
      verifyFiles(one, entry.object("sealed"));
    } else if (json.has("sealed_files")) {
      verifyFiles(one, json.object("sealed_files"));
    } else {
      same(one + ", sealed.csv", json.text("sealed_sha256"), hash(one.resolve("sealed.csv")));
      same(one + ", oracle.csv", json.text("oracle_sha256"), hash(one.resolve("oracle.csv")));
    }
    Path rowFolder = open.resolveSibling("../rows").resolve(open.getFileName());
    Path rows = rowFolder.resolve("rows.csv");
    if (entry.has("rows") && Files.isDirectory(rowFolder)) {
      verifyFiles(rowFolder, entry.object("rows"));
    }
    if (Files.exists(rows)) {
      same(rows + "", entry.text("rows_sha256"), hash(rows));
    }
    if (Files.isDirectory(open)) {
      verifyFiles(open, entry.object("files"));
    }
  }

  private static void verifyFiles(Path folder, JsonObject hashes)
      throws IOException, FormatException {
    for (String name : hashes.fields().keySet()) {
      same(folder + ", " + name, hashes.text(name), hash(folder.resolve(name)));
    }
  }

  private static String hash(Path file) throws IOException {
    return Seal.sha256(Files.readAllBytes(file));
  }

  private static void same(String what, String committed, String found) throws FormatException {
    if (!committed.equals(found)) {
      throw new FormatException(
          what + ": hash " + found + ", but " + committed + " was committed to");
    }
  }

  /** The true world's own answers: its names, and its forecasts where the tree holds them. */
  public Map<String, Answer> oracle(List<Truth> truths) throws IOException, FormatException {
    Map<String, Answer> answers = new HashMap<>();
    for (Truth truth : truths) {
      Path forecast = folder.resolve(truth.id()).resolve("oracle.csv");
      List<Answer.Named> named =
          truth.effects().stream()
              .filter(e -> !truth.strange().contains(e))
              .map(e -> new Answer.Named(e, 1, List.of()))
              .toList();
      answers.put(
          truth.id(),
          new Answer(
              truth.verdict(),
              named.stream().map(Answer.Named::name).toList(),
              named,
              truth.strange().isEmpty() ? 0 : 1,
              Optional.empty(),
              Optional.empty(),
              Files.exists(forecast) && truth.motion().isEmpty()
                  ? Optional.of(Answers.forecast(forecast, truth.countedM().size()))
                  : Optional.empty(),
              truth.motion().isPresent() ? truth.motion().get().gap(forecast) : Optional.empty()));
    }
    return answers;
  }
}
