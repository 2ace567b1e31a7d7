package simbad.architecture;

import static com.tngtech.archunit.base.DescribedPredicate.not;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.type;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaMethodCall;
import com.tngtech.archunit.core.domain.JavaPackage;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.lang.syntax.elements.ClassesShould;
import java.io.File;
import java.io.FileOutputStream;
import java.io.FileWriter;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Date;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.random.RandomGenerator;
import java.util.stream.Stream;
import org.jspecify.annotations.NullMarked;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.blindworld.world.Chance;
import simbad.cli.Main;
import simbad.definition.Effect;
import simbad.gui.AgentInspector;
import simbad.gui.Console;
import simbad.sim.Agent;
import simbad.sonar.format.WholeFile;

/** The arrows of docs/architecture.md, over all modules, and who may do what. */
class ArchitectureTest {
  private static final JavaClasses CLASSES =
      new ClassFileImporter()
          .withImportOption(new ImportOption.DoNotIncludeTests())
          // Samples of experiments and figures, which tests of other rooms use.
          .withImportOption(location -> !location.contains("-tests.jar"))
          .importPackages("simbad");

  private static final String MODEL = "simbad.sonar..";
  private static final String[] MODEL_BUT_CHECKS = {
    "simbad.sonar.format..",
    "simbad.sonar.frame..",
    "simbad.sonar.level..",
    "simbad.sonar.model..",
    "simbad.sonar.scene..",
    "simbad.sonar.sensing..",
    "simbad.sonar.shape..",
    "simbad.sonar.effect..",
    "simbad.sonar.ping..",
    "simbad.sonar.predict.."
  };
  private static final String DEFINITION = "simbad.definition..";
  private static final String[] EFFECTS = {
    "simbad.sonar.effect..",
    "simbad.sonar.ping..",
    "simbad.sonar.change..",
    "simbad.sonar.predict..",
    "simbad.sonar.catalogue.."
  };
  private static final String MOTION = "simbad.motion..";
  private static final String KERNEL = "simbad.kernel..";
  private static final String BENCH = "simbad.bench..";
  private static final String OBSTACLES = "simbad.obstacles..";
  private static final String EXPERIMENTS = "simbad.experiments..";
  private static final String GAP = "simbad.gap..";
  private static final String BLIND = "simbad.blindworld..";
  private static final String SCATTERING = "simbad.scattering..";
  private static final String FIGURES = "simbad.figures..";
  private static final String STUDIO = "simbad.studio..";
  private static final String CLI = "simbad.cli..";
  private static final String WEB = "simbad.studio.web..";

  /** Rooms that nothing below them may name: whoever works with values and files needs no page. */
  private static final String[] ABOVE_OBSTACLES = {EXPERIMENTS, FIGURES, STUDIO, CLI};

  private static final String SCENE = "simbad.scene3d..";
  private static final String[] WORLD = {
    KERNEL, SCENE, "simbad.sim..", "simbad.gui..", "simbad.demo.."
  };
  private static final String[] TOOLKITS = {
    "java.awt..", "javax.swing..", "javax.media..", "javax.vecmath..", "com.sun.j3d.."
  };

