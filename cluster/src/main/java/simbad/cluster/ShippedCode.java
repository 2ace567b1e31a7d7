package simbad.cluster;

import java.io.File;
import java.net.URI;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.apache.spark.SparkContext;

/**
 * The part of this program's class path that is not Spark's own, which workers have: a jar of
 * the same name as one of Spark's is Spark's.
 *
 * @param jars to send to the workers
 * @param folders of classes, as development has them, joined as in a class path: they are not sent,
 *     workers on the same machine read them
 */
record ShippedCode(List<String> jars, String folders) {
  private static final String SPARK_JARS = "simbad.spark.jars";

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
    Path spark = sparkJars();
    return classPath()
        .filter(entry -> !Files.isRegularFile(spark.resolve(String.valueOf(entry.getFileName()))))
        .toList();
  }

  private static Stream<Path> classPath() {
    return Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator, -1))
        .filter(entry -> !entry.isEmpty())
        .map(entry -> Path.of(entry).toAbsolutePath().normalize());
  }

  /** Those beside the one that holds Spark's core, where nothing else is said. */
  private static Path sparkJars() {
    String named = System.getProperty(SPARK_JARS);
    if (named != null) {
      return Path.of(named);
    }
    try {
      URI core = SparkContext.class.getProtectionDomain().getCodeSource().getLocation().toURI();
      return Path.of(core).resolveSibling("");
    } catch (URISyntaxException e) {
      throw new IllegalStateException(e);
    }
  }
}
