package simbad.user;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.StringWriter;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;

/**
 * The programs of {@code src/test/oldprograms}, written as people write for Simbad: compiled
 * against the public names, without this project's rules.
 */
public final class OldPrograms {
  /** Where their sources are. */
  public static final Path SOURCES = Path.of("src", "test", "oldprograms", "oldprograms");

  private OldPrograms() {}

  /** Returns the names of the programs' main classes. */
  public static List<String> names() throws IOException {
    return sources().stream()
        .map(source -> source.getFileName().toString().replace(".java", ""))
        .filter(name -> !name.equals("package-info"))
        .toList();
  }

  private static List<Path> sources() throws IOException {
    try (Stream<Path> files = Files.list(SOURCES)) {
      return files.sorted().toList();
    }
  }

  /** Compiles all programs into an empty folder and returns what loads them. */
  public static ClassLoader compile(Path classes) throws IOException {
    JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
    StringWriter messages = new StringWriter();
    String classPath =
        System.getProperty("surefire.test.class.path", System.getProperty("java.class.path"));
    try (StandardJavaFileManager files = compiler.getStandardFileManager(null, null, null)) {
      assertEquals(14, sources().size());
      List<String> options =
          List.of("-nowarn", "-proc:none", "-d", classes.toString(), "-cp", classPath);
      var units = files.getJavaFileObjectsFromPaths(sources());
      boolean compiled = compiler.getTask(messages, files, null, options, null, units).call();
      assertTrue(compiled, messages::toString);
    }
    URL[] urls = {classes.toUri().toURL()};
    return new URLClassLoader(urls, OldPrograms.class.getClassLoader());
  }
}
