package simbad.blindworld.generate;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.IntConsumer;
import java.util.stream.IntStream;
import simbad.blindworld.file.Json;
import simbad.blindworld.file.Seal;

/** Makes the cases of an order, on all cores; each case's chance is its own. */
public final class Generator {

  private Generator() {}

  /**
   * Writes {@code cases/}, {@code truth/} and, last, {@code manifest.json} with the commitments.
   *
   * @param order what to make
   * @param directory where to; it must be empty or absent
   * @param done told, from any thread, the number of each case that is finished
   */
  public static void run(Order order, Path directory, IntConsumer done) throws IOException {
    make(order, directory, order.cases(), new LinkedHashMap<>(), done);
  }

  /**
   * As {@link #run}, for some of the cases: those of the first names, which are a sample by lot.
   *
   * @param order what to make
   * @param directory where to; it must be empty or absent
   * @param first how many of the cases
   * @param more what the manifest says besides
   * @param done told, from any thread, the number of each case that is finished
   * @return the root over all commitments
   */
  public static String make(
      Order order, Path directory, int first, Map<String, Object> more, IntConsumer done)
      throws IOException {
    requireEmpty(directory);
    List<Plan.Assignment> whole = Plan.of(order);
    List<Plan.Assignment> plan = whole.subList(0, Math.min(first, whole.size()));
    CaseFiles files = new CaseFiles(directory);
    List<Map<String, Object>> entries =
        IntStream.range(0, plan.size())
            .parallel()
            .mapToObj(i -> make(plan.get(i), order, files, done, i))
            .toList();
    Map<String, Object> manifest = manifest(entries);
    if (order.worlds() != Worlds.EQUATIONS) {
      manifest.put("worlds", order.worlds().name().toLowerCase(Locale.ROOT));
    }
    manifest.putAll(more);
    write(directory, manifest);
    return String.valueOf(manifest.get("root"));
  }

  static void write(Path directory, Map<String, Object> manifest) throws IOException {
    CaseFiles.put(directory, "manifest.json", Json.write(manifest));
  }

  /** Makes the folder; refuses one with something in it. */
  static void requireEmpty(Path directory) throws IOException {
    if (Files.isDirectory(directory)) {
      try (var content = Files.list(directory)) {
        if (content.findAny().isPresent()) {
          throw new IOException(directory + ": not empty, expected a folder to be made");
        }
      }
    }
    Files.createDirectories(directory);
  }

  private static Map<String, Object> make(
      Plan.Assignment assignment, Order order, CaseFiles files, IntConsumer done, int number) {
    try {
      Map<String, Object> entry =
          switch (order.worlds()) {
            case EQUATIONS -> files.write(new Drawing(assignment, order).draw().content());
            case WAVE -> files.write(new WaveDrawing(assignment, order).draw().content());
            case MOTION -> files.write(new MotionDrawing(assignment, order).draw());
          };
      done.accept(number);
      return entry;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** The commitments and one root over them. */
  static Map<String, Object> manifest(List<Map<String, Object>> entries) {
    Map<String, Object> manifest = new LinkedHashMap<>();
    manifest.put("format", "blind-manifest/1");
    manifest.put("commitment", "SHA-256(salt || truth.json)");
    List<String> leaves = entries.stream().map(e -> String.valueOf(e.get("commitment"))).toList();
    manifest.put("root", Seal.root(leaves));
    manifest.put("cases", entries);
    return manifest;
  }
}
