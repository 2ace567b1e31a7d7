package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

/** Runs the launcher's own test script, whose lines say {@code ok NAME} or {@code not ok NAME}. */
class LauncherTest {
  @TestFactory
  Stream<DynamicTest> launcher() throws IOException, InterruptedException {
    ProcessBuilder builder =
        new ProcessBuilder("bash", Path.of("..", "build-config", "launcher-test.sh").toString())
            .redirectErrorStream(true);
    builder.environment().put("JAVA_HOME", System.getProperty("java.home"));
    builder.environment().put("SIMBAD_TEST_CLASS_PATH", System.getProperty("java.class.path"));
    ManagementFactory.getRuntimeMXBean().getInputArguments().stream()
        .filter(argument -> argument.startsWith("-javaagent:"))
        .findFirst()
        .ifPresent(agent -> builder.environment().put("SIMBAD_TEST_AGENT", agent));
    Process script = builder.start();
    script.getOutputStream().close();
    String output = new String(script.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    int status = script.waitFor();
    List<String> checks = output.lines().filter(line -> line.matches("(not )?ok .*")).toList();
    return Stream.concat(
        Stream.of(
            DynamicTest.dynamicTest(
                "the script ran to its end",
                () -> {
                  assertTrue(checks.size() >= 20, output);
                  assertEquals(0, status, output);
                })),
        checks.stream()
            .map(
                check ->
                    DynamicTest.dynamicTest(
                        check.replaceFirst("^(not )?ok ", ""),
                        () -> assertTrue(check.startsWith("ok "), output))));
  }
}
