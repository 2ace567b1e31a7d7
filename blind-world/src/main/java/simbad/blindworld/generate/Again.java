package simbad.blindworld.generate;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.function.IntConsumer;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import simbad.blindworld.file.FormatException;
import simbad.blindworld.file.JsonObject;
import simbad.blindworld.file.Seal;
import simbad.blindworld.world.Chance;
import simbad.blindworld.world.Recording;

/**
 * Reads worlds that were drawn before once more, at poses that somebody asks for. No truth is
 * opened: each world is drawn again by its seed, and its readings must be those of the manifest.
 */
public final class Again {

  /** The file with the poses that somebody asks for, in a folder of the case's name. */
  public static final String ASKED = "next-experiment.csv";

  private static final String READINGS = "readings.csv";

  /** So that chance is another one than that of all that was drawn of the case. */
  private static final long OTHER_CHANCE = 0x0A6A_1D0E_5EED_2B1DL;

  private Again() {}

  /** Somebody's rows before a case's world. */
  private record Asked(Plan.Assignment assignment, AskedRows rows, String readingsHash) {}

  /**
   * Writes {@code ID/readings.csv} for every folder ID with poses: their rows with what is read
   * there. The same order and rows give the same bytes.
   *
   * @param order by which the worlds were drawn
   * @param world the folder they were drawn into
   * @param poses folders with the names of cases; those without {@link #ASKED} are passed over
   * @param target where to; it must be empty or absent
   * @param done told, from any thread, the number of each case that is finished
   * @throws FormatException for bad rows, for a name that the order does not have, when the order
   *     gives another world than the one that was sealed, and for worlds of motion
   */
  public static void run(Order order, Path world, Path poses, Path target, IntConsumer done)
      throws IOException, FormatException {
    if (order.worlds() == Worlds.MOTION) {
      throw new FormatException("--at: worlds of motion are not read again, expected sonars");
    }
    List<Asked> asked = asked(order, world, poses);
    Generator.requireEmpty(target);
    String others =
        IntStream.range(0, asked.size())
            .parallel()
            .filter(number -> !isRead(asked.get(number), number, order, target, done))
            .mapToObj(number -> asked.get(number).assignment().id())
            .collect(Collectors.joining(" "));
    if (!others.isEmpty()) {
      throw new FormatException(
          others
              + ": drawn again they have other readings than "
              + world
              + "; expected the options, the program and the kind of machine that it was drawn by");
    }
  }

  /** How many cases have poses in a folder. */
  public static int count(Path poses) throws IOException, FormatException {
    return folders(poses).size();
  }

  private static List<Asked> asked(Order order, Path world, Path poses)
      throws IOException, FormatException {
    Map<String, Plan.Assignment> plan =
        Plan.of(order).stream().collect(Collectors.toMap(Plan.Assignment::id, Function.identity()));
    Map<String, String> hashes = readingsHashes(world.resolve("manifest.json"));
    List<Asked> asked = new ArrayList<>();
    for (Path folder : folders(poses)) {
      String id = folder.getFileName().toString();
      Plan.Assignment assignment = plan.get(id);
      String hash = hashes.get(id);
      if (assignment == null || hash == null) {
        throw new FormatException(folder + ": expected the name of a case of " + world);
      }
      asked.add(new Asked(assignment, AskedRows.read(folder.resolve(ASKED)), hash));
    }
    return asked;
  }

  private static List<Path> folders(Path poses) throws IOException, FormatException {
    if (!Files.isDirectory(poses)) {
      throw new FormatException(poses + ": no such folder");
    }
    try (var folders = Files.list(poses)) {
      return folders.filter(one -> Files.isRegularFile(one.resolve(ASKED))).sorted().toList();
    }
  }

  private static Map<String, String> readingsHashes(Path manifest)
      throws IOException, FormatException {
    Map<String, String> hashes = new HashMap<>();
    for (JsonObject entry : JsonObject.read(manifest).objects("cases")) {
      JsonObject files = entry.object("files");
      if (files.has(READINGS)) {
        hashes.put(entry.text("case"), files.text(READINGS));
      }
    }
    return hashes;
  }

  /** False when the world is not the one that was sealed; nothing is written of it then. */
  private static boolean isRead(
      Asked asked, int number, Order order, Path target, IntConsumer done) {
    DrawnWorld drawn = draw(asked.assignment(), order);
    String before = CaseFiles.sheet(drawn.content().readings(), true);
    boolean same =
        Seal.sha256(before.getBytes(StandardCharsets.UTF_8)).equals(asked.readingsHash());
    if (same) {
      Recording rows = asked.rows().recording();
      long chance = new Chance(asked.assignment().seed() ^ OTHER_CHANCE).nextLong();
      String text = asked.rows().with(drawn.at(rows).read(chance));
      try {
        Path folder = Files.createDirectories(target.resolve(asked.assignment().id()));
        CaseFiles.put(folder, READINGS, text);
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }
    done.accept(number);
    return same;
  }

  private static DrawnWorld draw(Plan.Assignment assignment, Order order) {
    return switch (order.worlds()) {
      case EQUATIONS -> new Drawing(assignment, order).draw();
      case WAVE -> new WaveDrawing(assignment, order).draw();
      case MOTION -> throw new IllegalArgumentException("worlds: MOTION, expected sonars");
    };
  }
}
