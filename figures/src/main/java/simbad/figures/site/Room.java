package simbad.figures.site;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;
import org.w3c.dom.Element;
import org.w3c.dom.Node;
import org.xml.sax.SAXException;

/**
 * A module of the project, as its pom has it.
 *
 * @param name its artifact
 * @param description what it says of itself
 * @param uses the project's other modules that it names, test scope left out
 */
record Room(String name, String description, List<Use> uses) {
  /**
   * Uses another room.
   *
   * @param room its name
   * @param asProcess true when no class of it may be named, only a program of it started
   */
  record Use(String room, boolean asProcess) {}

  Room {
    uses = List.copyOf(uses);
  }

  /** The modules that the parent pom lists, in its order. */
  static List<Room> readAll(Path project) throws IOException {
    List<Room> rooms = new ArrayList<>();
    Element parent = read(project.resolve("pom.xml"));
    for (Element modules : children(parent, "modules")) {
      for (Element module : children(modules, "module")) {
        rooms.add(of(read(project.resolve(module.getTextContent()).resolve("pom.xml"))));
      }
    }
    return rooms;
  }

  private static Element read(Path pom) throws IOException {
    try {
      return DocumentBuilderFactory.newInstance()
          .newDocumentBuilder()
          .parse(pom.toFile())
          .getDocumentElement();
    } catch (SAXException | ParserConfigurationException e) {
      throw new IOException(pom + ": " + e.getMessage(), e);
    }
  }

  private static Room of(Element pom) {
    List<Use> uses = new ArrayList<>();
    for (Element dependencies : children(pom, "dependencies")) {
      for (Element dependency : children(dependencies, "dependency")) {
        String scope = text(dependency, "scope");
        if (text(dependency, "groupId").equals("${project.groupId}") && !scope.equals("test")) {
          uses.add(new Use(text(dependency, "artifactId"), scope.equals("runtime")));
        }
      }
    }
    return new Room(text(pom, "artifactId"), text(pom, "description"), uses);
  }

  private static List<Element> children(Element parent, String name) {
    List<Element> found = new ArrayList<>();
    for (Node at = parent.getFirstChild(); at != null; at = at.getNextSibling()) {
      if (at instanceof Element element && element.getTagName().equals(name)) {
        found.add(element);
      }
    }
    return found;
  }

  private static String text(Element parent, String name) {
    return String.join("", children(parent, name).stream().map(Element::getTextContent).toList());
  }

  /** The uses of a room that do not follow from others: what a used room uses is not named anew. */
  static List<Use> drawn(Room room, List<Room> rooms) {
    Predicate<Use> follows =
        use ->
            room.uses().stream()
                .filter(other -> !other.room().equals(use.room()))
                .anyMatch(other -> reaches(other.room(), use.room(), rooms));
    return room.uses().stream().filter(follows.negate()).toList();
  }

  private static boolean reaches(String from, String to, List<Room> rooms) {
    return rooms.stream()
        .filter(room -> room.name().equals(from))
        .flatMap(room -> room.uses().stream())
        .anyMatch(use -> use.room().equals(to) || reaches(use.room(), to, rooms));
  }

  /** The description in lines of so many letters at most. */
  List<String> lines(int letters) {
    List<String> lines = new ArrayList<>();
    String line = "";
    for (String word : description.split(" ", -1)) {
      if (!line.isEmpty() && line.length() + 1 + word.length() > letters) {
        lines.add(line);
        line = word;
      } else {
        line = line.isEmpty() ? word : line + " " + word;
      }
    }
    lines.add(line);
    return lines;
  }
}
