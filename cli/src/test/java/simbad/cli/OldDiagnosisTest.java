package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A diagnosis folder that an older program wrote, of format "sonar-model/1". */
class OldDiagnosisTest {
  private static final Path OLD = Path.of("src/test/resources/old-diagnosis");

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  /** The same bytes as those that the older program wrote. */
  @Test
  void predicts_asItDid() throws IOException {
    Path out = folder.resolve("predictions.csv");
    Shell shell =
        Shell.simbad(
            "predict", OLD.toString(), OLD.resolve("rows.csv").toString(), "--out", out.toString());
    assertEquals(0, shell.status(), shell.err());
    assertEquals(Files.readString(OLD.resolve("predictions.csv")), Files.readString(out));
  }

  @Test
  void drives() throws IOException {
    Path out = folder.resolve("run");
    Shell shell =
        Shell.simbad(
            "run",
            "angle",
            "--sensor",
            "diagnosed:" + OLD,
            "--speed",
            "0.05",
            "--out",
            out.toString());
    assertEquals(0, shell.status(), shell.err());
    JsonNode errors = new ObjectMapper().readTree(out.resolve("errors.json").toFile());
    JsonNode result = errors.get("results").get(0);
    assertTrue(result.get("closed").asBoolean(), result.toString());
    // It was fitted to readings of this table, which it had not.
    assertTrue(result.get("edge_kept").asDouble() > 0.9, result.toString());
  }
}
