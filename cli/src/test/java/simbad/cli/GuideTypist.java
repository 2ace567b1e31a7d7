package simbad.cli;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.Locale;

/**
 * Types lines into the program, in the folder in which this process was started: reads words as
 * JSON, a command in each line, and writes status, output and complaints as JSON.
 */
final class GuideTypist {
  private GuideTypist() {}

  /** Ends with its input. */
  public static void main(String... none) throws IOException {
    Locale.setDefault(Locale.ROOT);
    PrintStream answers = System.out;
    System.setOut(System.err);
    ObjectMapper json = new ObjectMapper();
    BufferedReader lines =
        new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
    for (String line = lines.readLine(); line != null; line = lines.readLine()) {
      Shell said = Shell.simbad(json.readValue(line, String[].class));
      answers.println(
          json.writeValueAsString(
              new String[] {String.valueOf(said.status()), said.out(), said.err()}));
    }
    System.exit(0); // Whatever threads a command left behind.
  }
}
