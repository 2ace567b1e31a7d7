package simbad.sonar.format;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Files that are damaged by chance are read or refused, see {@link FileDamage}. */
class FileFuzzTest {
  @TempDir private Path directory = Path.of("target");

  private void check(Faults.Reader reader, String good) {
    FileDamage.check(directory, reader, good);
  }

  @Test
  void tables() {
    check(TableFile::read, Samples.TABLE);
  }

  @Test
  void scenes() throws IOException {
    check(SceneFile::read, Samples.scene());
  }

  @Test
  void sensors() throws IOException {
    check(SensorFile::read, Samples.sensor());
  }

  @Test
  void readings() {
    check(ReadingsFile::read, Samples.READINGS);
    check(ReadingsFile::readPoses, Samples.READINGS);
  }
}
