package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simbad.obstacles.Catalogue;

/** What would be published, put into a folder, and a plain project that takes it from there. */
@Tag("full")
class PublishTest {
  private static final String VERSION = "0.0.1";

  private static final String CONSUMER =
      """
      <project xmlns="http://maven.apache.org/POM/4.0.0">
        <modelVersion>4.0.0</modelVersion>
        <groupId>example</groupId>
        <artifactId>consumer</artifactId>
        <version>1</version>
        <properties>
          <maven.compiler.source>17</maven.compiler.source>
          <maven.compiler.target>17</maven.compiler.target>
          <project.build.sourceEncoding>UTF-8</project.build.sourceEncoding>
        </properties>
        <repositories>
          <repository>
            <id>folder</id>
            <url>REPOSITORY</url>
          </repository>
        </repositories>
        <dependencyManagement>
          <dependencies>
            <dependency>
              <groupId>io.github.simbadsonar</groupId>
              <artifactId>bom</artifactId>
              <version>0.0.1</version>
              <type>pom</type>
              <scope>import</scope>
            </dependency>
          </dependencies>
        </dependencyManagement>
        <dependencies>
          <dependency>
            <groupId>io.github.simbadsonar</groupId>
            <artifactId>gap</artifactId>
          </dependency>
          <dependency>
            <groupId>io.github.simbadsonar</groupId>
            <artifactId>obstacles</artifactId>
          </dependency>
        </dependencies>
      </project>
      """;

  private static final String PROGRAM =
      """
      import simbad.gap.diagnosis.Interval;
      import simbad.obstacles.Catalogue;

      public class Program {
        public static void main(String[] args) {
          System.out.println(Catalogue.shipped().size() + " " + Interval.class.getSimpleName());
        }
      }
      """;

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  private static String run(Path directory, String... command)
      throws IOException, InterruptedException {
    Process process =
        new ProcessBuilder(command).directory(directory.toFile()).redirectErrorStream(true).start();
    process.getOutputStream().close();
    String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, process.waitFor(), String.join(" ", command) + "\n" + output);
    return output;
  }

  /** A clone that somebody has made ready. */
  private Path ready() throws Exception {
    Path clone = folder.resolve("clone");
    run(Path.of(".."), "git", "clone", "-q", ".", clone.toString());
    Files.writeString(
        clone.resolve(Publication.FILE),
        """
        url=https://example.org/sonar
        scm.url=https://example.org/sonar/src
        scm.connection=scm:git:https://example.org/sonar.git
        developer.name=Ada Example
        developer.contact=https://example.org/ada
        """);
    try (Stream<Path> files = Files.walk(clone, 3)) {
      for (Path pom : files.filter(file -> file.endsWith("pom.xml")).toList()) {
        Files.writeString(pom, Files.readString(pom).replace("0.1.0-SNAPSHOT", VERSION));
      }
    }
    run(
        clone,
        "git",
        "-c",
        "user.name=Ada",
        "-c",
        "user.email=ada@example.org",
        "commit",
        "-qam",
        "Ready");
    return clone;
  }

  @Test
  void plainProject_takesTheCoordinatesFromAFolder() throws Exception {
    Path repository = folder.resolve("repository");
    run(
        ready(),
        "./simbad",
        "release",
        "--publish",
        "--unsigned",
        "--stale-figures",
        "--out",
        repository.toString());
    checkFiles(repository.resolve("io/github/simbadsonar"));
    Path consumer = Files.createDirectories(folder.resolve("consumer/src/main/java"));
    Files.writeString(consumer.resolve("Program.java"), PROGRAM);
    Path project = folder.resolve("consumer");
    Files.writeString(
        project.resolve("pom.xml"), CONSUMER.replace("REPOSITORY", repository.toUri().toString()));
    String own = "-Dmaven.repo.local=" + folder.resolve("m2");
    run(
        project,
        "mvn",
        "-q",
        "-B",
        own,
        "compile",
        "dependency:build-classpath",
        "-Dmdep.outputFile=path");
    String path = Files.readString(project.resolve("path"));
    String said = run(project, "java", "-cp", "target/classes:" + path, "Program");
    assertEquals(Catalogue.shipped().size() + " Interval", said.strip());
  }

  private static void checkFiles(Path group) throws IOException {
    for (String room : List.of("sonar-model", "effects", "gap", "simbad-core", "cli")) {
      String name = room + "-" + VERSION;
      for (String end : List.of(".jar", "-sources.jar", "-javadoc.jar", ".pom")) {
        Path file = group.resolve(room).resolve(VERSION).resolve(name + end);
        assertTrue(Files.size(file) > 0, file.toString());
      }
    }
    String parent =
        Files.readString(
            group.resolve("simbad-sonar/" + VERSION + "/simbad-sonar-" + VERSION + ".pom"));
    assertTrue(parent.contains("<name>Ada Example</name>"), parent);
    assertTrue(parent.contains("<connection>scm:git:https://example.org/sonar.git"), parent);
  }
}
