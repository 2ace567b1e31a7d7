package simbad.blindworld.generate;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import simbad.blindworld.file.Csv;
import simbad.blindworld.file.FormatException;
import simbad.blindworld.file.JsonObject;
import simbad.blindworld.file.Seal;
import simbad.blindworld.world.Chance;

/**
 * Data sets of others with their truths beside them: folders with scene.json, readings.csv, perhaps
 * reference.csv, and truth.json and sealed.csv.
 *
 * @param folders in the order of their names, at least one
 */
public record ForeignSets(List<Path> folders) {

  /** What is said of the independence of sets whose makers say nothing. */
  public static final String LEVEL_UNKNOWN = "level not stated";

  private static final List<String> NEEDED =
      List.of("scene.json", "readings.csv", "truth.json", "sealed.csv");
  private static final List<String> OPEN = List.of("scene.json", "readings.csv", "reference.csv");
  private static final String RANGE = "range_m";

  /** Copies the list. */
  public ForeignSets {
    folders = List.copyOf(folders);
  }

  /** The data sets below a folder; each folder in it must be one. */
  public static ForeignSets in(Path root) throws IOException, FormatException {
    if (!Files.isDirectory(root)) {
      throw new FormatException(root + ": no such folder");
    }
    List<Path> folders;
    try (var paths = Files.list(root)) {
      folders = paths.filter(Files::isDirectory).sorted().toList();
    }
    if (folders.isEmpty()) {
      throw new FormatException(root + ": no data set in it");
    }
    for (Path one : folders) {
      for (String name : NEEDED) {
        if (!Files.isRegularFile(one.resolve(name))) {
          throw new FormatException(one.resolve(name) + ": there is no such file");
        }
      }
      JsonObject.read(one.resolve("truth.json")).object("effects");
    }
    return new ForeignSets(folders);
  }

  /**
   * Writes the tree that {@link Generator} writes: what may be seen, what is sealed, the poses to
   * predict, and last the manifest with the commitments.
   *
   * @param directory where to; empty or absent
   * @param level of independence, as their maker states it
   * @param seed of the salts
   */
  public void seal(Path directory, String level, long seed) throws IOException, FormatException {
    Generator.requireEmpty(directory);
    Chance random = new Chance(seed);
    List<Map<String, Object>> entries = new ArrayList<>();
    for (Path one : folders) {
      entries.add(seal(one, directory, CaseFiles.salt(random.nextLong())));
    }
    Map<String, Object> manifest = Generator.manifest(entries);
    manifest.put("level", level);
    Generator.write(directory, manifest);
  }

  private static Map<String, Object> seal(Path one, Path directory, byte[] salt)
      throws IOException, FormatException {
    String id = one.getFileName().toString();
    Map<String, Object> entry = new LinkedHashMap<>();
    entry.put("case", id);
    entry.put("files", copy(one, OPEN, directory.resolve("cases").resolve(id)));
    Path sealed = directory.resolve("truth").resolve(id);
    List<String> names = new ArrayList<>(OPEN);
    names.addAll(List.of("sealed.csv", "oracle.csv"));
    // The scene says what a no-echo counts, the reference of which level the case is.
    entry.put("sealed", copy(one, names, sealed));
    copy(one, List.of("truth.json"), sealed);
    CaseFiles.put(sealed, "salt.txt", Seal.hex(salt) + "\n");
    Path rows = Files.createDirectories(directory.resolve("rows").resolve(id));
    entry.put("rows_sha256", CaseFiles.put(rows, "rows.csv", poses(one.resolve("sealed.csv"))));
    byte[] truth = Files.readAllBytes(one.resolve("truth.json"));
    entry.put("commitment", Seal.commitment(salt, truth));
    return entry;
  }

  /** Copies those of the files that are there and returns their hashes. */
  private static Map<String, Object> copy(Path from, List<String> names, Path to)
      throws IOException {
    Files.createDirectories(to);
    Map<String, Object> hashes = new LinkedHashMap<>();
    for (String name : names) {
      if (Files.isRegularFile(from.resolve(name))) {
        String text = Files.readString(from.resolve(name), StandardCharsets.UTF_8);
        hashes.put(name, CaseFiles.put(to, name, text));
      }
    }
    return hashes;
  }

  /** The sealed rows without what was read on them. */
  private static String poses(Path sealed) throws IOException, FormatException {
    Csv csv = Csv.read(sealed);
    int range = csv.column(RANGE);
    List<Integer> kept =
        IntStream.range(0, csv.header().size()).filter(i -> i != range).boxed().toList();
    StringBuilder text = new StringBuilder();
    line(text, kept.stream().map(csv.header()::get).toList());
    for (int row = 0; row < csv.size(); row++) {
      int at = row;
      line(text, kept.stream().map(column -> csv.text(at, column)).toList());
    }
    return text.toString();
  }

  private static void line(StringBuilder text, List<String> fields) {
    List<String> quoted =
        fields.stream()
            .map(
                f ->
                    f.contains(",") || f.contains("\"") ? "\"" + f.replace("\"", "\"\"") + "\"" : f)
            .toList();
    text.append(String.join(",", quoted)).append('\n');
  }
}
