package simbad.cli.machine;

import java.io.File;
import java.io.IOException;
import java.lang.ProcessBuilder.Redirect;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;

/**
 * The machine that the program runs on, as far as it has what the program needs.
 *
 * @param project folder of the project
 * @param environment variables, the search path among them
 * @param java home of the Java that builds and runs the program
 * @param javaVersion its major version
 */
public record Machine(Path project, Map<String, String> environment, Path java, int javaVersion) {
  /** Where fonts are, below the root and below the home folder. */
  private static final List<String> FONTS =
      List.of("/usr/share/fonts", "/usr/local/share/fonts", ".fonts", ".local/share/fonts");

  /** Copies the environment. */
  public Machine {
    environment = Map.copyOf(environment);
  }

  /**
   * Returns this machine.
   *
   * @param project folder of the project
   */
  public static Machine here(Path project) {
    return new Machine(
        project,
        System.getenv(),
        Path.of(System.getProperty("java.home")),
        Runtime.version().feature());
  }

  /**
   * Returns the packages of Debian that hold what is missing, in the order of their names.
   *
   * @param purpose for which it is missing
   * @throws IOException if the project's list cannot be read
   * @throws InterruptedException if the thread is interrupted meanwhile
   */
  public Set<String> missing(Purpose purpose) throws IOException, InterruptedException {
    boolean isDebian = hasProgram("apt-get");
    Set<String> missing = new TreeSet<>();
    for (Need need : Need.of(project)) {
      // Elsewhere libraries stand in places that nobody here knows.
      if (need.isFor(purpose) && (isDebian || need.isEverywhere())) {
        missing.addAll(missing(need));
      }
    }
    return missing;
  }

  private List<String> missing(Need need) throws IOException, InterruptedException {
    String name = need.name();
    boolean isHere =
        switch (need.kind()) {
          case JAVA -> Files.exists(java.resolve("bin").resolve(name));
          case PROGRAM -> hasProgram(name);
          case DEBIAN -> hasProgram(name) || !isDebianItself();
          case LIBRARY -> Stream.of(name.split("\\|", -1)).anyMatch(Machine::hasLibrary);
          case HEADER -> Files.exists(directory("INCLUDE", "/usr/include").resolve(name));
          case FONT -> hasFont();
          case PYTHON -> ended("python3", "-c", "import " + name) == 0;
          case SCRIPT -> !Files.isExecutable(project.resolve(name));
        };
    if (need.kind() == Need.Kind.SCRIPT && !isHere) {
      return said(project.resolve(name).toString(), "--missing").lines().toList();
    }
    return isHere ? List.of() : need.packages().stream().map(this::withSeries).toList();
  }

  private String withSeries(String name) {
    String series = "openjdk-" + javaVersion;
    return switch (name) {
      case "JDK" -> series + "-jdk-headless";
      case "JRE" -> series + "-jre";
      default -> name;
    };
  }

  /** Tells whether a program is on the search path. */
  boolean hasProgram(String name) {
    return Stream.of(environment.getOrDefault("PATH", "").split(File.pathSeparator, -1))
        .filter(folder -> !folder.isEmpty())
        .anyMatch(folder -> Files.isExecutable(Path.of(folder, name)));
  }

  private static boolean isDebianItself() throws IOException {
    Path release = Path.of("/etc/os-release");
    return Files.isReadable(release) && Files.readAllLines(release).contains("ID=debian");
  }

  /** Whether below a folder of libraries there is a file whose name begins so. */
  private static boolean hasLibrary(String name) {
    Stream<Path> below = Stream.of("/usr/lib", "/lib").flatMap(lib -> entries(Path.of(lib)));
    Stream<Path> beside = entries(Path.of("/usr")).filter(Machine::isLibraries);
    return Stream.concat(below, beside).anyMatch(folder -> hasBegin(folder.resolve(name).toFile()));
  }

  private static boolean isLibraries(Path folder) {
    return folder.getFileName().toString().startsWith("lib");
  }

  private static boolean hasBegin(File begin) {
    String[] names = begin.getParentFile().list((folder, name) -> name.startsWith(begin.getName()));
    return names != null && names.length > 0;
  }

  private static Stream<Path> entries(Path folder) {
    File[] files = folder.toFile().listFiles();
    return files == null ? Stream.of() : Stream.of(files).map(File::toPath);
  }

  private boolean hasFont() throws IOException {
    for (String name : FONTS) {
      Path folder = Path.of(environment.getOrDefault("HOME", "")).resolve(name);
      if (Files.isDirectory(folder)) {
        try (Stream<Path> files = Files.walk(folder)) {
          if (files.anyMatch(file -> file.toString().matches(".*\\.[ot]t[fc]"))) {
            return true;
          }
        }
      }
    }
    return false;
  }

  /** The folder that a variable names, SIMBAD_..._DIRECTORY: tests have others. */
  Path directory(String what, String standard) {
    return Path.of(environment.getOrDefault("SIMBAD_" + what + "_DIRECTORY", standard));
  }

  /**
   * Returns the line to type that installs packages.
   *
   * @param packages names
   */
  public String installLine(Set<String> packages) throws IOException, InterruptedException {
    String sudo = said("id", "-u").strip().equals("0") ? "" : "sudo ";
    return sudo
        + "apt-get update && "
        + sudo
        + "apt-get install -y --no-install-recommends "
        + String.join(" ", packages);
  }

  private static int ended(String... command) throws InterruptedException {
    try {
      return new ProcessBuilder(command)
          .redirectOutput(Redirect.DISCARD)
          .redirectError(Redirect.DISCARD)
          .start()
          .waitFor();
    } catch (IOException e) {
      // There is no such program.
      return -1;
    }
  }

  private static String said(String... command) throws IOException, InterruptedException {
    Process process = new ProcessBuilder(command).redirectError(Redirect.INHERIT).start();
    process.getOutputStream().close();
    String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    process.waitFor();
    return said;
  }
}