  /** A rule about packages that hold nothing would pass on nothing. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "simbad.sonar, 40",
        "simbad.definition, 3",
        "simbad.sonar.change, 40",
        "simbad.sonar.catalogue, 30",
        "simbad.motion, 20",
        "simbad.kernel, 20",
        "simbad.sim, 20",
        "simbad.gui, 15",
        "simbad.scene3d, 12",
        "simbad.demo, 15",
        "simbad.obstacles, 9",
        "simbad.bench, 15",
        "simbad.experiments, 60",
        "simbad.figures, 50",
        "simbad.cli, 60",
        "simbad.figures.diagnosis, 15",
        "simbad.figures.page, 10",
        "simbad.gap, 30",
        "simbad.blindworld, 40",
        "simbad.scattering, 10",
        "simbad.experiments.control, 8",
        "simbad.studio.web, 5",
        "simbad.studio, 25",
        "simbad, 160"
      })
  void import_foundTheClasses(String packageAndLeast) {
    String[] parts = packageAndLeast.split(", ", 2);
    int found = CLASSES.that(resideInAPackage(parts[0] + "..")).size();
    assertTrue(found >= Integer.parseInt(parts[1]), parts[0] + ": only " + found + " classes");
  }

  private static ArchRule apart(String from, String... to) {
    return noClasses()
        .that()
        .resideInAPackage(from)
        .should()
        .dependOnClassesThat()
        .resideInAnyPackage(to);
  }

  private static String[] above(String... more) {
    return Stream.concat(Stream.of(ABOVE_OBSTACLES), Stream.of(more)).toArray(String[]::new);
  }

  /** The command line uses figures use experiments use obstacles, and no arrow goes back. */
  static Stream<Arguments> arrows() {
    return Stream.of(
        Arguments.of(MODEL, WORLD),
        Arguments.of(MODEL, new String[] {MOTION}),
        Arguments.of(MOTION, WORLD),
        Arguments.of(MOTION, TOOLKITS),
        Arguments.of(MOTION, above(OBSTACLES, GAP, SCATTERING, BENCH)),
        Arguments.of(MODEL, above(OBSTACLES)),
        Arguments.of(MODEL, TOOLKITS),
        Arguments.of(KERNEL, new String[] {"simbad.sim..", "simbad.gui..", "simbad.demo.."}),
        Arguments.of(KERNEL, above(OBSTACLES)),
        Arguments.of(KERNEL, TOOLKITS),
        Arguments.of(SCENE, new String[] {"simbad.sim..", "simbad.gui..", "simbad.demo.."}),
        Arguments.of(SCENE, above(OBSTACLES)),
        Arguments.of("simbad.sim..", above(OBSTACLES)),
        Arguments.of("simbad.gui..", above(OBSTACLES)),
        Arguments.of("simbad.demo..", above("simbad.gui..", OBSTACLES)),
        Arguments.of(OBSTACLES, above()),
        Arguments.of(GAP, WORLD),
        Arguments.of(GAP, above(OBSTACLES)),
        Arguments.of(GAP, TOOLKITS),
        Arguments.of(MODEL, new String[] {GAP, SCATTERING}),
        Arguments.of(SCATTERING, WORLD),
        Arguments.of(SCATTERING, above(OBSTACLES, GAP, BENCH)),
        Arguments.of(SCATTERING, TOOLKITS),
        Arguments.of(OBSTACLES, new String[] {SCATTERING}),
        Arguments.of(GAP, new String[] {SCATTERING, BENCH}),
        Arguments.of(BENCH, new String[] {SCATTERING, GAP}),
        Arguments.of(OBSTACLES, new String[] {GAP}),
        Arguments.of("simbad.experiments.demo..", new String[] {"simbad.gui.."}),
        Arguments.of(MODEL, new String[] {BENCH}),
        Arguments.of(BENCH, WORLD),
        Arguments.of(BENCH, above(OBSTACLES)),
        Arguments.of(BENCH, TOOLKITS),
        Arguments.of(OBSTACLES, new String[] {BENCH}),
        Arguments.of("simbad.sim..", new String[] {BENCH}),
        Arguments.of(EXPERIMENTS, new String[] {FIGURES, STUDIO, CLI}),
        Arguments.of(FIGURES, new String[] {STUDIO, CLI}),
        Arguments.of(STUDIO, new String[] {CLI}),
        // Of the model's room plots use the checks of arguments, and nothing else.
        Arguments.of("simbad.figures.plot..", MODEL_BUT_CHECKS),
        Arguments.of("simbad.figures.plot..", new String[] {OBSTACLES}),
        Arguments.of("simbad.figures.plot..", WORLD),
        Arguments.of("simbad.experiments.run..", new String[] {"simbad.experiments.report.."}));
  }

  @ParameterizedTest
  @MethodSource("arrows")
  void arrow_isNotThere(String from, String[] to) {
    apart(from, to).check(CLASSES);
  }

