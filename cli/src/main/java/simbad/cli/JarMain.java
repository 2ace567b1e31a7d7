package simbad.cli;

/** What {@code java -jar simbad.jar} starts: the window, or any command. */
public final class JarMain {
  private JarMain() {}

  /**
   * Runs one command, {@code view} where none is given, and exits.
   *
   * @param arguments the command line
   */
  public static void main(String... arguments) {
    if (arguments.length == 0) {
      Main.main("view");
    } else {
      Main.main(arguments);
    }
  }
}
