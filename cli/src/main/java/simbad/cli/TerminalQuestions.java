package simbad.cli;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintWriter;
import simbad.experiments.dataset.Questions;
import simbad.sonar.format.DataFormatException;

/** Asks the person at the terminal what a log does not say. */
final class TerminalQuestions implements Questions {
  private static final int ATTEMPTS = 3;

  private final BufferedReader in;
  private final PrintWriter out;

  TerminalQuestions(BufferedReader in, PrintWriter out) {
    this.in = in;
    this.out = out;
  }

  /** Those of the person at the terminal; where there is none, of nobody. */
  static Questions here(PrintWriter out) {
    return Progress.onTerminal()
        ? new TerminalQuestions(BenchCaptureCommand.typed(), out)
        : Questions.NOBODY;
  }

  @Override
  public String ask(String option, String question, String seen) throws DataFormatException {
    out.println("The log shows: " + seen);
    try {
      for (int attempt = 0; attempt < ATTEMPTS; attempt++) {
        out.print("--" + option + ", " + question + "? ");
        out.flush();
        String answer = in.readLine();
        if (answer == null) {
          break;
        }
        if (!answer.isBlank()) {
          return answer.strip();
        }
      }
    } catch (IOException e) {
      // Nobody is there any more.
    }
    return Questions.NOBODY.ask(option, question, seen);
  }
}
