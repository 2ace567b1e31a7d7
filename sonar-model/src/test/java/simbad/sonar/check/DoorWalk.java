package simbad.sonar.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** Goes through all public constructors and factories of a room with NaN. */
public final class DoorWalk {
  private DoorWalk() {}

  /**
   * Fails when a door takes NaN.
   *
   * @param ofRoom any class of the room
   * @param samples values for what cannot be made of nothing
   * @param many fewer doors than there are: a walk that finds none proves nothing
   * @param butFor beginnings of doors for which NaN has a meaning that their Javadoc says
   */
  public static void refusesNan(Class<?> ofRoom, Samples samples, int many, String... butFor)
      throws Exception {
    List<String> faults = new ArrayList<>();
    List<Door> doors = doors(ofRoom);
    doors.removeIf(door -> Arrays.stream(butFor).anyMatch(door.toString()::startsWith));
    for (Door door : doors) {
      Optional<Object[]> sample = door.sample(samples);
      sample.ifPresentOrElse(
          arguments -> faults.addAll(door.faults(arguments)),
          () -> faults.add("no arguments are known that " + door + " takes"));
    }
    assertEquals("", String.join("\n", faults));
    assertTrue(doors.size() > many, doors.size() + " doors");
  }

  private static List<Door> doors(Class<?> ofRoom) throws Exception {
    Path source = Path.of(ofRoom.getProtectionDomain().getCodeSource().getLocation().toURI());
    if (Files.isDirectory(source)) {
      return doors(source);
    }
    // A room that was packaged before.
    try (FileSystem jar = FileSystems.newFileSystem(source)) {
      return doors(jar.getPath("/"));
    }
  }

  private static List<Door> doors(Path classes) throws Exception {
    List<Door> doors = new ArrayList<>();
    try (Stream<Path> files = Files.walk(classes)) {
      for (Path file : files.filter(f -> f.toString().endsWith(".class")).sorted().toList()) {
        String name = classes.relativize(file).toString().replace('/', '.');
        if (!name.endsWith("-info.class")) {
          String plain = name.substring(0, name.length() - ".class".length());
          // Not initialized: some look for a display.
          Class<?> type = Class.forName(plain, false, DoorWalk.class.getClassLoader());
          Door.of(type).forEach(doors::add);
        }
      }
    }
    return doors;
  }
}
