package simbad.cli.machine;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;

/** What works on a machine, and what to install for the rest. Installs and builds nothing. */
public final class Doctor {
  private final Machine machine;
  private final Consumer<String> out;
  private final Set<String> wanted = new TreeSet<>();

  private Doctor(Machine machine, Consumer<String> out) {
    this.machine = machine;
    this.out = out;
  }

  /**
   * Says line by line what works.
   *
   * @param machine that is looked at
   * @param out told each line
   * @return whether the program can be built and run
   * @throws IOException if the project's list of packages cannot be read
   * @throws InterruptedException if the thread is interrupted meanwhile
   */
  public static boolean examine(Machine machine, Consumer<String> out)
      throws IOException, InterruptedException {
    return new Doctor(machine, out).examine();
  }

  private boolean examine() throws IOException, InterruptedException {
    examineJava();
    boolean works = has(Purpose.BUILD, "builds the program");
    works &= has(Purpose.RUN, "runs it");
    has(Purpose.WINDOW, "windows and OpenGL: view, demo");
    examineDisplay();
    has(Purpose.BOARD, "the simulated board: board, bench capture --auto");
    examinePorts();
    has(Purpose.TEST, "all tests");
    if (!wanted.isEmpty()) {
      out.accept("To have all of it: " + machine.installLine(wanted));
    }
    return works;
  }

  private void finding(String word, String what, String more) {
    out.accept(String.format(Locale.ROOT, "%-8s %-8s %s", word, what, more));
  }

  private boolean has(Purpose purpose, String more) throws IOException, InterruptedException {
    Set<String> missing = machine.missing(purpose);
    finding(missing.isEmpty() ? "ok" : "missing", purpose.word(), more);
    if (!missing.isEmpty()) {
      finding("", "", "install: " + String.join(" ", missing));
    }
    wanted.addAll(missing);
    return missing.isEmpty();
  }

  private void examineJava() {
    boolean compiles = Files.exists(machine.java().resolve("bin").resolve("javac"));
    finding(
        compiles ? "ok" : "partly",
        "java",
        machine.javaVersion()
            + (compiles ? " with" : " without")
            + " a compiler, in "
            + machine.java());
  }

  private void examineDisplay() {
    String display = machine.environment().getOrDefault("DISPLAY", "");
    if (display.isEmpty()) {
      finding(
          "none",
          "display",
          "no window can open; commands without one work, and ./simbad test brings its own (Xvfb)");
    } else {
      finding("ok", "display", display);
    }
  }

  private void examinePorts() throws IOException {
    List<Path> ports = new ArrayList<>();
    Path devices = machine.directory("DEVICE", "/dev");
    try (DirectoryStream<Path> found = Files.newDirectoryStream(devices, "tty{USB,ACM}*")) {
      found.forEach(ports::add);
    }
    Collections.sort(ports);
    for (Path port : ports) {
      if (Files.isReadable(port) && Files.isWritable(port)) {
        finding("ok", "serial", port.toString());
      } else {
        String line = "sudo usermod -aG dialout $USER";
        finding(
            "denied",
            "serial",
            port + ": for the right to it type: " + line + ", then log in again");
      }
    }
    if (ports.isEmpty()) {
      finding(
          "none",
          "serial",
          "no adapter is plugged in (a real board needs one, the simulated one does not)");
    }
  }
}
