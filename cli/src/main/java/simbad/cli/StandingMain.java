package simbad.cli;

import java.io.BufferedReader;
import java.io.FileDescriptor;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.util.Locale;

/**
 * The program as a process that does one command after the other, so that many share one start of
 * Java.
 *
 * <p>A line of standard input is a command line, its words parted by tabs. Complaints go to
 * standard output, then a line {@code ended with status N}. It ends where its input does, thus
 * never outlives who started it.
 */
final class StandingMain {
  /** What the line begins with that ends what is said of a command. */
  static final String ENDED = "ended with status ";

  private StandingMain() {}

  /**
   * Does commands until there are no more.
   *
   * @param none not looked at
   */
  public static void main(String... none) throws IOException {
    Locale.setDefault(Locale.ROOT);
    Windows.noneUnlessAsked();
    PrintWriter nowhere = new PrintWriter(Writer.nullWriter());
    PrintWriter heard = Main.utf8(FileDescriptor.out);
    BufferedReader lines =
        new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
    for (String line = lines.readLine(); line != null; line = lines.readLine()) {
      int status = Main.run(Subcommands.all(), nowhere, heard, line.split("\t"));
      heard.println(ENDED + status);
    }
    System.exit(ExitStatus.DONE);
  }
}
