package simbad.studio.folders;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.stream.Stream;

/** What a folder is, by the files in it; the first that fits. */
enum Kind {
  RUN("run", "errors.json", "errors.csv"),
  BATCH("batch", "results.csv", "batch.json"),
  JOINT("joint", "model.json", "motion.json"),
  MOTION("motion", "diagnosis.json", "motion.json"),
  SENSING("sensing", "diagnosis.json", "diagnosis.json"),
  CAPTURE("capture", "journal.txt", "journal.txt");

  private final String word;
  private final String file;
  private final String beside;

  Kind(String word, String file, String beside) {
    this.word = word;
    this.file = file;
    this.beside = beside;
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
    return Files.isRegularFile(folder.resolve(file)) && Files.isRegularFile(folder.resolve(beside));
  }
}
