package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import picocli.CommandLine.MissingParameterException;

/**
 * Somebody who reads a page from top to bottom, types its commands, saves its files, compiles its
 * code and looks whether what is printed is what the page says.
 */
final class GuideReading implements AutoCloseable {
  private static final String PROGRAM = "./simbad";
  private static final Pattern CLASS =
      Pattern.compile("(?m)^(?:public )?(?:final )?(?:class|record) (\\w+)");
  private static final String ELISION = "...";

  private final GuideShell shell;
  private final List<GuideRule> rules;
  private final Set<GuideRule> used = new LinkedHashSet<>();
  private final Map<String, Shell> typed = new HashMap<>();
  private final List<Path> saved = new ArrayList<>();
  private String page = "";
  private boolean full;
  private String lastNamed = "";

  /** A reader who does not type what rules are about. */
  GuideReading(GuideShell shell, List<GuideRule> rules) {
    this.shell = shell;
    this.rules = rules;
  }

  /** Rules that no page needed. */
  List<GuideRule> unused() {
    return rules.stream().filter(rule -> !used.contains(rule)).toList();
  }

  @Override
  public void close() throws IOException {
    shell.close();
  }

  /**
   * Reads a page.
   *
   * @param name of the page, in the project
   * @param atLength whether what takes minutes is typed as well
   */
  void read(String name, boolean atLength) throws Exception {
    page = name;
    full = atLength;
    saved.clear();
    shell.forget();
    for (GuidePiece piece : GuidePiece.of(Path.of("..").resolve(page))) {
      try {
        take(piece);
      } catch (AssertionError | Exception fault) {
        throw new AssertionError(page + ":" + piece.line() + ": " + fault.getMessage(), fault);
      }
    }
    saved.forEach(this::checkIsUsed);
  }

  private void take(GuidePiece piece) throws Exception {
    switch (piece.kind()) {
      case GuidePiece.SPAN -> name(piece);
      case "java" -> {
        if (use(rule(page)).isEmpty()) {
          compile(piece.text());
        }
      }
      case "c" -> compileC(piece.text());
      case "csv", "json" -> save(piece);
      case "xml" -> assertTrue(piece.text().contains("<version>" + version() + "</version>"));
      default -> takeLines(piece);
    }
  }

  private static String version() throws IOException {
    return BuildVersion.text().split(" ", 2)[0];
  }

  /** Words name commands without all that they need: what is named must be there. */
  private void name(GuidePiece span) {
    if (span.text().startsWith(PROGRAM + " ")) {
      lastNamed = span.text();
      try {
        parse(span.text());
      } catch (MissingParameterException incomplete) {
        // As in "`./simbad diagnose` says why".
      }
    }
  }

  private void takeLines(GuidePiece piece) throws Exception {
    List<String> lines = piece.commands();
    Optional<GuideRule> rule = rule(lines.get(0));
    boolean isShell = piece.kind().equals("sh") || lines.get(0).startsWith(PROGRAM + " ");
    if (!isShell && rule.isEmpty()) {
      checkOutput(piece);
      return;
    }
    StringBuilder script = new StringBuilder();
    for (String line : lines) {
      if (piece.kind().equals("sh") && !line.startsWith(PROGRAM)) {
        script.append(line).append('\n');
      } else {
        takeLine(line.replaceFirst("\\s+# .*", "").strip());
      }
    }
    if (!script.isEmpty() && use(rule).isEmpty()) {
      Shell said = shell.bash(script.toString());
      assertEquals(0, said.status(), said.out());
    }
  }

  private void takeLine(String line) throws Exception {
    Optional<GuideRule> rule = use(rule(line));
    boolean isProgram = line.startsWith(PROGRAM + " ");
    assertTrue(
        isProgram || rule.isPresent(), "'" + line + "' is not a command of simbad, and not listed");
    if (isProgram) {
      lastNamed = line;
      parse(line);
      if (rule.isEmpty() || (full && rule.get().way() == GuideRule.Way.LONG)) {
        typeOnce(line);
      }
    }
    if (rule.isPresent() && rule.get().way() == GuideRule.Way.TESTED) {
      rule.get().checkTest();
    }
  }

  /** What another page has as well is done already; in another environment it is something else. */
  private void typeOnce(String line) throws IOException {
    if (typed.containsKey(line) && shell.isPlain()) {
      return;
    }
    Shell said = shell.type(line.substring(PROGRAM.length() + 1));
    assertEquals(0, said.status(), line + ": " + said.err());
    typed.put(line, said);
  }

