package simbad.experiments.blindcheck;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import simbad.experiments.blindcheck.CheckScores.Estimate;
import simbad.experiments.blindcheck.CheckScores.Figures;
import simbad.experiments.report.CsvFile;
import simbad.sonar.format.TextFile;

/** Writes a check's results: check.json, tables as csv. */
public final class CheckFiles {
  private static final List<String> CASE_FIELDS =
      List.of(
          "case",
          "level",
          "kind",
          "so",
          "said",
          "right",
          "verdict",
          "verdict_probability",
          "unknown_probability",
          "first_effect",
          "first_probability",
          "shrink_claimed",
          "shrink_sealed",
          "share_of_oracle_removal");

  private CheckFiles() {}

  /**
   * Writes everything, over what an earlier scoring left.
   *
   * @param folder exists
   * @param order what was asked for
   * @param scores of it
   */
  public static void write(Path folder, CheckOrder order, CheckScores scores) throws IOException {
    ObjectNode check = CheckJson.object();
    check.put("format", "blind-check/1");
    check.set("order", order.json());
    scores.document().properties().forEach(field -> keep(check, field.getKey(), scores));
    TextFile.write(folder.resolve("check.json"), CheckJson.text(check));
    writeScores(folder.resolve("scores.csv"), scores);
    writeCalibration(folder.resolve("calibration.csv"), scores);
    writeCounts(folder.resolve("kinds.csv"), "kind", "kinds", scores);
    writeCounts(folder.resolve("standings.csv"), "kind", "standings", scores);
    writeCounts(folder.resolve("confusion.csv"), "so", "confusion", scores);
    writeEffects(folder.resolve("effects.csv"), scores);
    writeSizes(folder.resolve("sizes.csv"), scores);
    writeCases(folder.resolve("cases.csv"), scores);
  }

  private static void keep(ObjectNode check, String name, CheckScores scores) {
    if (!name.equals("format")) {
      check.set(name, scores.document().get(name));
    }
  }

  private static void writeScores(Path file, CheckScores scores) throws IOException {
    CsvFile.write(
        file,
        csv -> {
          csv.writeRecord("part", "answers", "score", "value", "low95", "high95", "counted");
          for (Figures figures : scores.figures()) {
            for (Measure measure : Measure.ALL) {
              Optional<Estimate> found = measure.of().apply(figures);
              if (found.isPresent()) {
                Estimate e = found.get();
                csv.writeRecord(
                    figures.part(),
                    figures.sort(),
                    measure.name(),
                    Double.toString(e.value()),
                    Double.toString(e.low()),
                    Double.toString(e.high()),
                    e.counted());
              }
            }
          }
        });
  }

  private static void writeCalibration(Path file, CheckScores scores) throws IOException {
    CsvFile.write(
        file,
        csv -> {
          csv.writeRecord(
              "part", "answers", "claim", "stated", "share", "low95", "high95", "hits", "of");
          for (Figures figures : scores.figures()) {
            for (String claim : List.of("verdict", "first_named")) {
              for (StatedProbabilities.Bin bin :
                  figures.calibration(claim + "_calibration").bins()) {
                Stream<Number> numbers =
                    Stream.of(
                        bin.stated(), bin.share(), bin.low(), bin.high(), bin.hits(), bin.of());
                csv.writeRecord(
                    Stream.concat(
                            Stream.of(figures.part(), figures.sort(), claim),
                            numbers.map(Number::toString))
                        .toList());
              }
            }
          }
        });
  }

  /** How often what was so was said to be what. */
  private static void writeCounts(Path file, String row, String field, CheckScores scores)
      throws IOException {
    CsvFile.write(
        file,
        csv -> {
          csv.writeRecord("part", "answers", row, "said", "cases");
          for (Figures figures : scores.figures()) {
            for (var so : figures.figures().path(field).properties()) {
              for (var said : so.getValue().properties()) {
                csv.writeRecord(
                    figures.part(),
                    figures.sort(),
                    so.getKey(),
                    said.getKey(),
                    said.getValue().asText());
              }
            }
          }
        });
  }

  private static void writeEffects(Path file, CheckScores scores) throws IOException {
    CsvFile.write(
        file,
        csv -> {
          csv.writeRecord("part", "answers", "effect", "share", "low95", "high95", "hits", "of");
          for (Figures figures : scores.figures()) {
            for (JsonNode line : figures.figures().path("effects_worst_first")) {
              csv.writeRecord(
                  Stream.concat(
                          Stream.of(figures.part(), figures.sort()),
                          Stream.of("effect", "share", "low95", "high95", "hits", "of")
                              .map(name -> line.path(name).asText()))
                      .toList());
            }
          }
        });
  }

  private static void writeSizes(Path file, CheckScores scores) throws IOException {
    CsvFile.write(
        file,
        csv -> {
          csv.writeRecord(
              Stream.concat(Stream.of("part", "answers"), SizeFound.FIELDS.stream()).toList());
          for (Figures figures : scores.figures()) {
            for (SizeFound one : SizeFound.of(figures)) {
              csv.writeRecord(
                  Stream.concat(Stream.of(figures.part(), figures.sort()), one.fields().stream())
                      .toList());
            }
          }
        });
  }

  private static void writeCases(Path file, CheckScores scores) throws IOException {
    CsvFile.write(
        file,
        csv -> {
          csv.writeRecord(CASE_FIELDS);
          for (JsonNode one : scores.cases()) {
            csv.writeRecord(CASE_FIELDS.stream().map(name -> one.path(name).asText()).toList());
          }
        });
  }
}
