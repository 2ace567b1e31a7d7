package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The user's own jars and folders. */
class OwnClassesTest {
  @TempDir private Path folder = Path.of("");

  @Test
  void whatIsNotThere_isNamed() throws Exception {
    String jar = Files.createFile(folder.resolve("mine.jar")).toString();
    String jars = folder + "/*";
    assertEquals(Optional.empty(), OwnClasses.missing(""));
    assertEquals(Optional.empty(), OwnClasses.missing(jar + File.pathSeparator + jars));
    assertEquals(Optional.of("jars/*"), OwnClasses.missing(jar + File.pathSeparator + "jars/*"));
    assertEquals(Optional.of("your.jar"), OwnClasses.missing("your.jar" + File.pathSeparator));
  }
}
