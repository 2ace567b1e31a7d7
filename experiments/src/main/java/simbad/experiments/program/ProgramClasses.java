package simbad.experiments.program;

import java.io.IOException;
import java.net.MalformedURLException;
import java.net.URL;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.jar.Attributes.Name;
import java.util.jar.JarEntry;
import java.util.jar.JarFile;
import java.util.jar.Manifest;
import java.util.stream.Stream;
import java.util.zip.ZipException;
import org.objectweb.asm.ClassReader;
import simbad.sonar.format.DataFormatException;

/**
 * A program's classes as they were compiled, and where else it finds something.
 *
 * @param bytes of the class files by the classes' names, in the order of the names
 * @param places the program's own files, then the libraries
 * @param own the classes of Simbad that came with the program, which this Simbad stands in for
 * @param mainOfJar the class that a jar says is to be started, empty if none does
 */
record ProgramClasses(
    Map<String, byte[]> bytes, List<URL> places, List<String> own, String mainOfJar) {
  private static final String ENDING = ".class";

  /**
   * Reads a program.
   *
   * @param program a jar, a folder of classes or a folder of sources
   * @param libraries other people's jars, folders of classes and folders of sources
   * @param errors is told each error in sources
   * @throws DataFormatException if it is none of these, or its sources do not compile
   * @throws IOException if it cannot be read
   */
  static ProgramClasses read(Path program, List<Path> libraries, Consumer<String> errors)
      throws DataFormatException, IOException {
    Map<String, byte[]> found = new TreeMap<>();
    List<Path> compiled = new ArrayList<>();
    List<Path> sources = new ArrayList<>();
    for (Path library : libraries) {
      if (!Files.exists(library)) {
        throw DataFormatException.inFile(library, "no such jar or folder");
      }
      if (Files.exists(program) && Files.isSameFile(program, library)) {
        // The program itself, as in java -cp .; its classes are read below.
        continue;
      }
      (isOfSources(library) ? sources : compiled).add(library);
    }
    String mainOfJar = "";
    Set<String> own = new TreeSet<>();
    if (Files.isRegularFile(program)) {
      mainOfJar = readJar(program, found);
    } else if (Files.isDirectory(program)) {
      readFolder(program, found);
      if (found.isEmpty()) {
        own.addAll(SourceCompiler.simbads(program));
        found.putAll(SourceCompiler.compile(program, sources, compiled, errors));
      }
    } else {
      throw DataFormatException.inFile(program, "no such jar or folder");
    }
    found.keySet().stream().filter(ProgramClasses::isSimbads).forEach(own::add);
    own.forEach(found::remove);
    return new ProgramClasses(found, places(program, libraries), List.copyOf(own), mainOfJar);
  }

  /** True for a class that this Simbad has, too. */
  static boolean isSimbads(String name) {
    String file = name.replace('.', '/') + ENDING;
    return name.startsWith("simbad.")
        && ProgramClasses.class.getClassLoader().getResource(file) != null;
  }

  private static boolean isOfSources(Path folder) throws IOException {
    try (Stream<Path> files = Files.walk(folder)) {
      List<String> names = files.map(Path::toString).toList();
      return names.stream().noneMatch(name -> name.endsWith(ENDING))
          && names.stream().anyMatch(name -> name.endsWith(".java"));
    }
  }

  private static List<URL> places(Path program, List<Path> libraries) throws MalformedURLException {
    List<URL> places = new ArrayList<>(List.of(program.toUri().toURL()));
    for (Path library : libraries) {
      places.add(library.toUri().toURL());
    }
    return places;
  }

  /** Returns the class that the jar says is to be started, empty if it does not. */
  private static String readJar(Path file, Map<String, byte[]> found)
      throws DataFormatException, IOException {
    try (JarFile jar = new JarFile(file.toFile())) {
      for (JarEntry entry : jar.stream().filter(e -> e.getName().endsWith(ENDING)).toList()) {
        found.put(name(entry.getName()), jar.getInputStream(entry).readAllBytes());
      }
      Manifest manifest = jar.getManifest();
      String main =
          manifest == null ? null : manifest.getMainAttributes().getValue(Name.MAIN_CLASS);
      return main == null ? "" : main.strip();
    } catch (ZipException e) {
      throw DataFormatException.inFile(file, "is not a jar");
    }
  }

  private static void readFolder(Path folder, Map<String, byte[]> found) throws IOException {
    try (Stream<Path> files = Files.walk(folder)) {
      for (Path file : files.filter(path -> path.toString().endsWith(ENDING)).sorted().toList()) {
        byte[] bytes = Files.readAllBytes(file);
        // A project's folder of classes stands deeper than its packages say.
        found.put(new ClassReader(bytes).getClassName().replace('/', '.'), bytes);
      }
    }
  }

  private static String name(String path) {
    return path.substring(0, path.length() - ENDING.length()).replace('/', '.');
  }
}
