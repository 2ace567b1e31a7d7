package simbad.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import simbad.gap.diagnosis.DiagnosisJson;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.TemporaryFolder;
import simbad.sonar.format.TextFile;
import simbad.sonar.format.WholeFile;

/**
 * What the answers of a withheld check propose to measure next: it is measured in the sealed
 * worlds, added to the readings as a user adds it, and scored when it was diagnosed again.
 *
 * @param folder of the check
 * @param blindWorld which alone knows the worlds
 */
record BlindNext(Path folder, BlindWorld blindWorld) {
  private static final String READINGS = "readings.csv";

  /** The cases with the rows that were added, as the check's own folder of worlds has them. */
  Path world() {
    return folder.resolve("next").resolve("world");
  }

  /** The answers to them. */
  Path answers() {
    return folder.resolve("next").resolve("answers");
  }

  /** What came of each proposal, once it is scored. */
  Path table() {
    return folder.resolve("next.csv");
  }

  private Path before() {
    return folder.resolve("answers");
  }

  /**
   * Has the worlds read at the proposed poses, unless they are already.
   *
   * @param drawing the options by which the worlds were drawn, less their folder
   */
  void measure(List<String> drawing) throws IOException, DataFormatException, InterruptedException {
    if (Files.exists(world())) {
      return;
    }
    Path drawn = folder.resolve("world");
    try (TemporaryFolder temporary = TemporaryFolder.create("simbad-next");
        StagedDirectory staged = StagedDirectory.beside(world());
        Progress progress = Progress.of("measuring", proposals())) {
      Path read = temporary.path().resolve("read");
      List<String> arguments = new ArrayList<>(drawing);
      arguments.addAll(List.of("--at", before().toString(), "--world", drawn.toString()));
      arguments.addAll(List.of("--out", read.toString()));
      blindWorld.run(arguments, Optional.empty(), line -> progress.step());
      Files.createDirectories(staged.path().resolve("cases"));
      for (String id : names(read)) {
        OpenCase one = OpenCase.read(drawn, id);
        byte[] added = Files.readAllBytes(read.resolve(id).resolve(READINGS));
        one.open().computeIfPresent(READINGS, (name, rows) -> with(rows, added));
        write(one.open(), staged.path().resolve("cases").resolve(id));
        write(one.later(), staged.path().resolve("rows").resolve(id));
      }
      staged.publish();
    }
  }

  private long proposals() throws IOException {
    return names(before()).stream()
        .filter(id -> Files.exists(before().resolve(id).resolve(DiagnosisJson.POSES)))
        .count();
  }

  private static List<String> names(Path parent) throws IOException {
    try (Stream<Path> entries = Files.list(parent)) {
      return entries.map(one -> one.getFileName().toString()).sorted().toList();
    }
  }

  /** As the guide says: the rows are added without their header. */
  private static byte[] with(byte[] readings, byte[] added) {
    String text = new String(readings, StandardCharsets.UTF_8);
    String rows = new String(added, StandardCharsets.UTF_8);
    String whole = text.endsWith("\n") ? text : text + "\n";
    return (whole + rows.substring(rows.indexOf('\n') + 1)).getBytes(StandardCharsets.UTF_8);
  }

  private static void write(Map<String, byte[]> files, Path target) throws IOException {
    Files.createDirectories(target);
    for (var file : files.entrySet()) {
      WholeFile.write(target.resolve(file.getKey()), file.getValue());
    }
  }

  /**
   * Has the answers after scored against those before, and writes and prints what comes of it.
   *
   * @param known options that tell the scorer of names
   */
  void score(List<String> known, PrintWriter out)
      throws IOException, DataFormatException, InterruptedException {
    try (TemporaryFolder temporary = TemporaryFolder.create("simbad-scores")) {
      Path text = temporary.path().resolve("next.txt");
      Path csv = temporary.path().resolve("next.csv");
      Path world = folder.resolve("world");
      List<String> arguments =
          new ArrayList<>(List.of("next", "--truth", world.resolve("truth").toString()));
      arguments.addAll(List.of("--manifest", world.resolve("manifest.json").toString()));
      arguments.addAll(List.of("--answers", before().toString(), "--again", answers().toString()));
      arguments.addAll(List.of("--out", csv.toString()));
      arguments.addAll(known);
      blindWorld.run(arguments, Optional.of(text), line -> {});
      TextFile.write(folder.resolve("next.txt"), Files.readString(text));
      TextFile.write(table(), Files.readString(csv));
    }
    out.println();
    Files.readString(folder.resolve("next.txt")).lines().forEach(out::println);
    out.println("written to " + table() + " and next.txt");
  }
}
