package simbad.experiments.batch;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import simbad.sonar.format.DataFormatException;

/** Specs for tests: an obstacle that is circled in a few hundred steps. */
public final class Specs {
  /** 20 to 30 cm in eight directions. */
  public static final String TABLE =
      """
      bearing_deg,threshold_m
      0,0.3
      45,0.2
      90,0.25
      135,0.3
      180,0.2
      225,0.3
      270,0.2
      315,0.25
      """;

  private Specs() {}

  /** A spec of the table and further fields, not read yet. */
  static Path write(Path folder, String further) throws IOException {
    Files.writeString(folder.resolve("small.csv"), TABLE);
    return Files.writeString(
        folder.resolve("spec.json"),
        "{\n\"format\": \"simbad-batch/1\",\n\"obstacles\": [\"small.csv\"],\n"
            + "\"speeds_m_per_s\": [0.2],\n"
            + further
            + "}\n");
  }

  static BatchJob job(Path folder, String further) throws IOException, DataFormatException {
    Path spec = write(folder, further);
    return BatchJob.read(spec, Files.readString(spec));
  }
}
