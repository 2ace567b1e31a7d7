package simbad.cli.machine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SkippedTestsTest {
  private static final Instant BEGUN = Instant.parse("2026-01-02T03:04:05Z");

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path project;

  private void report(String room, String name, int secondsAfter, String cases) throws IOException {
    Path reports =
        Files.createDirectories(project.resolve(room).resolve("target/surefire-reports"));
    Path file = reports.resolve(name);
    Files.writeString(file, "<testsuite name=\"s\">" + cases + "</testsuite>");
    Files.setLastModifiedTime(file, FileTime.from(BEGUN.plusSeconds(secondsAfter)));
  }

  @Test
  void skippedOnes_areNamed_inTheOrderOfRoomsAndReports() throws IOException {
    report("b", "TEST-p.C.xml", 1, "<testcase classname='p.C' name='m'><skipped/></testcase>");
    report(
        "a",
        "TEST-p.B.xml",
        1,
        "<testcase classname='p.B' name='ran'/>"
            + "<testcase classname='p.B' name='left[1]'><skipped message='no tool'/></testcase>"
            + "<testcase classname='p.B' name='failed'><failure>skipped</failure></testcase>");
    Files.createDirectories(project.resolve("docs"));
    assertEquals(List.of("p.B.left[1]", "p.C.m"), SkippedTests.since(project, BEGUN));
  }

  @Test
  void reportsFromBefore_andOtherFiles_doNotCount() throws IOException {
    String skipped = "<testcase classname='p.C' name='m'><skipped/></testcase>";
    report("a", "TEST-p.Old.xml", -1, skipped);
    report("a", "p.C.txt", 1, skipped);
    assertEquals(List.of(), SkippedTests.since(project, BEGUN));
  }

  @Test
  void tornReport_isNamed() throws IOException {
    report("a", "TEST-p.C.xml", 1, "<testcase");
    IOException fault = assertThrows(IOException.class, () -> SkippedTests.since(project, BEGUN));
    assertTrue(
        String.valueOf(fault.getMessage()).contains("TEST-p.C.xml: not a report of tests"),
        fault.getMessage());
  }
}
