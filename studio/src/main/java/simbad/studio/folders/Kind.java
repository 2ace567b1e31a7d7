package simbad.studio.folders;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** What a folder is, by the files in it. */
enum Kind {
  RUN("run", "errors.json", "errors.csv"),
  BATCH("batch", "results.csv", "batch.json"),
  JOINT("joint", "diagnosis.json", "motion.json", "model.json"),
  MOTION("motion", "diagnosis.json", "motion.json"),
  SENSING("sensing", "diagnosis.json"),
  CAPTURE("capture", "journal.txt");

  private final String word;
  private final List<String> files;

  Kind(String word, String... files) {
    this.word = word;
    this.files = List.of(files);
  }

  /** As the page has it. */
  String word() {
    return word;
  }

  /** Returns what a folder is; empty for one that is nothing of these. */
  static Optional<Kind> of(Path folder) {
    return Stream.of(values()).filter(kind -> kind.fits(folder)).findFirst();
  }

  private boolean fits(Path folder) {
    return files.stream().allMatch(file -> Files.isRegularFile(folder.resolve(file)));
  }
}
