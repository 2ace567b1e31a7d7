package simbad.cli;

import java.io.IOException;
import simbad.bench.board.BoardKit;
import simbad.cli.machine.Launcher;
import simbad.cli.machine.Purpose;

/** What the simulated board is made of. */
final class SimulatedBoard {
  private SimulatedBoard() {}

  /**
   * Returns it, with what is missing for it installed where the launcher may.
   *
   * @throws IOException if it cannot be installed, or the project's folder is not there
   */
  static BoardKit kit() throws IOException, InterruptedException {
    Launcher.need(Purpose.BOARD);
    return BoardKit.ofProject(ProjectFolder.find());
  }
}