  /** What checks the diagnosis shares no code with what is checked, nor a library but the JDK. */
  /** An effect is one file: nothing but its definition speaks of it by name. */
  @Test
  void effects_areNamedByTheirDefinitionsOnly() {
    noClasses()
        .that()
        .resideInAPackage("simbad..")
        .and()
        .resideOutsideOfPackages("simbad.sonar.catalogue..", BLIND)
        .and()
        .doNotHaveFullyQualifiedName(Effect.class.getName())
        .should()
        .accessFieldWhere(
            DescribedPredicate.describe(
                "it is the name of an effect",
                access ->
                    access.getTargetOwner().isEquivalentTo(Effect.class)
                        && access.getTarget().getRawType().isEquivalentTo(Effect.class)))
        .check(CLASSES);
  }

  /** The sonar model knows no effects, and what a definition is knows neither. */
  @Test
  void effects_areAboveTheSonarModel() {
    noClasses()
        .that()
        .resideInAPackage(MODEL)
        .and()
        .resideOutsideOfPackages(EFFECTS)
        .should()
        .dependOnClassesThat()
        .resideInAnyPackage(EFFECTS)
        .check(CLASSES);
    noClasses()
        .that()
        .resideInAPackage(MODEL)
        .and()
        .resideOutsideOfPackages(EFFECTS)
        .should()
        .dependOnClassesThat()
        .resideInAPackage(DEFINITION)
        .check(CLASSES);
    classes()
        .that()
        .resideInAPackage(DEFINITION)
        .should()
        .onlyDependOnClassesThat(
            resideInAnyPackage("java..", "org.jspecify.annotations", DEFINITION))
        .check(CLASSES);
  }

  @Test
  void blindWorld_standsAlone() {
    classes()
        .that()
        .resideInAPackage(BLIND)
        .should()
        .onlyDependOnClassesThat(resideInAnyPackage("java..", "org.jspecify.annotations", BLIND))
        .check(CLASSES);
    noClasses()
        .that()
        .resideOutsideOfPackage(BLIND)
        .should()
        .dependOnClassesThat()
        .resideInAPackage(BLIND)
        .check(CLASSES);
  }

  /** So that another server, or none, is a change of one package. */
  @Test
  void webLibrary_staysInItsPackage() {
    noClasses()
        .that()
        .resideOutsideOfPackage(WEB)
        .should()
        .dependOnClassesThat()
        .resideInAnyPackage(
            "io.javalin..", "org.eclipse.jetty..", "jakarta..", "kotlin..", "com.sun.net..")
        .check(CLASSES);
    apart(
            WEB,
            EXPERIMENTS,
            CLI,
            FIGURES,
            "simbad.studio",
            "simbad.studio.bench..",
            "simbad.studio.folders..",
            "simbad.bench..")
        .check(CLASSES);
  }

  /** Runs, data sets and checks are values and files: whoever wants a picture asks figures. */
  @Test
  void picturesAndPages_areTheFigures() {
    noClasses()
        .that()
        .resideInAPackage("simbad..")
        .and()
        .resideOutsideOfPackages(FIGURES, CLI)
        .should()
        .dependOnClassesThat()
        .resideInAnyPackage("org.knowm.xchart..", "org.commonmark..", "picocli..")
        .check(CLASSES);
    noClasses()
        .that()
        .resideInAPackage(FIGURES)
        .should()
        .dependOnClassesThat()
        .resideInAPackage("picocli..")
        .check(CLASSES);
  }

  /** Of the sonar only the readers of files and the checks: a robot moves without hearing. */
  @Test
  void motion_knowsOfTheSonarOnlyItsFormats() {
    classes()
        .that()
        .resideInAPackage(MOTION)
        .should()
        .onlyDependOnClassesThat(
            resideInAnyPackage(
                "java..",
                "org.jspecify.annotations",
                MOTION,
                "simbad.sonar.format",
                "simbad.sonar.check"))
        .check(CLASSES);
  }

  /** So figures of readings are not older for a change of what diagnoses motion. */
  @Test
  void readings_areDiagnosedWithoutWhatDiagnosesMotion() {
    noClasses()
        .that()
        .resideInAPackage("simbad.gap..")
        .and()
        .resideOutsideOfPackages("simbad.gap.motion", "simbad.gap.joint")
        .should()
        .dependOnClassesThat()
        .resideInAnyPackage("simbad.gap.motion", "simbad.gap.joint")
        .check(CLASSES);
  }

