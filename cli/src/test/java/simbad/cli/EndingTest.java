package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine.Command;

/** Who is told to end (Ctrl-C) does what is left to do, and says nothing of what that took away. */
class EndingTest {
  /** Goes on as soon as the process is told to end, which then takes a while. */
  static final class Released {
    private Released() {}

    public static void main(String... way) throws Exception {
      CountDownLatch ended = new CountDownLatch(1);
      Ending ending =
          Ending.with(
              () -> {
                ended.countDown();
                sleep();
                System.out.println("tidied up");
              });
      System.out.println("stands by");
      ended.await();
      switch (way[0]) {
        case "close" -> ending.close();
        case "another" -> Ending.with(() -> System.out.println("done at once"));
        default -> fail(way[0]);
      }
      System.out.println("went on");
    }

    private static void sleep() {
      try {
        TimeUnit.MILLISECONDS.sleep(500);
      } catch (InterruptedException e) {
        throw new IllegalStateException(e);
      }
    }

    private static void fail(String why) {
      PrintWriter out = new PrintWriter(System.out, true, StandardCharsets.UTF_8);
      Main.run(List.of(new Failing()), out, out, why);
    }
  }

  @Command(name = "complain", description = "Fails.")
  private static final class Failing extends Subcommand {
    @Override
    protected void run() throws IOException {
      throw new IOException("the folder is gone");
    }
  }

  private static List<String> said(String way) throws Exception {
    Process process =
        new ProcessBuilder(SimbadProcess.java(Released.class.getName(), way))
            .redirectErrorStream(true)
            .start();
    try (BufferedReader output = process.inputReader()) {
      assertEquals("stands by", output.readLine());
      // The way of Ctrl-C; a parent that ignores that signal would hand it on.
      process.toHandle().destroy();
      List<String> rest = output.lines().toList();
      assertTrue(process.waitFor(1, TimeUnit.MINUTES));
      assertEquals(128 + 15, process.exitValue());
      return rest;
    } finally {
      process.destroyForcibly();
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"close", "complain"})
  void processThatEnds_goesNoFurther(String way) throws Exception {
    assertEquals(List.of("tidied up"), said(way));
  }

  @Test
  void workThatIsLeftWhileItEnds_isDoneAtOnce() throws Exception {
    assertEquals(List.of("done at once", "tidied up"), said("another"));
  }
}
