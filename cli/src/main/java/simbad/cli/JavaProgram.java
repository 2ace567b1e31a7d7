package simbad.cli;

import java.io.File;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.net.JarURLConnection;
import java.net.URI;
import java.net.URISyntaxException;
import java.net.URL;
import java.net.URLClassLoader;
import java.net.URLConnection;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * A Java program that can be started as a process of its own.
 *
 * @param command what starts it, less its arguments
 */
record JavaProgram(List<String> command) {
  private static final String BLIND_WORLD = "simbad.blindworld.Main";

  /** It has no terminal: its progress is ours. The others are Spark's. */
  private static final List<String> NOT_FOR_CHILDREN =
      List.of("-Dsimbad.terminal", "-Dspark.", "--add-");

  /** The archive is of other jars, and there is nothing left that the launcher could add. */
  private static final List<String> NOT_WITH_SPARK =
      List.of("-XX:SharedArchiveFile", "-Dsimbad.launcher");

  JavaProgram {
    command = List.copyOf(command);
  }

  /**
   * This very program, with the options that this Java was started with, as a process that does
   * commands one after the other ({@link StandingMain}) on one core.
   */
  static JavaProgram standing() {
    List<String> command = new ArrayList<>(List.of(java()));
    command.addAll(optionsWithout(NOT_FOR_CHILDREN));
    command.add("-XX:ActiveProcessorCount=1");
    command.addAll(List.of("-cp", classPath(), StandingMain.class.getName()));
    return new JavaProgram(command);
  }

  /**
   * This very program as the process {@link SparkProcess}, with the options that this Java was
   * started with.
   *
   * @param spark folder of Spark in the folder of the program's jars
   * @param ownClasses the user's own jars and folders
   */
  static JavaProgram withSpark(Path spark, String ownClasses) {
    List<String> command = new ArrayList<>(List.of(java(), "@" + spark.resolve("java-options")));
    command.addAll(optionsWithout(NOT_WITH_SPARK));
    // Spark's libraries come first: of those that both have, it takes no other versions.
    List<String> classPath = new ArrayList<>();
    classPath.add(spark.resolve("cluster.jar").toString());
    classPath.add(spark.resolve("jars").resolve("*").toString());
    classPath.add(spark.resolveSibling("*").toString());
    if (!ownClasses.isEmpty()) {
      classPath.add(ownClasses);
    }
    String entries = String.join(File.pathSeparator, classPath);
    command.addAll(List.of("-cp", entries, SparkProcess.class.getName()));
    return new JavaProgram(command);
  }

  private static List<String> optionsWithout(List<String> beginnings) {
    return ManagementFactory.getRuntimeMXBean().getInputArguments().stream()
        .filter(option -> beginnings.stream().noneMatch(option::startsWith))
        .toList();
  }

  /**
   * Where a cluster's worker does the work, the program's jars were sent to it and stand in no
   * class path, and they come before the worker's own.
   */
  private static String classPath() {
    List<String> entries = new ArrayList<>();
    if (JavaProgram.class.getClassLoader() instanceof URLClassLoader sent) {
      for (URL url : sent.getURLs()) {
        entries.add(Path.of(URI.create(url.toString())).toString());
      }
    }
    // The process runs in another folder.
    for (String entry : System.getProperty("java.class.path").split(File.pathSeparator, -1)) {
      entries.add(Path.of(entry).toAbsolutePath().toString());
    }
    return String.join(File.pathSeparator, entries);
  }

  /**
   * The blind world, which sees nothing of this program: only its own jar is on its class path.
   *
   * @throws IOException when this installation lacks it
   */
  static JavaProgram blindWorld() throws IOException {
    String main = BLIND_WORLD.replace('.', '/') + ".class";
    URL url = ClassLoader.getSystemResource(main);
    if (url == null) {
      throw new IOException("blind-world.jar is not among this program's jars");
    }
    return new JavaProgram(List.of(java(), "-cp", home(url, main).toString(), BLIND_WORLD));
  }

  /** The jar or the folder that a class was found in. */
  private static Path home(URL url, String name) throws IOException {
    URLConnection connection = url.openConnection();
    try {
      if (connection instanceof JarURLConnection jar) {
        return Path.of(jar.getJarFileURL().toURI());
      }
      Path file = Path.of(url.toURI());
      int depth = Path.of(name).getNameCount();
      return file.getRoot().resolve(file.subpath(0, file.getNameCount() - depth));
    } catch (URISyntaxException e) {
      throw new IOException(url + ": not a place of files", e);
    }
  }

  private static String java() {
    return Path.of(System.getProperty("java.home"), "bin", "java").toString();
  }

  /** The whole command line. */
  List<String> with(List<String> arguments) {
    List<String> whole = new ArrayList<>(command);
    whole.addAll(arguments);
    return whole;
  }
}
