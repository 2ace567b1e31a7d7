package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Programs as people have them: sources in a package, in another encoding, that open the window.
 */
class ProgramCommandTest {
  private static final String WANDERER = "../data/programs/wanderer";
  private static final String DICE = "../data/programs/dice";

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  private Shell wanderer(String... more) {
    return Shell.simbad(
        Stream.concat(
                Stream.of("program", WANDERER, "--class-path", DICE, "--steps", "200"),
                Stream.of(more))
            .toArray(String[]::new));
  }

  private static Shell checkDone(Shell shell) {
    assertEquals(0, shell.status(), shell.err());
    return shell;
  }

  private static void checkRefused(String names, int status, Shell shell) {
    assertEquals(status, shell.status(), shell.err());
    assertTrue(shell.err().contains(names), shell.err());
  }

  private Path program(String name, String text) throws IOException {
    Path sources = Files.createDirectories(folder.resolve(name));
    Files.writeString(sources.resolve(name + ".java"), text);
    return sources;
  }

  @Test
  void wanderer_runsWithoutAWindow_theSameEachTime() throws IOException {
    Path one = folder.resolve("one.csv");
    Path two = folder.resolve("two.csv");
    Path three = folder.resolve("three.csv");
    String said = checkDone(wanderer("--trace", one.toString())).out();
    assertTrue(said.startsWith("200 steps, 1 world, 2 agents\n"), said);
    assertTrue(said.contains("no-echo-is-infinite (off)"), said);
    checkDone(wanderer("--trace", two.toString()));
    checkDone(wanderer("--trace", three.toString(), "--seed", "2"));
    assertEquals(Files.readString(one), Files.readString(two));
    assertFalse(Files.readString(one).equals(Files.readString(three)));
    List<String> rows = Files.readAllLines(one);
    assertEquals(1 + 2 * 201, rows.size());
    assertTrue(rows.get(1).startsWith("1,0,Läufer,0.000000000,0.25"), rows.get(1));
  }

  @Test
  void compare_saysWhereTheyPart() {
    String same = checkDone(wanderer("--compare", "noses-float")).out();
    assertTrue(same.contains("the default and noses-float: all poses agree to 1e-6"), same);
    String other = checkDone(wanderer("--compare", "released-1.4")).out();
    assertTrue(other.contains("the default and released-1.4: they part at step "), other);
  }

  @Test
  void pictures_areTaken() throws IOException {
    Path pictures = folder.resolve("pictures");
    checkDone(wanderer("--picture", "every:100", "--pictures", pictures.toString()));
    try (Stream<Path> files = Files.list(pictures)) {
      assertEquals(
          List.of("step-000000.png", "step-000100.png", "step-000200.png"),
          files.map(file -> file.getFileName().toString()).sorted().toList());
    }
  }

  /** An endless program of its own steps, which asks the main window's and Java's clock. */
  @Test
  void batchProgram_isEndedAfterItsSteps() throws IOException {
    Path sources =
        program(
            "Endless",
            """
            import javax.vecmath.Vector3d;
            public class Endless {
              public static void main(String[] args) throws Exception {
                simbad.sim.EnvironmentDescription e = new simbad.sim.EnvironmentDescription();
                e.add(new simbad.sim.Agent(new Vector3d(), args[0]) {
                  public void performBehavior() { setTranslationalVelocity(1); }
                });
                simbad.gui.Simbatch batch = new simbad.gui.Simbatch(e, false);
                batch.reset();
                while (true) batch.step();
              }
            }
            """);
    Path trace = folder.resolve("poses.csv");
    Shell shell =
        checkDone(
            Shell.simbad(
                "program",
                sources.toString(),
                "Emil",
                "--steps",
                "20",
                "--trace",
                trace.toString()));
    assertTrue(shell.out().contains("no compatibility switch"), shell.out());
    List<String> rows = Files.readAllLines(trace);
    assertEquals("1,20,Emil,1.000000000,0.250000000,0.000000000,0.000000000,0", rows.get(21));
  }

  @Test
  void sourcesThatDoNotCompile_areRefused_withFileAndLine() throws IOException {
    Path sources =
        program(
            "Edited",
            """
            public class Edited {
              void m(simbad.sim.Agent a) {
                a.setPositionOfMyOwn(1);
              }
            }
            """);
    Shell shell = Shell.simbad("program", sources.toString());
    checkRefused("Edited.java:3: cannot find symbol", 2, shell);
    assertTrue(shell.err().contains("setPositionOfMyOwn"), shell.err());
  }

  @Test
  void faults_ofAProgram_nameItsLine() throws IOException {
    Path sources =
        program(
            "Faulty",
            """
            public class Faulty {
              public static void main(String[] args) {
                throw new IllegalStateException("mine");
              }
            }
            """);
    checkRefused("mine at Faulty.java:3", 1, Shell.simbad("program", sources.toString()));
    Path idle = program("Idle", "public class Idle { public static void main(String[] a) {} }");
    checkRefused("makes no world", 1, Shell.simbad("program", idle.toString()));
  }

  @Test
  void wrongUsage_isRefused() {
    checkRefused("no such jar or folder", 2, Shell.simbad("program", "not-there"));
    checkRefused(
        "no such jar or folder", 2, Shell.simbad("program", WANDERER, "--class-path", "x"));
    checkRefused("--picture: 'each:1'", 2, wanderer("--picture", "each:1"));
    checkRefused("--compat: '1.3' is no switch", 2, wanderer("--compat", "1.3"));
    checkRefused("--steps: 0", 2, Shell.simbad("program", WANDERER, "--steps", "0"));
    checkRefused("--main: 'Other' is no class of ", 2, wanderer("--main", "Other"));
  }

  /** Classes that were compiled against an edited Simbad, which stands beside them. */
  @Test
  void membersOfAnEditedSimbad_areListed_withFileAndLine() throws IOException {
    Path agent = Files.createDirectories(folder.resolve("edited/simbad/sim")).resolve("Agent.java");
    Files.writeString(
        agent,
        """
        package simbad.sim;
        public class Agent extends SimpleAgent {
          public Agent(javax.vecmath.Vector3d p, String n) { super(p, n); }
          public void setMyPose(double x) {}
        }
        """);
    Path program =
        program(
                "Asking",
                """
                public class Asking extends simbad.sim.EnvironmentDescription {
                  public Asking() {
                    add(new simbad.sim.Agent(new javax.vecmath.Vector3d(), "r") {
                      public void performBehavior() {
                        if (getCounter() > 5000) {
                          setMyPose(3);
                        }
                      }
                    });
                  }
                }
                """)
            .resolve("Asking.java");
    Path classes = Files.createDirectories(folder.resolve("classes"));
    String classPath =
        System.getProperty("surefire.test.class.path", System.getProperty("java.class.path"));
    int status =
        ToolProvider.getSystemJavaCompiler()
            .run(
                null,
                OutputStream.nullOutputStream(),
                OutputStream.nullOutputStream(),
                "-g",
                "-d",
                classes.toString(),
                "-cp",
                classPath,
                agent.toString(),
                program.toString());
    assertEquals(0, status);
    String said = checkDone(Shell.simbad("program", classes.toString(), "--steps", "3")).out();
    assertTrue(said.contains("passed over: 1 classes of a Simbad of its own"), said);
    assertTrue(said.contains("not there: Asking.java:6: simbad.sim.Agent.setMyPose(double)"), said);
    assertTrue(said.contains("3 steps, 1 world, 1 agents"), said);
  }
}
