package simbad.cli;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.lang.ProcessBuilder.Redirect;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A folder in which somebody types what pages say. One process takes all lines, because starting
 * one for each takes longer than most of them.
 */
final class GuideShell implements AutoCloseable {
  private static final Pattern WORD =
      Pattern.compile("(?:[^\\s\"']|\"[^\"]*\"|'[^']*')+"); // a"b c"d is one word
  private static final Pattern EXPORT = Pattern.compile("(?m)^export (\\w+)=(\\S*)$");
  private static final String PROJECT_CLASS_PATH = "cli/target/cli.jar:cli/target/lib/*";

  private static final Path PROJECT = Path.of("..");

  private final Path folder;
  private final List<Path> links = new ArrayList<>();
  private final Map<String, String> environment = new HashMap<>();
  private final ObjectMapper json = new ObjectMapper();
  private Optional<Process> typist = Optional.empty();
  private Optional<BufferedReader> answers = Optional.empty();

  private GuideShell(Path folder) {
    this.folder = folder;
  }

  /** In a folder, in which files of the project seem to lie where they are in the project. */
  static GuideShell in(Path folder, Path... shown) throws IOException {
    GuideShell shell = new GuideShell(folder);
    for (Path file : shown) {
      Path link = folder.resolve(PROJECT.relativize(file));
      shell.links.add(Files.createSymbolicLink(link, file.toRealPath()));
    }
    return shell;
  }

  Path folder() {
    return folder;
  }

  /** The words of a line as a shell takes them. */
  static String[] words(String line) {
    return WORD.matcher(line)
        .results()
        .map(word -> word.group().replaceAll("[\"']", ""))
        .toArray(String[]::new);
  }

  /** Types a line for the program, its first word left off. */
  Shell type(String line) throws IOException {
    Process process = typist.isPresent() ? typist.get() : start();
    process
        .getOutputStream()
        .write((json.writeValueAsString(words(line)) + "\n").getBytes(StandardCharsets.UTF_8));
    process.getOutputStream().flush();
    String answer = answers.orElseThrow().readLine();
    if (answer == null) {
      throw new IOException(line + ": the program ended");
    }
    String[] said = json.readValue(answer, String[].class);
    return new Shell(Integer.parseInt(said[0]), said[1], said[2]);
  }

  private Process start() throws IOException {
    List<String> command = new ArrayList<>(List.of(tool("java"), "-Djava.awt.headless=true"));
    command.addAll(List.of("-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1"));
    command.addAll(List.of("-Dsimbad.home=" + PROJECT.toRealPath(), "-cp", classPath()));
    command.add(GuideTypist.class.getName());
    ProcessBuilder builder = builder(command).redirectError(Redirect.INHERIT);
    Process process = builder.start();
    typist = Optional.of(process);
    answers = Optional.of(process.inputReader(StandardCharsets.UTF_8));
    return process;
  }

  /** As the launcher has it. */
  private String classPath() {
    String own = environment.getOrDefault("SIMBAD_CLASS_PATH", "");
    return System.getProperty("java.class.path") + (own.isEmpty() ? "" : File.pathSeparator + own);
  }

  private static String tool(String name) {
    return Path.of(System.getProperty("java.home"), "bin", name).toString();
  }

  private ProcessBuilder builder(List<String> command) {
    ProcessBuilder builder = new ProcessBuilder(command).directory(folder.toFile());
    Map<String, String> variables = builder.environment();
    variables.put("PATH", Path.of(tool("java")).getParent() + ":" + variables.get("PATH"));
    variables.putAll(environment);
    return builder;
  }

  /** Runs lines for bash; what they export holds from then on. Returns status and output. */
  Shell bash(String script) throws IOException, InterruptedException {
    String text = script.replace(PROJECT_CLASS_PATH, System.getProperty("java.class.path"));
    Path said = Files.createTempFile("said", ".txt");
    Process process =
        builder(List.of("bash", "-euc", text))
            .redirectErrorStream(true)
            .redirectOutput(said.toFile())
            .start();
    int status = process.waitFor();
    Matcher exports = EXPORT.matcher(script);
    while (exports.find()) {
      environment.put(exports.group(1), exports.group(2));
      end();
    }
    Shell shell = new Shell(status, Files.readString(said), "");
    Files.delete(said);
    return shell;
  }

  /** Whether nothing was exported. */
  boolean isPlain() {
    return environment.isEmpty();
  }

  /** As if the terminal were opened anew: what was exported is gone. */
  void forget() throws IOException {
    if (!environment.isEmpty()) {
      environment.clear();
      end();
    }
  }

  @Override
  public void close() throws IOException {
    end();
    for (Path link : links) {
      Files.delete(link);
    }
  }

  private void end() throws IOException {
    if (typist.isPresent()) {
      Process process = typist.get();
      process.getOutputStream().close();
      try {
        process.waitFor(1, TimeUnit.MINUTES);
      } catch (InterruptedException interrupted) {
        Thread.currentThread().interrupt();
      }
      process.destroyForcibly();
      typist = Optional.empty();
    }
  }
}
