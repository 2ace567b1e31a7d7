package simbad.figures.site;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RoomDiagramTest {
  private static final Path PROJECT = Path.of("..");

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  private void write(String room, String... dependencies) throws IOException {
    StringBuilder pom = new StringBuilder("<project><artifactId>" + room + "</artifactId>");
    pom.append("<description>It is &lt; 1.</description><dependencies>");
    for (String dependency : dependencies) {
      String[] parts = dependency.split(":", -1);
      pom.append("<dependency><groupId>${project.groupId}</groupId>")
          .append("<artifactId>" + parts[0] + "</artifactId>")
          .append(parts.length > 1 ? "<scope>" + parts[1] + "</scope>" : "")
          .append("</dependency>");
    }
    pom.append("<dependency><groupId>org.other</groupId><artifactId>lib</artifactId></dependency>");
    Files.createDirectories(folder.resolve(room));
    Files.writeString(
        folder.resolve(room).resolve("pom.xml"), pom.append("</dependencies></project>"));
  }

  private void list(String... rooms) throws IOException {
    Files.writeString(
        folder.resolve("pom.xml"),
        "<project><modules><module>"
            + String.join("</module><module>", rooms)
            + "</module></modules></project>");
  }

  private static List<String> arrows(String svg) {
    return Pattern.compile("<path class=\"([a-z ]+)\".*?<title>(.*?)</title>")
        .matcher(svg)
        .results()
        .map(found -> found.group(2) + (found.group(1).equals("use") ? "" : " as a process"))
        .toList();
  }

  /** Who gives a room another dependency and draws nothing anew learns of it here. */
  @Test
  void picture_isWhatThePomsSay() throws IOException {
    assertEquals(
        RoomDiagram.svg(PROJECT), Files.readString(PROJECT.resolve("docs/pictures/rooms.svg")));
  }

  @Test
  void picture_isWellFormed() throws Exception {
    String svg = RoomDiagram.svg(PROJECT);
    DocumentBuilderFactory.newInstance()
        .newDocumentBuilder()
        .parse(new ByteArrayInputStream(svg.getBytes(StandardCharsets.UTF_8)));
  }

  @Test
  void arrows_areDependencies_lessThoseThatFollow() throws IOException {
    list("sonar-model", "simbad-core", "obstacles", "blind-world");
    write("sonar-model", "bench:test");
    write("simbad-core", "sonar-model");
    write("obstacles", "sonar-model", "simbad-core", "blind-world:runtime");
    write("blind-world");
    assertEquals(
        List.of(
            "simbad-core uses sonar-model",
            "obstacles uses simbad-core",
            "obstacles uses blind-world as a process"),
        arrows(RoomDiagram.svg(folder)));
  }

  @Test
  void roomWithoutAPlace_isNamed() throws IOException {
    list("attic");
    write("attic");
    IOException fault = assertThrows(IOException.class, () -> RoomDiagram.svg(folder));
    assertEquals("attic: RoomDiagram has no place for this room", fault.getMessage());
  }

  @Test
  void lines_areAtMostAsLongAsAsked() {
    Room room = new Room("a", "one two three fourteen", List.of());
    assertEquals(List.of("one two", "three", "fourteen"), room.lines(8));
  }
}
