package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.Document;
import simbad.cli.machine.Launcher;

class PublicationTest {
  private static final Path PROJECT = Path.of("..");
  private static final Publication FULL =
      new Publication(
          Map.of(
              "url", "https://example.org/sonar?a&b",
              "scm.url", "https://example.org/sonar/src",
              "scm.connection", "scm:git:https://example.org/sonar.git",
              "developer.name", "Ada \"the\" Example",
              "developer.contact", "https://example.org/ada"),
          "1.2.3");

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  /** ./simbad docs --figures writes both anew. */
  @Test
  void filesOfTheProject_areMadeOfTheOneFile() throws Exception {
    Publication publication = Publication.read(PROJECT);
    assertEquals(publication.citation(), Files.readString(PROJECT.resolve("CITATION.cff")));
    assertEquals(publication.codemeta(), Files.readString(PROJECT.resolve("codemeta.json")));
  }

  @Test
  void citationAndCodemeta_agree() throws Exception {
    JsonNode codemeta = new ObjectMapper().readTree(FULL.codemeta());
    String citation = FULL.citation();
    assertTrue(citation.contains("title: \"" + codemeta.get("name").asText() + "\""));
    assertTrue(citation.contains("version: \"" + codemeta.get("version").asText() + "\""));
    assertTrue(citation.contains("url: \"" + codemeta.get("url").asText() + "\""));
    assertTrue(
        citation.contains("repository-code: \"" + codemeta.get("codeRepository").asText() + "\""));
    assertEquals("Ada \"the\" Example", codemeta.at("/author/0/name").asText());
    assertTrue(citation.contains("- name: \"Ada \\\"the\\\" Example\""), citation);
  }

  @Test
  void whatIsEmpty_isLeftOut() {
    Publication empty = new Publication(Map.of("url", ""), "1");
    assertFalse(empty.citation().contains("url"));
    assertFalse(empty.codemeta().contains("\"url\""));
    assertEquals(5, empty.missing().size());
    assertTrue(empty.complaint().startsWith(Publication.FILE + ": url, scm.url"));
  }

  @Test
  void pom_isFilled() throws Exception {
    String pom = FULL.filled(Files.readString(PROJECT.resolve("pom.xml")));
    Document document =
        DocumentBuilderFactory.newInstance()
            .newDocumentBuilder()
            .parse(new ByteArrayInputStream(pom.getBytes(StandardCharsets.UTF_8)));
    for (String needed : List.of("url", "licenses", "developers", "scm", "name", "description")) {
      assertTrue(
          document.getElementsByTagName(needed).getLength() > 0, needed + " is not in the pom");
    }
    assertTrue(pom.contains("<url>https://example.org/sonar?a&amp;b</url>"));
  }

  @Test
  void unknownKey_isRefused() throws Exception {
    Files.createDirectories(folder.resolve("build-config"));
    Files.writeString(folder.resolve(Publication.FILE), "urll=x\n");
    IOException thrown = assertThrows(IOException.class, () -> Publication.read(folder));
    assertTrue(String.valueOf(thrown.getMessage()).contains("urll is not one of url"));
  }

  /** Until somebody fills the file. */
  @Test
  void release_refusesToPublishWhatSaysNotWhoseItIs() throws Exception {
    Path project = folder.resolve("project");
    Files.createDirectories(project.resolve("build-config"));
    Files.copy(PROJECT.resolve("pom.xml"), project.resolve("pom.xml"));
    Files.writeString(project.resolve(Publication.FILE), "url=\n");
    git(project, "init", "-q");
    git(project, "add", ".");
    git(project, "-c", "user.name=a", "-c", "user.email=a@example.org", "commit", "-qm", "x");
    Launcher launcher = new Launcher(project.resolve("simbad"));
    Release release = Release.of(launcher, line -> {});
    UnpublishableException thrown =
        assertThrows(UnpublishableException.class, () -> release.writeRepository(folder, false));
    assertTrue(String.valueOf(thrown.getMessage()).contains("scm.url"), thrown.getMessage());
  }

  private static void git(Path directory, String... words) throws Exception {
    String[] command = new String[words.length + 1];
    command[0] = "git";
    System.arraycopy(words, 0, command, 1, words.length);
    Process process = new ProcessBuilder(command).directory(directory.toFile()).start();
    assertEquals(0, process.waitFor(), String.join(" ", command));
  }
}