  @Test
  void commandLine_isUsedByNobody() {
    noClasses()
        .that()
        .resideOutsideOfPackage(CLI)
        .should()
        .dependOnClassesThat()
        .resideInAPackage(CLI)
        .check(CLASSES);
  }

  /** A controller receives belt readings and nothing else. */
  @Test
  void controller_knowsReadingsAndAnglesOnly() {
    classes()
        .that()
        .resideInAPackage("simbad.experiments.control..")
        .should()
        .onlyDependOnClassesThat(
            resideInAnyPackage(
                "java..",
                "org.jspecify.annotations",
                "simbad.experiments.control",
                "simbad.sonar.sensing",
                "simbad.sonar.frame"))
        .check(CLASSES);
  }

  @Test
  void controller_isGivenNoPoses() {
    noClasses()
        .that()
        .resideInAPackage("simbad.experiments.control..")
        .should()
        .dependOnClassesThat()
        .haveNameMatching("simbad\\.sonar\\.(sensing\\.(TransducerPoses|Sensor)|frame\\.Pose)")
        .check(CLASSES);
  }

  /** An agent knows the inspector that shows it: these two signatures are Simbad's. */
  @Test
  void packages_haveNoCycles_butForTheInspector() {
    slices()
        .matching("simbad.(**)")
        .should()
        .beFreeOfCycles()
        .ignoreDependency(Agent.class, AgentInspector.class)
        .check(CLASSES);
  }

  @Test
  void packages_areAllNullMarked() {
    Set<JavaPackage> packages = CLASSES.getPackage("simbad").getSubpackagesInTree();
    List<String> unmarked =
        packages.stream()
            .filter(p -> !p.getClasses().isEmpty())
            .filter(p -> !p.isAnnotatedWith(NullMarked.class))
            .map(JavaPackage::getName)
            .sorted()
            .toList();
    assertEquals(List.of(), unmarked);
  }

  /** But for the console window, whose task is to show what is printed. */
  @Test
  void standardStreams_areTheCommandLines() {
    noClasses()
        .that()
        .resideOutsideOfPackages(CLI, BLIND)
        .and()
        .areNotAssignableTo(Console.class)
        .should()
        .accessField(System.class, "out")
        .check(CLASSES);
    outsideTheCommandLine().accessField(System.class, "err").check(CLASSES);
    outsideTheCommandLine().callMethod(Throwable.class, "printStackTrace").check(CLASSES);
  }

  @Test
  void ending_isTheCommandLines() {
    outsideTheCommandLine().callMethod(System.class, "exit", int.class).check(CLASSES);
    outsideTheCommandLine()
        .callMethodWhere(callOf(Runtime.class, "(exit|halt|addShutdownHook)"))
        .check(CLASSES);
  }

  /** Randomness and time enter as arguments; the world's pacer and frame meter serve the window. */
  @Test
  void chanceAndWallTime_enterAsArguments() {
    outsideTheCommandLine().dependOnClassesThat(type(Date.class)).check(CLASSES);
    outsideTheCommandLine().callMethod(Math.class, "random").check(CLASSES);
    outsideTheCommandLine().callConstructor(Random.class).check(CLASSES);
    outsideTheCommandLine().callConstructor(SplittableRandom.class).check(CLASSES);
    outsideTheCommandLine().callMethodWhere(callOf(java.time.Instant.class, "now")).check(CLASSES);
    clockless("simbad.sonar..").check(CLASSES);
    clockless("simbad.obstacles..").check(CLASSES);
    clockless(MOTION).check(CLASSES);
    clockless("simbad.gap..").check(CLASSES);
    clockless(BLIND).check(CLASSES);
    clockless("simbad.scattering..").check(CLASSES);
    clockless(
            "simbad.experiments.(demo|run|control|report|table|diagnosis|dataset|blindcheck|motion)..")
        .check(CLASSES);
    clockless("simbad.figures.(report|plot|diagnosis|blindcheck|batch|page)..").check(CLASSES);
  }

