package simbad.gap.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.ReadingsWriter;
import simbad.sonar.format.SceneWriter;

class DataSetFolderTest {
  @TempDir private Path folder = Path.of("target");

  private DataSetFolder write() throws IOException {
    Files.writeString(folder.resolve("scene.json"), SceneWriter.text(Samples.SETUP));
    Files.writeString(folder.resolve("readings.csv"), ReadingsWriter.text(Samples.DATA.readings()));
    return new DataSetFolder(folder);
  }

  private void refused(String... words) {
    DataFormatException fault =
        assertThrows(DataFormatException.class, () -> new DataSetFolder(folder).read());
    List.of(words).forEach(word -> assertTrue(fault.toString().contains(word), fault.toString()));
  }

  @Test
  void folder_isRead() throws Exception {
    DataSet data = write().read();
    assertEquals(folder.getFileName().toString(), data.name());
    assertEquals(Samples.DATA.readings(), data.readings());
    assertEquals(List.of(), data.reference());
    Files.copy(folder.resolve("readings.csv"), folder.resolve("reference.csv"));
    assertEquals(Samples.DATA.readings(), new DataSetFolder(folder).read().reference());
  }

  @Test
  void name_isTheFoldersOwn() throws Exception {
    assertEquals("b", new DataSetFolder(Path.of("a/b/")).name());
    assertEquals("b", new DataSetFolder(Path.of("a/b/.")).name());
    assertThrows(DataFormatException.class, () -> new DataSetFolder(Path.of("/")).name());
  }

  /** SHA-256 of the empty text, FIPS 180-4. */
  @Test
  void hashes_areOfTheFilesThatAreThere() throws Exception {
    Files.writeString(folder.resolve("readings.csv"), "");
    assertEquals(
        "{readings.csv=e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855}",
        new DataSetFolder(folder).sha256().toString());
  }

  @Test
  void missing_isNamed() throws IOException {
    refused("scene.json", "no such file");
    write();
    Files.delete(folder.resolve("readings.csv"));
    refused("readings.csv", "no such file");
    Files.writeString(
        folder.resolve("readings.csv"), "run,sensor,t_s,x_m,z_m,heading_deg,range_m\n");
    refused("readings.csv", "has no rows");
    folder = folder.resolve("readings.csv");
    refused("is not a folder");
    folder = folder.resolveSibling("nowhere");
    refused("nowhere: no such folder");
  }
}
