package simbad.architecture;

import static com.tngtech.archunit.base.DescribedPredicate.not;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

/** Whoever searches for a name finds one thing: no simple name stands in two packages. */
class NamesTest {
  private static final JavaClasses CLASSES =
      new ClassFileImporter()
          .withImportOption(new ImportOption.DoNotIncludeTests())
          // Samples of other rooms, which tests of this one use.
          .withImportOption(location -> !location.contains("-tests.jar"))
          .importPackages("simbad");

  /**
   * Names that stand in two packages all the same. Geometry and Robot are Simbad's own beside ours.
   * A command of a log and one of a controller, and a placement in the plane and one in space, are
   * used by programs outside.
   */
  private static final Set<String> BOTH = Set.of("Command", "Geometry", "Placement", "Robot");

  @Test
  void simpleName_standsInOnePackage() {
    TreeMap<String, Set<String>> packages = new TreeMap<>();
    // The independent worlds share no code with what they check, so they may share its words.
    for (JavaClass type : CLASSES.that(not(resideInAPackage("simbad.blindworld..")))) {
      if (type.isTopLevelClass() && !type.getSimpleName().equals("package-info")) {
        packages
            .computeIfAbsent(type.getSimpleName(), name -> new TreeSet<>())
            .add(type.getPackageName());
      }
    }
    assertTrue(packages.size() > 600, packages.size() + " names");
    packages.values().removeIf(where -> where.size() < 2);
    assertEquals(new TreeSet<>(BOTH), packages.keySet(), packages::toString);
  }
}
