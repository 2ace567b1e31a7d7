package simbad.bench.board;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.abort;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

/**
 * Runs the firmware's own checks, whose lines say {@code ok NAME}, {@code not ok NAME: why} or
 * {@code skip NAME: why}.
 */
class FirmwareTest {
  @TestFactory
  Stream<DynamicTest> firmware() throws IOException, InterruptedException {
    Process script =
        new ProcessBuilder("bash", Path.of("..", "firmware-pic18", "check").toString())
            .redirectErrorStream(true)
            .start();
    script.getOutputStream().close();
    String output = new String(script.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    int status = script.waitFor();
    List<String> checks =
        output.lines().filter(line -> line.matches("(ok|not ok|skip) .*")).toList();
    return Stream.concat(
        Stream.of(
            DynamicTest.dynamicTest(
                "the checks ran to their end",
                () -> {
                  assertTrue(checks.size() >= 5, output);
                  assertEquals(0, status, output);
                })),
        checks.stream()
            .map(check -> DynamicTest.dynamicTest(name(check), () -> judge(check, output))));
  }

  private static String name(String check) {
    return check.replaceFirst("^(ok|not ok|skip) ", "").replaceFirst(": (missing|no) .*", "");
  }

  private static void judge(String check, String output) {
    if (check.startsWith("skip ")) {
      abort(check);
    }
    assertTrue(check.startsWith("ok "), output);
  }
}
