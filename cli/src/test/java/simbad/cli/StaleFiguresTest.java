package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** In a clone of its own, with two rooms and two figures. */
class StaleFiguresTest {
  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path clone;

  private void git(String... words) throws IOException, InterruptedException {
    List<String> command =
        new ArrayList<>(
            List.of(
                "git", "-C", clone.toString(), "-c", "user.name=Ada", "-c", "user.email=a@b.c"));
    command.addAll(List.of(words));
    Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
    process.getOutputStream().close();
    String said =
        new String(
            process.getInputStream().readAllBytes(), java.nio.charset.StandardCharsets.UTF_8);
    assertEquals(0, process.waitFor(), said);
  }

  private void write(String file, String text) throws IOException {
    Files.createDirectories(clone.resolve(file).getParent());
    Files.writeString(clone.resolve(file), text);
  }

  private Commit commit() throws IOException, InterruptedException {
    git("add", "-A");
    git("commit", "-qm", "More");
    return Commit.current(clone);
  }

  @BeforeEach
  void twoRooms_twoFigures() throws IOException, InterruptedException {
    git("init", "-q");
    write("gap/src/main/A.java", "a");
    write("gap/src/test/T.java", "t");
    write("firmware/f.c", "f");
    String first = commit().name();
    write(
        "docs/figures/origins.csv",
        "figure,commit,date,folders\n"
            + ("shrinkage," + first + ",2026-11-24,gap\n")
            + ("bench," + first + ",2026-11-24,firmware gap\n"));
    commit();
  }

  @Test
  void sameFiles_areNotStale() throws Exception {
    write("gap/src/test/T.java", "another test");
    write("README.md", "more words");
    assertEquals(List.of(), StaleFigures.of(commit()));
  }

  @Test
  void whatDependsOnAChangedRoom_isStale() throws Exception {
    String first = Commit.current(clone).name();
    write("firmware/f.c", "another program");
    List<String> stale = StaleFigures.of(commit());
    assertEquals(1, stale.size(), stale.toString());
    assertEquals("bench", stale.get(0).split(" ", -1)[0], "measured before " + first);
  }

  /** Motion is no part of what readings are diagnosed with. */
  @Test
  void whatAFigureLeavesOut_mayChange() throws Exception {
    String first = Commit.current(clone).name();
    write(
        "docs/figures/origins.csv",
        "figure,commit,date,folders\nsrb1-L1," + first + ",2026-11-24,gap !gap/src/main/motion\n");
    write("gap/src/main/motion/M.java", "m");
    assertEquals(List.of(), StaleFigures.of(commit()));
    write("gap/src/main/A.java", "b");
    assertEquals(List.of("srb1-L1 (" + first + ")"), StaleFigures.of(commit()));
  }

  @Test
  void unknownCommit_isStale() throws Exception {
    write(
        "docs/figures/origins.csv",
        "figure,commit,date,folders\nbench,0123456789,2026-11-24,gap\n");
    assertEquals(List.of("bench (0123456789)"), StaleFigures.of(commit()));
  }

  @Test
  void projectWithoutFigures_hasNoneThatAreStale() throws Exception {
    Files.delete(clone.resolve("docs/figures/origins.csv"));
    assertEquals(List.of(), StaleFigures.of(commit()));
  }
}
