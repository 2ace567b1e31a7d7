package simbad.cluster;

import java.io.File;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.stream.Stream;
import org.apache.spark.SparkContext;

/**
 * The part of this program's class path that is not Spark's own, which workers have: all that does
 * not lie beside Spark's jar.
 *
 * @param jars to send to the workers
 * @param onThisMachine of development, which has folders of classes among its jars, the whole part
 *     as a class path: nothing is sent, workers on the same machine read it. A class in a folder
 *     would not find one in a jar that was sent, for what is sent is loaded by another loader.
 */
record ShippedCode(List<String> jars, String onThisMachine) {
  static ShippedCode ofThisProgram() {
    List<String> own = own().stream().map(Path::toString).toList();
    return own().stream().allMatch(Files::isRegularFile)
        ? new ShippedCode(own, "")
        : new ShippedCode(List.of(), String.join(File.pathSeparator, own));
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
