package simbad.cli;

import com.fasterxml.jackson.databind.json.JsonMapper;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import simbad.experiments.blindcheck.AuditTally;
import simbad.gap.diagnosis.DataSetFolder;
import simbad.motion.format.MotionFolder;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.TextFile;

/**
 * The audit of a withheld check's cases. It fits nothing, so that there is nothing to withhold:
 * truths are read here to count with.
 *
 * @param world with cases/ and truth/
 * @param target the folder for audit.csv and audit.txt
 */
record BlindAudit(Path world, Path target) {
  void run(PrintWriter out) throws IOException, DataFormatException {
    List<Path> cases;
    try (Stream<Path> entries = Files.list(world.resolve("cases"))) {
      cases = entries.sorted().toList();
    }
    AuditTally tally = new AuditTally();
    try (Progress progress = Progress.of("auditing", cases.size())) {
      for (Path one : cases) {
        if (MotionFolder.isOne(one)) {
          throw DataFormatException.inFile(
              one, "is a motion folder, but the audit that is counted is of readings");
        }
        tally.add(new DataSetFolder(one).read(), truth(one.getFileName().toString()));
        progress.step();
      }
    }
    TextFile.write(target.resolve("audit.csv"), tally.csv());
    TextFile.write(target.resolve("audit.txt"), String.join("\n", tally.table()) + "\n");
    tally.table().forEach(out::println);
    out.println("written to " + target.resolve("audit.csv") + " and audit.txt");
  }

  private Set<String> truth(String id) throws IOException {
    Set<String> names = new TreeSet<>();
    Path file = world.resolve("truth").resolve(id).resolve("truth.json");
    JsonMapper.builder()
        .build()
        .readTree(Files.readString(file))
        .path("effects")
        .fieldNames()
        .forEachRemaining(names::add);
    return names;
  }
}
