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
 */
public record BoardKit(Path firmware) {
  /** Debian's package of each program and file that is needed. */
  private static final Map<String, String> PACKAGES =
      Map.of("gpsim", "gpsim", "g++", "g++", "make", "make");

  private static final Path GPSIM_HEADERS = Path.of("/usr/include/gpsim/modules.h");

  /** Returns the kit of the project in a folder. */
  public static BoardKit ofProject(Path project) {
    return new BoardKit(project.resolve("firmware-pic18"));
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
    Stream<String> missing =
        PACKAGES.entrySet().stream()
            .filter(entry -> !onPath(entry.getKey()))
            .map(Map.Entry::getValue)
            .sorted();
    Stream<String> headers = Files.exists(GPSIM_HEADERS) ? Stream.empty() : Stream.of("gpsim-dev");
    return Stream.concat(missing, headers).toList();
  }

  private static boolean onPath(String program) {
    String path = System.getenv().getOrDefault("PATH", "");
    for (String folder : path.split(File.pathSeparator, -1)) {
      if (!folder.isEmpty() && Files.isExecutable(Path.of(folder, program))) {
        return true;
      }
    }
    return false;
  }

  /**
   * Builds the gpsim modules where they are missing or out of date.
   *
   * @return the library
   * @throws IOException if a tool is missing, saying which and how to install it, or if the build
   *     fails
   * @throws InterruptedException if the thread is interrupted meanwhile
   */
  Path modules() throws IOException, InterruptedException {
    List<String> missing = missingPackages();
    if (!missing.isEmpty()) {
      throw new IOException(
          "missing here for the simulated board; please type: sudo apt-get install -y "
              + String.join(" ", missing));
    }
    if (!Files.exists(firmware.resolve("Makefile"))) {
      throw new IOException(firmware + ": is not the project's folder firmware-pic18");
    }
    Process make =
        new ProcessBuilder("make", "-s", "-C", firmware.toString(), "modules")
            .redirectErrorStream(true)
            .start();
    make.getOutputStream().close();
    String said = new String(make.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    if (make.waitFor() != 0) {
      throw new IOException("cannot build the gpsim modules: " + said.strip());
    }
    return firmware.resolve("target").resolve("libsimbadboard.so");
  }
}
