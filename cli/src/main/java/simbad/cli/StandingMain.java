package simbad.cli;

import java.io.BufferedReader;
import java.io.FileDescriptor;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;

/**
 * The program as a process that does one command after the other, so that many share one start of
 * Java.
 *
 * <p>A line of standard input is a command line, its words parted by tabs. Complaints go to
 * standard output, then a line {@code ended with status N}. It ends where its input does, also
 * within a command, thus never outlives who started it.
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
  public static void main(String... none) throws InterruptedException {
    Locale.setDefault(Locale.ROOT);
    WindowsAllowed.noneUnlessAsked();
    PrintWriter nowhere = new PrintWriter(Writer.nullWriter());
    PrintWriter heard = Main.utf8(FileDescriptor.out);
    BlockingQueue<String> commands = new LinkedBlockingQueue<>();
    Thread listener = new Thread(() -> listen(commands), "commands");
    listener.setDaemon(true);
    listener.start();
    while (true) {
      int status = Main.run(Subcommands.all(), nowhere, heard, commands.take().split("\t"));
      heard.println(ENDED + status);
    }
  }

  /** Ends the process where its input ends, whatever it is doing then. */
  private static void listen(BlockingQueue<String> commands) {
    try (BufferedReader lines =
        new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8))) {
      for (String line = lines.readLine(); line != null; line = lines.readLine()) {
        commands.add(line);
      }
    } catch (IOException gone) {
      // As where it ends: nobody is there any more.
      System.exit(ExitStatus.DONE);
    }
    System.exit(ExitStatus.DONE);
  }
}
