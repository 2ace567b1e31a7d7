package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import picocli.CommandLine;

/** What every registered subcommand owes its user, groups and their commands included. */
class SubcommandsTest {
  @TestFactory
  Stream<DynamicTest> helpHasDescriptionAndExample() {
    return Subcommands.all().stream()
        .map(CommandLine::new)
        .flatMap(SubcommandsTest::withNested)
        .map(
            command -> DynamicTest.dynamicTest(command.getCommandName(), () -> checkHelp(command)));
  }

  private static Stream<CommandLine> withNested(CommandLine command) {
    Stream<CommandLine> nested = command.getSubcommands().values().stream();
    return Stream.concat(Stream.of(command), nested.flatMap(SubcommandsTest::withNested));
  }

  private static void checkHelp(CommandLine command) {
    var usage = command.getCommandSpec().usageMessage();
    assertTrue(usage.description().length > 0, "description");
    assertTrue(String.join("\n", usage.footer()).contains("Example: simbad "), "footer's example");
    assertTrue(command.getCommandSpec().findOption("-h").usageHelp(), "-h");
  }

  /** Picocli complains on standard error of a help that it cannot format, and prints it raw. */
  @Test
  void help_isPrintedWithoutAWarning() {
    PrintStream err = System.err;
    ByteArrayOutputStream said = new ByteArrayOutputStream();
    System.setErr(new PrintStream(said, true, StandardCharsets.UTF_8));
    try {
      withNested(Main.commandLine(Subcommands.all())).forEach(CommandLine::getUsageMessage);
    } finally {
      System.setErr(err);
    }
    assertEquals("", said.toString(StandardCharsets.UTF_8));
  }

  @Test
  void namesAreUnique() {
    var names = Subcommands.all().stream().map(c -> new CommandLine(c).getCommandName()).toList();
    assertEquals(names.stream().distinct().toList(), names);
  }

  @ParameterizedTest
  @CsvSource({"test,''", "release,--out x"})
  void whatOnlyTheLauncherCanDo_theProgramSaysSo(String command, String arguments) {
    StringWriter err = new StringWriter();
    int status =
        Main.run(
            Subcommands.all(),
            new PrintWriter(new StringWriter()),
            new PrintWriter(err, true),
            (command + " " + arguments).strip().split(" ", -1));
    assertEquals(2, status);
    assertTrue(err.toString().contains("call ./simbad " + command), err.toString());
  }
}