  /**
   * What is drawn is the same on every Java and every machine. The JDK says so of its uniform
   * numbers and of StrictMath, but neither of its normal numbers nor of Math.
   */
  @Test
  void whatIsDrawn_isTheSameOnEveryJava() {
    for (Class<?> owner : List.of(RandomGenerator.class, Random.class, SplittableRandom.class)) {
      noClasses()
          .that()
          .resideOutsideOfPackage(BLIND)
          .should()
          .callMethodWhere(callOf(owner, "nextGaussian|nextExponential"))
          .check(CLASSES);
    }
    noClasses()
        .that(resideInAPackage(BLIND).and(not(type(Chance.class))))
        .should()
        .dependOnClassesThat(type(SplittableRandom.class))
        .check(CLASSES);
    machineless(BLIND).check(CLASSES);
  }

  private static ArchRule machineless(String from) {
    return noClasses()
        .that()
        .resideInAPackage(from)
        .should()
        .callMethodWhere(
            callOf(Math.class, "a?(sin|cos|tan)h?|atan2|exp|expm1|log|log10|log1p|pow|cbrt|hypot"));
  }

  private static ArchRule clockless(String from) {
    return noClasses()
        .that()
        .resideInAPackage(from)
        .should()
        .callMethodWhere(callOf(System.class, "(currentTimeMillis|nanoTime)"));
  }

  /**
   * A file appears under its name when all of it is there. Others than {@link WholeFile} write logs
   * that grow line by line; the blind world, which shares no code, writes into unfinished folders.
   */
  @Test
  void files_areWrittenAsAWhole() {
    writesNoFile().check(CLASSES);
  }

  private static ArchRule writesNoFile() {
    return noClasses()
        .that()
        .doNotHaveFullyQualifiedName(WholeFile.class.getName())
        .and()
        .haveNameNotMatching(
            "simbad\\.(bench\\.capture\\.(Journal|ReadingsLog)|experiments\\.batch\\.ResultLog"
                + "|cli\\.BlindCheck|blindworld\\.file\\.Output)")
        .should()
        .callMethodWhere(callOf(Files.class, "write|writeString|newBufferedWriter|newOutputStream"))
        .orShould()
        .callMethodWhere(callOf(Files.class, "newByteChannel|copy"))
        .orShould()
        .callMethodWhere(callOf(FileChannel.class, "open"))
        .orShould()
        .callConstructor(FileOutputStream.class, File.class)
        .orShould()
        .callConstructor(FileOutputStream.class, String.class)
        .orShould()
        .dependOnClassesThat(type(FileWriter.class))
        .orShould()
        .dependOnClassesThat(type(RandomAccessFile.class));
  }

  /** The blind world is a program of its own, with a command line and seeds of its own. */
  private static ClassesShould outsideTheCommandLine() {
    return noClasses().that().resideOutsideOfPackages(CLI, BLIND).should();
  }

  private static DescribedPredicate<JavaMethodCall> callOf(Class<?> owner, String names) {
    return DescribedPredicate.describe(
        "calls " + owner.getSimpleName() + "." + names,
        call -> call.getTargetOwner().isAssignableTo(owner) && call.getName().matches(names));
  }

  /** The gates close: classes that break a rule are found to. */
  @Test
  void rules_refuseWhatBreaksThem() {
    JavaClasses offender = new ClassFileImporter().importClasses(Offender.class);
    assertAll(
        () -> refuse(outsideTheCommandLine().accessField(System.class, "out"), offender),
        () -> refuse(outsideTheCommandLine().callMethod(Math.class, "random"), offender),
        () -> refuse(outsideTheCommandLine().dependOnClassesThat(type(Main.class)), offender),
        () -> refuse(clockless("simbad.architecture"), offender),
        () -> refuse(machineless("simbad.architecture"), offender),
        () -> refuse(writesNoFile(), offender),
        () -> refuse(apart("simbad.architecture", OBSTACLES), offender));
  }

  private static void refuse(ArchRule rule, JavaClasses classes) {
    assertThrows(AssertionError.class, () -> rule.check(classes));
  }

  /** Breaks rules. */
  static final class Offender {
    private Offender() {}

    static void offend() throws IOException {
      Files.writeString(Path.of("torn"), "");
      System.out.println(Math.cbrt(Math.random()) + System.currentTimeMillis());
      simbad.obstacles.Catalogue.types();
    }

    static Class<?> main() {
      return Main.class;
    }
  }
}
