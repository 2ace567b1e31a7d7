package simbad.bench.board;

import java.nio.file.Path;
import simbad.sonar.check.Checks;

/**
 * How a simulated board runs.
 *
 * @param link where the serial port shall appear, a link to a pseudo-terminal; what is there is
 *     replaced if it is a link
 * @param pace simulated per real second; 0 for as fast as it goes
 */
public record BoardSetup(Path link, double pace) {
  /** Checks the pace, and makes the path absolute. */
  public BoardSetup {
    Checks.notNegative("pace", pace);
    link = link.toAbsolutePath();
  }
}
