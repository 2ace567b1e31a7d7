package simbad;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import org.junit.jupiter.api.Test;

/** What the kernel may not know. */
class KernelRulesTest {
  private static final JavaClasses CLASSES =
      new ClassFileImporter()
          .withImportOption(new ImportOption.DoNotIncludeTests())
          .importPackages("simbad");

  @Test
  void import_foundTheModule() {
    assertTrue(CLASSES.size() >= 50, "only " + CLASSES.size() + " classes");
  }

  @Test
  void kernel_knowsNoToolkit() {
    noClasses()
        .that()
        .resideInAPackage("simbad.kernel..")
        .should()
        .dependOnClassesThat()
        .resideInAnyPackage(
            "java.awt..", "javax.swing..", "javax.media..", "javax.vecmath..", "com.sun.j3d..")
        .check(CLASSES);
  }

  @Test
  void kernel_knowsNoFacade() {
    noClasses()
        .that()
        .resideInAPackage("simbad.kernel..")
        .should()
        .dependOnClassesThat()
        .resideInAnyPackage("simbad.sim..", "simbad.gui..")
        .check(CLASSES);
  }

  @Test
  void scene_knowsNoFacade() {
    noClasses()
        .that()
        .resideInAPackage("simbad.scene3d..")
        .should()
        .dependOnClassesThat()
        .resideInAnyPackage("simbad.sim..", "simbad.gui..", "simbad.demo..", "javax.swing..")
        .check(CLASSES);
  }

  @Test
  void simulation_makesNoSceneGraphNode() {
    noClasses()
        .that()
        .resideInAnyPackage("simbad.kernel..", "simbad.sim..")
        .should()
        .callConstructorWhere(
            new com.tngtech.archunit.base.DescribedPredicate<>("a Java 3D node is made") {
              @Override
              public boolean test(com.tngtech.archunit.core.domain.JavaConstructorCall call) {
                // Lights can be made without a display; 1.7 hands them out.
                return call.getTargetOwner().isAssignableTo("javax.media.j3d.Node")
                    && !call.getTargetOwner().isAssignableTo("javax.media.j3d.Light");
              }
            })
        .check(CLASSES);
  }
}