  private static void parse(String line) {
    String[] words = GuideShell.words(line.substring(PROGRAM.length() + 1));
    Main.commandLine(Subcommands.all()).parseArgs(words);
  }

  /** A line's own rule, or its page's. */
  private Optional<GuideRule> rule(String commented) {
    String line = commented.replaceFirst("\\s+# .*", "").strip();
    boolean isProgram = line.startsWith(PROGRAM + " ");
    return Stream.of(line, page)
        .flatMap(subject -> rules.stream().filter(rule -> rule.subject().equals(subject)))
        .filter(rule -> rule.way() != GuideRule.Way.SHOWN || !isProgram)
        .findFirst();
  }

  private Optional<GuideRule> use(Optional<GuideRule> rule) {
    rule.ifPresent(used::add);
    return rule;
  }

  /** A block that is no command is what the command that was named last prints. */
  private void checkOutput(GuidePiece piece) {
    Shell said = typed.get(lastNamed);
    if (said == null) {
      boolean isLater =
          rules.stream()
              .anyMatch(r -> r.way() == GuideRule.Way.LONG && r.subject().equals(lastNamed));
      assertTrue(
          isLater && !full,
          "is neither a command, nor listed, nor printed by a command that was typed: "
              + lastNamed);
      return;
    }
    List<String> printed = (said.out() + said.err()).lines().map(String::stripTrailing).toList();
    for (List<String> part : parts(piece.text())) {
      assertTrue(
          Collections.indexOfSubList(printed, part) >= 0,
          () ->
              lastNamed
                  + " does not print\n"
                  + String.join("\n", part)
                  + "\nbut\n"
                  + String.join("\n", printed));
    }
  }

  /** What stands between lines of dots. */
  private static List<List<String>> parts(String text) {
    List<List<String>> parts = new ArrayList<>(List.of(new ArrayList<>()));
    for (String line : text.stripTrailing().split("\n", -1)) {
      if (line.strip().equals(ELISION)) {
        parts.add(new ArrayList<>());
      } else {
        parts.get(parts.size() - 1).add(line.stripTrailing());
      }
    }
    return parts;
  }

  /** A file has the name that stands last before it. */
  private void save(GuidePiece piece) throws IOException {
    List<String> names =
        piece.names().stream().filter(name -> name.endsWith("." + piece.kind())).toList();
    assertTrue(!names.isEmpty(), "the words before this file do not say what it is called");
    Path name = Path.of(names.get(names.size() - 1));
    Path file = shell.folder().resolve(name);
    Files.createDirectories(Objects.requireNonNull(file.getParent()));
    Files.writeString(file, piece.text());
    saved.add(name);
  }

  /** A file is right when a command of the page takes it, or its folder. */
  private void checkIsUsed(Path name) {
    boolean isUsed =
        typed.keySet().stream()
            .flatMap(line -> Stream.of(GuideShell.words(line)))
            .anyMatch(word -> !word.isEmpty() && name.startsWith(Path.of(word)));
    assertTrue(isUsed, page + ": no command that is run takes " + name);
  }

  /** With the headers that the page's commands wrote; it must run as well. */
  private void compileC(String code) throws Exception {
    Files.writeString(shell.folder().resolve("guide.c"), code);
    String compiler = "gcc -std=c99 -Wall -Wextra -Werror -pedantic guide.c -lm -o guide 2>&1";
    Shell said = shell.bash(compiler + " && ./guide\n");
    assertEquals(0, said.status(), said.out());
  }

  private void compile(String code) throws IOException {
    Matcher name = CLASS.matcher(code);
    assertTrue(name.find(), "no class in this code");
    Path source = Files.writeString(shell.folder().resolve(name.group(1) + ".java"), code);
    ByteArrayOutputStream errors = new ByteArrayOutputStream();
    String[] words = {
      "-proc:none",
      "-cp",
      System.getProperty("java.class.path"),
      "-d",
      Files.createDirectories(shell.folder().resolve("compiled")).toString(),
      source.toString()
    };
    int status = ToolProvider.getSystemJavaCompiler().run(null, null, errors, words);
    assertEquals(0, status, errors.toString(StandardCharsets.UTF_8));
  }
}
