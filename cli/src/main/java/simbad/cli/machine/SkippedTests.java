package simbad.cli.machine;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;

/** Tests that were skipped: where continuous integration has all tools, none may be. */
final class SkippedTests {
  private SkippedTests() {}

  /**
   * Returns their names, CLASS.METHOD, from the reports of Surefire.
   *
   * @param project folder of the project
   * @param begun reports from before do not count
   */
  static List<String> since(Path project, Instant begun) throws IOException {
    List<String> skipped = new ArrayList<>();
    try (Stream<Path> rooms = Files.list(project)) {
      for (Path room : rooms.sorted().toList()) {
        Path reports = room.resolve("target").resolve("surefire-reports");
        if (Files.isDirectory(reports)) {
          addFrom(reports, begun, skipped);
        }
      }
    }
    return skipped;
  }

  private static void addFrom(Path reports, Instant begun, List<String> skipped)
      throws IOException {
    try (Stream<Path> files = Files.list(reports)) {
      for (Path file : files.sorted().toList()) {
        boolean isReport = file.getFileName().toString().matches("TEST-.*\\.xml");
        if (isReport && Files.getLastModifiedTime(file).toInstant().isAfter(begun)) {
          addFrom(file, skipped);
        }
      }
    }
  }

  private static void addFrom(Path report, List<String> skipped) throws IOException {
    XMLInputFactory factory = XMLInputFactory.newDefaultFactory();
    factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
    try (InputStream bytes = Files.newInputStream(report)) {
      XMLStreamReader reader = factory.createXMLStreamReader(bytes);
      String test = "";
      while (reader.hasNext()) {
        String element =
            reader.next() == XMLStreamReader.START_ELEMENT ? reader.getLocalName() : "";
        if (element.equals("testcase")) {
          test = attribute(reader, "classname") + "." + attribute(reader, "name");
        } else if (element.equals("skipped")) {
          skipped.add(test);
        }
      }
    } catch (XMLStreamException e) {
      throw new IOException(report + ": not a report of tests: " + e.getMessage(), e);
    }
  }

  private static String attribute(XMLStreamReader reader, String name) {
    return String.valueOf(reader.getAttributeValue(null, name));
  }
}
