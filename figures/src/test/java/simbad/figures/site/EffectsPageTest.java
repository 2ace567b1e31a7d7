package simbad.figures.site;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.motion.effect.MotionForms;
import simbad.obstacles.Catalogue;
import simbad.sonar.effect.Definitions;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Point;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.UniformDetection;
import simbad.sonar.shape.Outline;

/** The page's table of effects is that of the program: every name, every form, no other. */
class EffectsPageTest {
  private static final Path PAGE = Path.of("..", "docs", "method", "sonar-model.md");
  private static final Pattern ROW =
      Pattern.compile("(?m)^\\| ([a-z-]+) \\| ([^|]+) \\| (`[^|]*`) \\|$");

  @Test
  void table_hasEveryEffect_withItsForms() throws IOException {
    Map<String, Set<String>> shown = new TreeMap<>();
    for (MatchResult row : ROW.matcher(Files.readString(PAGE)).results().toList()) {
      List<String> forms = Arrays.stream(row.group(3).split("`(, `)?")).skip(1).toList();
      shown.put(row.group(1), new TreeSet<>(forms));
    }
    assertEquals(formsOfTheProgram(), shown);
  }

  /** The sentence of the definition, and perhaps how the forms differ. */
  @Test
  void table_saysWhatHappens_asTheDefinitionDoes() throws IOException {
    for (MatchResult row : ROW.matcher(Files.readString(PAGE)).results().toList()) {
      String happens = Definitions.of(Definitions.find(row.group(1)).orElseThrow()).happens();
      assertTrue(row.group(2).startsWith(happens), row.group(1) + ": " + happens);
    }
  }

  /** The guide names every effect of motion, and no other. */
  @Test
  void guideOfMotion_namesEveryEffect() throws IOException {
    Set<String> named = new TreeSet<>();
    String guide = Files.readString(Path.of("..", "docs", "guide", "motion.md"));
    String table = guide.substring(guide.indexOf("## The effects of motion"));
    table = table.substring(0, table.indexOf("## What comes out"));
    Pattern.compile("(?m)^\\| `([a-z-]+)` \\|")
        .matcher(table)
        .results()
        .forEach(row -> named.add(row.group(1)));
    Set<String> known = new TreeSet<>(Set.of(MotionForms.MOTION_NOISE, MotionForms.SLIP));
    MotionForms.ALL.forEach(form -> known.add(form.effect()));
    assertEquals(known, named);
  }

  /**
   * Of two obstacles, one of them a plate, and two transducers, since some forms are of one among
   * several, and one of a plate only.
   */
  private static Map<String, Set<String>> formsOfTheProgram() {
    Outline square = Catalogue.find("square").orElseThrow().outline();
    Outline plate =
        Outline.of(
            List.of(
                new Point(-0.1, 0),
                new Point(0.1, 0),
                new Point(0.1, -0.02),
                new Point(-0.1, -0.02)));
    SensingSetup setup =
        new SensingSetup(
            Catalogue.srf04(),
            new Scene(List.of(uniform("one", 0, square), uniform("two", 2, plate))),
            6);
    Map<String, Set<String>> all = new TreeMap<>();
    for (Effect effect : Definitions.effects()) {
      all.put(effect.word(), new TreeSet<>());
    }
    for (Form form : Forms.all(setup, List.of("left", "right"))) {
      all.computeIfAbsent(form.effect().word(), word -> new TreeSet<>()).add(general(form.name()));
    }
    return all;
  }

  private static Obstacle uniform(String name, double xM, Outline outline) {
    return new Obstacle(name, new Placement(xM, 0, 0), outline, new UniformDetection(2));
  }

  private static String general(String name) {
    return name.replaceAll(":(one|two|left|right)", ":LABEL").replaceAll("[0-9]", "I");
  }
}
