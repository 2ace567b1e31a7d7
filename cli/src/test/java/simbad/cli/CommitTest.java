package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What differs from a commit, and whether the program differs. */
class CommitTest {
  @TempDir private Path clone = Path.of("");

  private void git(String... words) throws Exception {
    List<String> command =
        new ArrayList<>(
            List.of(
                "git", "-C", clone.toString(), "-c", "user.name=Ada", "-c", "user.email=a@b.c"));
    command.addAll(List.of(words));
    Process process = new ProcessBuilder(command).inheritIO().start();
    assertEquals(0, process.waitFor(), command.toString());
  }

  private void write(String name, String text) throws Exception {
    Path file = clone.resolve(name);
    Files.createDirectories(file.getParent());
    Files.writeString(file, text);
  }

  @Test
  void filesThatTheProgramIsNotBuiltOf_makeNoOtherProgram() throws Exception {
    git("init", "-q");
    write("pom.xml", "a");
    write("gap/pom.xml", "a");
    write("gap/src/main/java/A.java", "a");
    write("gap/src/test/java/ATest.java", "a");
    write("docs/guide/a.md", "a");
    git("add", ".");
    git("commit", "-q", "-m", "a");
    Commit commit = Commit.current(clone);
    assertEquals(0, commit.changes());
    write("notes.txt", "b");
    write("my-jar/simbad.jar", "b");
    write("docs/guide/a.md", "b");
    write("gap/src/test/java/ATest.java", "b");
    assertEquals(4, commit.changes());
    assertEquals(0, commit.changesOfProgram());
    write("gap/src/main/java/B.java", "b");
    assertEquals(1, commit.changesOfProgram());
    write("gap/pom.xml", "b");
    assertEquals(2, commit.changesOfProgram());
  }
}
