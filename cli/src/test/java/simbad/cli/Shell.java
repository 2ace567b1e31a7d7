package simbad.cli;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.List;

/** What a command line of the real program comes to, in this process. */
record Shell(int status, String out, String err) {
  static Shell simbad(String... arguments) {
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    int status =
        Main.run(
            Subcommands.all(), new PrintWriter(out, true), new PrintWriter(err, true), arguments);
    return new Shell(status, out.toString(), err.toString());
  }

  List<String> complaints() {
    return err.lines().toList();
  }
}
