package simbad.cluster;

import java.io.File;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.apache.spark.SparkContext;

/**
 * The part of this program's class path that is not Spark's own, which workers have: all that does
 * not lie beside Spark's jar.
 *
 * @param jars to send to the workers
 * @param folders of classes, as development has them, joined as in a class path: they are not sent,
 *     workers on the same machine read them
 */
record ShippedCode(List<String> jars, String folders) {
  static ShippedCode ofThisProgram() {
    List<Path> own = own();
    return new ShippedCode(
        own.stream().filter(Files::isRegularFile).map(Path::toString).toList(),
        own.stream()
            .filter(Files::isDirectory)
            .map(Path::toString)
            .collect(Collectors.joining(File.pathSeparator)));
  }

  private static List<Path> own() {
    Path spark = jarOf(SparkContext.class);
    return classPath()
        .filter(entry -> !Objects.equals(entry.getParent(), spark.getParent()))
        .toList();
  }

  private static Stream<Path> classPath() {
    return Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator, -1))
        .filter(entry -> !entry.isEmpty())
        .map(entry -> Path.of(entry).toAbsolutePath().normalize());
  }

  private static Path jarOf(Class<?> type) {
    try {
      Path jar = Path.of(type.getProtectionDomain().getCodeSource().getLocation().toURI());
      return jar.toAbsolutePath().normalize();
    } catch (URISyntaxException e) {
      throw new IllegalStateException(e);
    }
  }
}
