package simbad.studio.folders;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.JsonInput;

/**
 * What the page may ask of a folder: what is in it, and what each of these holds. Answers are JSON
 * texts. Safe for use by several threads, which wait for each other.
 */
public final class Folders {
  private static final Path NAME = Path.of("question");

  /** Forecasts of many rows take seconds: two that are compared, and those before. */
  private static final int KEPT = 4;

  /** Farther no trace is looked at. */
  private static final double MOST_M = 1e6;

  private final Path given;
  private final Shelf shelf;
  private final DataSets sets;
  private final CaptureStates captures = new CaptureStates();
  private final Traces traces = new Traces();
  private final Map<String, String> known = new LinkedHashMap<>(16, 0.75f, true);

  private Folders(Path given, Shelf shelf, DataSets sets) {
    this.given = given;
    this.shelf = shelf;
    this.sets = sets;
  }

  /**
   * Opens a folder.
   *
   * @param folder what is shown
   * @param data where data sets of diagnoses are looked for besides
   * @throws DataFormatException if one is no folder
   */
  public static Folders of(Path folder, List<Path> data) throws DataFormatException {
    Shelf shelf = Shelf.of(folder);
    List<Shelf> shelves = new ArrayList<>(List.of(shelf));
    for (Path other : data) {
      shelves.add(Shelf.of(other));
    }
    return new Folders(folder, shelf, new DataSets(shelves));
  }

  /**
   * Lists what there is, by name and kind, with what it is about in a few words.
   *
   * @throws DataFormatException if the folder cannot be read
   */
  public String list() throws DataFormatException {
    ObjectNode root = JsonText.MAPPER.createObjectNode();
    root.put("folder", String.valueOf(shelf.root().getFileName()));
    ArrayNode list = root.putArray("folders");
    try {
      List<Path> found = shelf.find(folder -> Kind.of(folder).isPresent());
      root.put("more", found.size() >= Shelf.MOST);
      for (Path folder : found) {
        Kind kind = Kind.of(folder).orElseThrow();
        ObjectNode node = list.addObject();
        node.put("path", shelf.name(folder)).put("kind", kind.word());
        node.put("about", about(folder, kind));
      }
    } catch (IOException e) {
      throw DataFormatException.inFile(shelf.root(), "cannot be read: " + e.getMessage());
    }
    return root.toString();
  }

  /**
   * Returns the diagnoses in here that left a model, as the command line can name them.
   *
   * @param model name of the model's file
   * @throws DataFormatException if the folder cannot be read
   */
  public List<Path> diagnoses(String model) throws DataFormatException {
    try {
      return shelf
          .find(folder -> Kind.of(folder).isPresent() && Files.isRegularFile(folder.resolve(model)))
          .stream()
          .map(folder -> given.resolve(shelf.root().relativize(folder)).normalize())
          .toList();
    } catch (IOException e) {
      throw DataFormatException.inFile(shelf.root(), "cannot be read: " + e.getMessage());
    }
  }

  /** A file that is broken is said when its folder is opened. */
  private static String about(Path folder, Kind kind) {
    try {
      return switch (kind) {
        case RUN -> run(JsonText.read(Shelf.file(folder, "errors.json")));
        case SENSING, MOTION, JOINT -> verdict(JsonText.read(Shelf.file(folder, "diagnosis.json")));
        case BATCH ->
            JsonText.read(Shelf.file(folder, "batch.json")).path("runs").asText() + " runs";
        case CAPTURE -> "";
      };
    } catch (DataFormatException e) {
      return "cannot be read";
    }
  }

  private static String run(JsonNode errors) {
    Set<String> obstacles = new LinkedHashSet<>();
    Set<String> sensors = new LinkedHashSet<>();
    for (JsonNode result : errors.path("results")) {
      obstacles.add(result.path("obstacle").asText());
      sensors.add(result.path("sensor").asText());
    }
    return String.join(", ", obstacles) + " · " + String.join(", ", sensors);
  }

