package simbad.bench.board;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.TemporaryFolder;
import simbad.sonar.format.TextFile;

/** A folder of its own for one run of gpsim: its script, its socket, what it says. */
final class Workplace {
  private final TemporaryFolder temporary;
  private final Path folder;

  private Workplace(TemporaryFolder temporary) {
    this.temporary = temporary;
    folder = temporary.path();
  }

  static Workplace create(BoardKit kit, BoardSetup setup)
      throws IOException, DataFormatException, InterruptedException {
    Workplace workplace = new Workplace(TemporaryFolder.create("simbad-board"));
    try {
      Path modules = kit.modules(workplace.folder);
      TextFile.write(workplace.image(), GpsimImage.read(kit.program()));
      TextFile.write(workplace.script(), workplace.text(modules, setup));
      return workplace;
    } catch (IOException | DataFormatException | InterruptedException e) {
      workplace.delete();
      throw e;
    }
  }

  /**
   * The 4321 in place of the 4320, which gpsim does not know: docs/guide/board.md says what
   * differs.
   */
  private String text(Path modules, BoardSetup setup) {
    return """
      module library "%s"
      processor pic18f4321
      load "%s"
      p18f4321.BreakOnReset = false
      module load driver driver
      module load srf04 sonar
      module load ptyuart uart
      node trigger_line echo_line transmit_line receive_line
      attach trigger_line portb3 sonar.TRIG
      attach echo_line portb4 sonar.ECHO
      attach transmit_line portc6 uart.RX
      attach receive_line portc7 uart.TX
      uart.pace = "%s"
      driver.socket = "%s"
      uart.link = "%s"
      run
      quit
      """
        .formatted(modules.toAbsolutePath(), image(), setup.pace(), socket(), setup.link());
  }

  private Path script() {
    return folder.resolve("board.stc");
  }

  private Path image() {
    return folder.resolve("program.hex");
  }

  private Path said() {
    return folder.resolve("gpsim.log");
  }

  Path socket() {
    return folder.resolve("driver");
  }

  Process startGpsim(Map<String, String> environment) throws IOException {
    // In a session of its own: Ctrl-C is for the program that drives it, which then ends it in
    // order.
    ProcessBuilder gpsim =
        new ProcessBuilder("setsid", "gpsim", "-i", "-c", script().toString())
            // At the end of its input gpsim prints prompts without end, should a line of its script
            // fail.
            .redirectInput(ProcessBuilder.Redirect.PIPE)
            .redirectErrorStream(true)
            .redirectOutput(said().toFile())
            .directory(folder.toFile());
    gpsim.environment().putAll(environment);
    return gpsim.start();
  }

  /** What gpsim said last, for a message. */
  String lastWords() throws IOException {
    File log = said().toFile();
    List<String> lines = log.exists() ? Files.readAllLines(said()) : List.of();
    return String.join(" | ", lines.subList(Math.max(0, lines.size() - 3), lines.size()));
  }

  void delete() {
    temporary.close();
  }
}
