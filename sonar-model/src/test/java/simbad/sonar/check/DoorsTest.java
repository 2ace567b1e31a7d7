package simbad.sonar.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import simbad.sonar.effect.Burst;
import simbad.sonar.effect.Crosstalk;
import simbad.sonar.effect.Dropout;
import simbad.sonar.effect.Effect;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Gain;
import simbad.sonar.effect.Parameter;
import simbad.sonar.level.Beam;
import simbad.sonar.level.Curve;
import simbad.sonar.level.LevelLaw;
import simbad.sonar.level.PistonBeam;
import simbad.sonar.level.StrengthTable;

/** NaN comes in by no public constructor and by no factory: what is made is made of numbers. */
class DoorsTest {
  /** Fewer doors than there are: a walk that finds none proves nothing. */
  private static final int MANY = 100;

  private static Samples samples() {
    Curve curve = Curve.of(0, 0.1, 1, 0.2);
    Beam beam = PistonBeam.of(0.007, 700);
    Form form =
        Form.of(Effect.GAIN, "factor", v -> new Gain(v[0]), Parameter.of("factor", 1, 0, 3, 0.5));
    return new Samples()
        .with(Curve.class, curve)
        .with(Beam.class, beam)
        .with(Form.class, form)
        .with(StrengthTable.class, StrengthTable.of(new double[72]))
        .with(LevelLaw.class, new LevelLaw(30, 2, 1, beam, curve, 1, curve, curve, 0.01));
  }

  private static List<Door> doors() throws Exception {
    Path classes =
        Path.of(Checks.class.getProtectionDomain().getCodeSource().getLocation().toURI());
    List<Door> doors = new ArrayList<>();
    try (Stream<Path> files = Files.walk(classes)) {
      for (Path file : files.filter(f -> f.toString().endsWith(".class")).sorted().toList()) {
        String name = classes.relativize(file).toString().replace('/', '.');
        if (!name.endsWith("-info.class")) {
          Class<?> type = Class.forName(name.substring(0, name.length() - ".class".length()));
          Door.of(type).forEach(doors::add);
        }
      }
    }
    return doors;
  }

  @Test
  void nan_isRefusedAtEveryDoor() throws Exception {
    Samples samples = samples();
    List<String> faults = new ArrayList<>();
    List<Door> doors = doors();
    for (Door door : doors) {
      Optional<Object[]> sample = door.sample(samples);
      sample.ifPresentOrElse(
          arguments -> faults.addAll(door.faults(arguments)),
          () -> faults.add("no arguments are known that " + door + " takes"));
    }
    assertEquals("", String.join("\n", faults));
    assertTrue(doors.size() > MANY, doors.size() + " doors");
  }

  private static void assertRefused(String message, Executable made) {
    assertEquals(message, assertThrows(IllegalArgumentException.class, made).getMessage());
  }

  @Test
  void outOfRange_isRefused_andSaysWhatIsPermitted() {
    assertRefused("factor = NaN is not in [0, infinity)", () -> new Gain(Double.NaN));
    assertRefused("factor = -0.1 is not in [0, infinity)", () -> new Gain(-0.1));
    assertRefused("share = 7.0 is not in [0, 1]", () -> new Dropout(7));
    assertRefused("lengthPings = 0.5 is not in [1, infinity)", () -> new Burst(0.1, 0.5, 1));
    assertRefused("highM = 1.0 is not in (2, infinity)", () -> new Crosstalk(0.1, 2, 1, false));
  }
}