  private static String verdict(JsonNode diagnosis) {
    List<String> names = new ArrayList<>();
    diagnosis.path("explanation").forEach(name -> names.add(name.asText()));
    String verdict = diagnosis.path("verdict").asText("audited only");
    return names.isEmpty() ? verdict : verdict + ": " + String.join(", ", names);
  }

  /**
   * Opens one of them.
   *
   * @param question JSON with its path
   * @throws DataFormatException naming file, line and field of the first fault
   */
  public synchronized String open(String question) throws DataFormatException {
    String name = path(question);
    Path folder = shelf.folder(name);
    String key = name + "@" + stamp(folder);
    String before = known.get(key);
    if (before != null) {
      return before;
    }
    ObjectNode root = read(name, folder);
    String text = root.toString();
    if (root.has("rows") || root.has("windows")) {
      keep(key, text);
    }
    return text;
  }

  private void keep(String key, String text) {
    known.put(key, text);
    if (known.size() > KEPT) {
      known.remove(known.keySet().iterator().next());
    }
  }

  /** A folder is replaced as a whole when it is made anew. */
  private static String stamp(Path folder) throws DataFormatException {
    try {
      return Files.getLastModifiedTime(folder).toString();
    } catch (IOException e) {
      throw DataFormatException.inFile(folder, "cannot be read: " + e.getMessage());
    }
  }

  private ObjectNode read(String name, Path folder) throws DataFormatException {
    Kind kind =
        Kind.of(folder)
            .orElseThrow(
                () ->
                    DataFormatException.inArgument(
                        "path", "'" + name + "' is not a run, batch, capture or diagnosis"));
    ObjectNode root = JsonText.MAPPER.createObjectNode();
    root.put("path", name).put("kind", kind.word());
    switch (kind) {
      case RUN -> run(folder).add(root);
      case BATCH -> BatchView.add(folder, root);
      case SENSING -> SensingView.add(folder, sets, root);
      case MOTION -> MotionView.add(folder, sets, root);
      case JOINT -> {
        SensingView.add(folder, sets, root);
        MotionView.drive(folder, sets, root, root.path("diagnosis").path("motion"));
      }
      case CAPTURE -> CaptureView.add(folder, root);
    }
    return root;
  }

  /**
   * Returns how far a capture is, as the page of a capture has it: as of its journal now.
   *
   * @param path of the capture, as the list has it
   * @throws DataFormatException if there is no such capture, or its journal is damaged
   */
  public String capture(String path) throws DataFormatException {
    return captures.state(shelf.folder(path));
  }

  private RunView run(Path folder) throws DataFormatException {
    return new RunView(folder, traces, stamp(folder));
  }

  /**
   * Returns a part of a run's traces, as fine as a screen shows it.
   *
   * @param question JSON with the run's path, the obstacle, and box: least x and z, greatest x and
   *     z
   * @throws DataFormatException if there is no such run, or its trace cannot be read
   */
  public synchronized String trace(String question) throws DataFormatException {
    JsonInput json = JsonInput.parse(NAME, question);
    List<JsonInput> box = json.items("box");
    if (box.size() != 4) {
      throw json.field("box").isNot("[left, top, right, bottom]");
    }
    double[] ends = new double[4];
    for (int i = 0; i < ends.length; i++) {
      ends[i] = box.get(i).number(v -> Math.abs(v) <= MOST_M, "in metres, at most " + MOST_M);
    }
    ObjectNode root = JsonText.MAPPER.createObjectNode();
    Traces.write(
        run(shelf.folder(path(question))).trace(json.text("obstacle")),
        new DrivenWay.Box(ends[0], ends[1], ends[2], ends[3]),
        root);
    return root.toString();
  }

  private static String path(String question) throws DataFormatException {
    return JsonInput.parse(NAME, question).text("path");
  }
}
