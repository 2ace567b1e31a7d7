package simbad.bench.board;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/**
 * What the simulated board is made of: the firmware's folder and the programs of this machine that
 * run it.
 *
 * @param firmware the folder firmware-pic18 of the project
 * @param sanitized whether the gpsim modules watch their own memory and arithmetic, and end the
 *     simulation at the first fault; takes twice the time
 */
public record BoardKit(Path firmware, boolean sanitized) {
  /** Debian's package of each program and file that is needed. */
  private static final Map<String, String> PACKAGES =
      Map.of("gpsim", "gpsim", "g++", "g++", "make", "make");

  private static final Path GPSIM_HEADERS = Path.of("/usr/include/gpsim/modules.h");

  /** Returns the kit of the project in a folder. */
  public static BoardKit ofProject(Path project) {
    return new BoardKit(project.resolve("firmware-pic18"), false);
  }

  /** Returns the same kit with modules that watch themselves. */
  BoardKit watched() {
    return new BoardKit(firmware, true);
  }

  /** What gpsim's environment needs besides, to load the modules. */
  Map<String, String> environment() throws IOException, InterruptedException {
    if (!sanitized) {
      return Map.of();
    }
    // The leaks would be gpsim's.
    return Map.of(
        "LD_PRELOAD", said(List.of("g++", "-print-file-name=libasan.so")).strip(),
        "ASAN_OPTIONS", "detect_leaks=0:exitcode=99",
        "UBSAN_OPTIONS", "halt_on_error=1:exitcode=99");
  }

  /** Returns the program as it is burnt into the chip. */
  public Path program() {
    return firmware.resolve("dist").resolve("ranger.hex");
  }

  /** Returns the checksum that was committed with the program, as sha256sum writes it. */
  public Path programChecksum() {
    return firmware.resolve("dist").resolve("ranger.hex.sha256");
  }

  /**
   * Returns Debian's names of the packages that are missing here for running the board, in a fixed
   * order.
   */
  public List<String> missingPackages() {
    return missingPackages(System.getenv().getOrDefault("PATH", ""), GPSIM_HEADERS);
  }

  static List<String> missingPackages(String path, Path headers) {
    Stream<String> programs =
        PACKAGES.entrySet().stream()
            .filter(entry -> !onPath(entry.getKey(), path))
            .map(Map.Entry::getValue)
            .sorted();
    return Stream.concat(programs, Files.exists(headers) ? Stream.empty() : Stream.of("gpsim-dev"))
        .toList();
  }

  private static boolean onPath(String program, String path) {
    for (String folder : path.split(File.pathSeparator, -1)) {
      if (!folder.isEmpty() && Files.isExecutable(Path.of(folder, program))) {
        return true;
      }
    }
    return false;
  }

  /**
   * Builds the gpsim modules where they are missing or out of date: in the project's folder, for
   * all who may read it, or, where this account may not write there, in another one.
   *
   * @param own a folder of this account's
   * @return the library
   * @throws IOException if a tool is missing, saying which and how to install it, or if the build
   *     fails
   * @throws InterruptedException if the thread is interrupted meanwhile
   */
  Path modules(Path own) throws IOException, InterruptedException {
    List<String> missing = missingPackages();
    if (!missing.isEmpty()) {
      throw new IOException(
          "missing here for the simulated board; please type: sudo apt-get install -y "
              + String.join(" ", missing));
    }
    if (!Files.exists(firmware.resolve("Makefile"))) {
      throw new IOException(firmware + ": is not the project's folder firmware-pic18");
    }
    String what = sanitized ? "sanitized-modules" : "modules";
    List<String> make = List.of("make", "-s", "-C", firmware.toString(), what);
    Path target = firmware.resolve("target");
    boolean mayBuild = Files.isWritable(Files.exists(target) ? target : firmware);
    Path folder = mayBuild || isDone(with(make, "-q")) ? target : own;
    said(folder.equals(own) ? with(make, "BUILD=" + own.toAbsolutePath()) : make);
    return folder.resolve(sanitized ? "libsimbadboard-sanitized.so" : "libsimbadboard.so");
  }

  private static List<String> with(List<String> command, String argument) {
    return Stream.concat(command.stream(), Stream.of(argument)).toList();
  }

  private static boolean isDone(List<String> command) throws IOException, InterruptedException {
    return new ProcessBuilder(command)
            .redirectOutput(ProcessBuilder.Redirect.DISCARD)
            .redirectError(ProcessBuilder.Redirect.DISCARD)
            .start()
            .waitFor()
        == 0;
  }

  private static String said(List<String> command) throws IOException, InterruptedException {
    Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
    process.getOutputStream().close();
    String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    if (process.waitFor() != 0) {
      throw new IOException("'" + String.join(" ", command) + "' failed: " + said.strip());
    }
    return said;
  }
}
