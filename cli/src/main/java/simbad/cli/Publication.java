package simbad.cli;

import java.io.IOException;
import java.io.StringReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Properties;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * What a publication says of itself: of build-config/publication.properties, which is empty until
 * somebody publishes.
 *
 * @param values by key
 * @param version of the project
 */
record Publication(Map<String, String> values, String version) {
  /** Where it stands in the project. */
  static final String FILE = "build-config/publication.properties";

  private static final List<String> KEYS =
      List.of("url", "scm.url", "scm.connection", "developer.name", "developer.contact");
  private static final Pattern VERSION = Pattern.compile("(?m)^  <version>(.*)</version>$");
  private static final String LICENCES = "  </licenses>\n";
  private static final String OWNER =
      """
        <url>%s</url>
        <developers>
          <developer>
            <name>%s</name>
            <url>%s</url>
          </developer>
        </developers>
        <scm>
          <url>%s</url>
          <connection>%s</connection>
        </scm>
      """;
  private static final String TITLE = "Simbad Sonar";
  private static final String ABSTRACT =
      "A robot simulator, source-compatible with Simbad, whose sonar detects what a real SRF04"
          + " detects; the bench that measures it; and a diagnosis of where simulation and reality"
          + " part.";

  /** Copies the values. */
  Publication {
    values = Map.copyOf(values);
  }

  /**
   * Reads the project's.
   *
   * @throws IOException if a file cannot be read, or has a key that means nothing
   */
  static Publication read(Path project) throws IOException {
    Path file = project.resolve(FILE);
    Properties properties = new Properties();
    properties.load(new StringReader(Files.readString(file)));
    Map<String, String> values = new TreeMap<>();
    for (String key : properties.stringPropertyNames()) {
      if (!KEYS.contains(key)) {
        throw new IOException(file + ": " + key + " is not one of " + String.join(", ", KEYS));
      }
      values.put(key, properties.getProperty(key).strip());
    }
    return new Publication(values, version(project));
  }

  /**
   * Returns the version that the project's pom states.
   *
   * @throws IOException if it states none
   */
  static String version(Path project) throws IOException {
    Path pom = project.resolve("pom.xml");
    Matcher version = VERSION.matcher(Files.readString(pom));
    if (!version.find()) {
      throw new IOException(pom + ": has no line with the project's version");
    }
    return version.group(1);
  }

  private String value(String key) {
    return values.getOrDefault(key, "");
  }

  /** Returns the keys that nobody has filled. */
  List<String> missing() {
    return KEYS.stream().filter(key -> value(key).isEmpty()).toList();
  }

  boolean isSnapshot() {
    return version.endsWith("-SNAPSHOT");
  }

  /**
   * Returns a parent pom with what repositories want to know in it.
   *
   * @param pom that has licences and none of it
   */
  String filled(String pom) {
    if (!pom.contains(LICENCES)) {
      throw new IllegalArgumentException("the pom has no line " + LICENCES.strip());
    }
    return pom.replace(
        LICENCES,
        LICENCES
            + OWNER.formatted(
                xml("url"),
                xml("developer.name"),
                xml("developer.contact"),
                xml("scm.url"),
                xml("scm.connection")));
  }

  private String xml(String key) {
    return value(key).replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;");
  }

  private static String quoted(String text) {
    return '"' + text.replace("\\", "\\\\").replace("\"", "\\\"") + '"';
  }

  private String author() {
    return value("developer.name").isEmpty() ? "The authors of " + TITLE : value("developer.name");
  }

  /** Returns CITATION.cff, format 1.2.0. */
  String citation() {
    StringBuilder text =
        new StringBuilder("cff-version: 1.2.0\n")
            .append("message: \"If you use this software, please cite it as below.\"\n")
            .append("type: software\n")
            .append("title: ")
            .append(quoted(TITLE))
            .append('\n')
            .append("abstract: ")
            .append(quoted(ABSTRACT))
            .append('\n')
            .append("authors:\n  - name: ")
            .append(quoted(author()))
            .append('\n')
            .append("license: GPL-3.0-or-later\n")
            .append("version: ")
            .append(quoted(version))
            .append('\n');
    add(text, "url: ", value("url"), "\n");
    add(text, "repository-code: ", value("scm.url"), "\n");
    return text.toString();
  }

  /** Returns codemeta.json, CodeMeta 3.0. */
  String codemeta() {
    StringBuilder text =
        new StringBuilder("{\n")
            .append("  \"@context\": \"https://w3id.org/codemeta/3.0\",\n")
            .append("  \"@type\": \"SoftwareSourceCode\",\n")
            .append("  \"name\": ")
            .append(quoted(TITLE))
            .append(",\n")
            .append("  \"description\": ")
            .append(quoted(ABSTRACT))
            .append(",\n")
            .append("  \"author\": [{\"@type\": \"Organization\", \"name\": ")
            .append(quoted(author()))
            .append("}],\n")
            .append("  \"license\": \"https://spdx.org/licenses/GPL-3.0-or-later\",\n")
            .append("  \"programmingLanguage\": [\"Java\", \"C\", \"Python\"],\n");
    add(text, "  \"url\": ", value("url"), ",\n");
    add(text, "  \"codeRepository\": ", value("scm.url"), ",\n");
    return text.append("  \"version\": ").append(quoted(version)).append("\n}\n").toString();
  }

  private static void add(StringBuilder text, String key, String value, String end) {
    if (!value.isEmpty()) {
      text.append(key).append(quoted(value)).append(end);
    }
  }

  /** What is said of what is missing. */
  String complaint() {
    String keys = missing().stream().collect(Collectors.joining(", "));
    return FILE
        + ": "
        + keys
        + (missing().size() == 1 ? " is" : " are")
        + " empty, expected what a repository says about the project";
  }
}
