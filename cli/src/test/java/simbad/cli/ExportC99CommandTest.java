package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ExportC99CommandTest {
  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  private Path header() {
    return folder.resolve("post.h");
  }

  private Shell export(String... more) {
    String[] all = new String[more.length + 4];
    all[0] = "export";
    all[1] = "c99";
    all[2] = "--out";
    all[3] = header().toString();
    System.arraycopy(more, 0, all, 4, more.length);
    return Shell.simbad(all);
  }

  /** A reconstructed table says so wherever it goes. */
  @Test
  void writesAHeaderThatSaysWhereItsTableIsFrom() throws Exception {
    Shell run = export("square", "--name", "post");

    assertEquals(0, run.status(), run.err());
    String text = Files.readString(header());
    assertTrue(text.contains("provenance: reconstructed"), text);
    assertTrue(text.contains("static inline int16_t post_read(post_pose at)"), text);
    assertFalse(text.contains("@"), "a place that was not filled");
  }

  private Path diagnosis(String changes) throws Exception {
    Path diagnosis = Files.createDirectory(folder.resolve("diagnosis"));
    Files.copy(
        Path.of("../data/gap/angle-against-uniform/scene.json"), diagnosis.resolve("scene.json"));
    Files.writeString(
        diagnosis.resolve("model.json"),
        "{\"format\": \"sonar-model/1\", \"sensors\": [\"SRF04\"], \"changes\": ["
            + changes
            + "]}");
    return diagnosis;
  }

  @Test
  void aDiagnosisIsFoldedIn() throws Exception {
    String gain = "{\"effect\": \"gain\", \"form\": \"factor\", \"parameters\": {\"factor\": 0.8}}";
    Shell run = export(diagnosis(gain).toString());

    assertEquals(0, run.status(), run.err());
    String text = Files.readString(header());
    assertTrue(text.contains("included: gain/factor"), text);
    assertTrue(text.contains("sonar_read_next(sonar_memory *memory, sonar_pose at)"), text);
    assertFalse(text.contains("@"), "a place that was not filled");
  }

  @Test
  void anEffectWithoutAFormInCIsRefusedByName() throws Exception {
    String late =
        "{\"effect\": \"latency\", \"form\": \"time\", \"parameters\": {\"delay_s\": 0.2}}";
    Shell run = export(diagnosis(late).toString());

    assertEquals(2, run.status());
    assertTrue(run.err().contains("effect latency/time"), run.err());
    assertFalse(Files.exists(header()));
  }

  @Test
  void aNameThatCDoesNotKnowIsRefused() {
    Shell run = export("round", "--name", "1st");

    assertEquals(2, run.status());
    assertTrue(
        run.err().contains("--name: '1st' cannot begin names in C; expected a small"), run.err());
  }

  @Test
  void anExistingFileStays() throws Exception {
    Files.writeString(header(), "mine");
    Shell run = export("round");

    assertEquals(2, run.status());
    assertEquals("mine", Files.readString(header()));
  }
}
