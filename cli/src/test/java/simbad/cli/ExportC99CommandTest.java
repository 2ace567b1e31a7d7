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

  @Test
  void aDiagnosisIsRefusedByName() throws Exception {
    Path diagnosis = Files.createDirectory(folder.resolve("diagnosis"));
    Files.writeString(diagnosis.resolve("model.json"), "{}");
    Shell run = export(diagnosis.toString());

    assertEquals(2, run.status());
    assertTrue(run.err().contains("is a diagnosis: its effects have no form in C"), run.err());
    assertFalse(Files.exists(header()));
  }

  @Test
  void aNameThatCDoesNotKnowIsRefused() {
    Shell run = export("round", "--name", "1st");

    assertEquals(2, run.status());
    assertTrue(run.err().contains("name '1st' is no beginning of names in C"), run.err());
  }

  @Test
  void anExistingFileStays() throws Exception {
    Files.writeString(header(), "mine");
    Shell run = export("round");

    assertEquals(2, run.status());
    assertEquals("mine", Files.readString(header()));
  }
}
