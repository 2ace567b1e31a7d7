package simbad.experiments.program;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.jar.Attributes;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import java.util.jar.Manifest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simbad.sonar.format.DataFormatException;

/** What programs do besides stepping: windows, clocks, chance, threads; they run all the same. */
class ProgramRunTest {
  private static final String IMPORTS =
      """
      import java.awt.*;
      import java.util.*;
      import javax.swing.*;
      import javax.vecmath.*;
      import simbad.gui.*;
      import simbad.sim.*;
      """;

  /** Drives 1 m/s along x. */
  private static final String DRIVER =
      """
      class Driver extends Agent {
        Driver() { super(new Vector3d(), "driver"); }
        public void performBehavior() { setTranslationalVelocity(1); }
        static EnvironmentDescription world(Agent agent) {
          EnvironmentDescription world = new EnvironmentDescription();
          world.add(agent);
          return world;
        }
      }
      """;

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  private final List<String> errors = new ArrayList<>();

  private Path sources(String name, String text) throws IOException {
    Path sources = Files.createDirectories(folder.resolve(name));
    Files.writeString(sources.resolve(name + ".java"), IMPORTS + text + DRIVER);
    return sources;
  }

  private ProgramRun run(Path program, List<Path> libraries, long seed)
      throws IOException, DataFormatException, ProgramException {
    RunPlan.Settings settings = new RunPlan.Settings("", 100, seed, true);
    ProgramFile file = ProgramFile.read(program, libraries, errors::add);
    return ProgramRun.run(file.plan(null, List.of(), settings), null);
  }

  private PoseTrace.Row lastRow(String name, String text)
      throws IOException, DataFormatException, ProgramException {
    List<PoseTrace.Row> rows = run(sources(name, text), List.of(), 1).trace().rows();
    return rows.get(rows.size() - 1);
  }

  @Test
  void windows_areStoodInFor() throws IOException, DataFormatException, ProgramException {
    PoseTrace.Row last =
        lastRow(
            "Game",
            """
            public class Game extends Simbad {
              int lives = 3;
              Game(EnvironmentDescription e) {
                super(e, false);
                setTitle("game");
                setIconImage(null);
                JInternalFrame score = new JInternalFrame("score");
                getDesktopPane().add(score);
                Dimension screen = Toolkit.getDefaultToolkit().getScreenSize();
                setLocation(screen.width / 2, 0);
              }
              int lives() { return lives; }
              public static void main(String[] args) {
                Game game = new Game(Driver.world(new Driver()));
                game.update(game.getGraphics());
                if (game.lives() != 3) { throw new IllegalStateException(); }
                JFrame chart = new JFrame("chart");
                chart.setDefaultCloseOperation(JFrame.EXIT_ON_CLOSE);
                chart.add(new JLabel("x"));
                chart.setLocationRelativeTo(game);
                chart.setExtendedState(Frame.MAXIMIZED_BOTH);
                chart.pack();
                chart.setVisible(true);
                JOptionPane.showMessageDialog(game, "go");
                if (JOptionPane.showConfirmDialog(null, "go?") != JOptionPane.YES_OPTION) {
                  System.exit(1);
                }
              }
            }
            """);
    assertEquals(100, last.step());
    assertEquals(5, last.xM(), 1e-9);
  }

  @Test
  void windowThatNothingStandsInFor_isNamed() throws IOException {
    Path program =
        sources(
            "Asks",
            """
            public class Asks {
              public static void main(String[] args) {
                new JDialog().setVisible(true);
              }
            }
            """);
    String message =
        String.valueOf(
            assertThrows(ProgramException.class, () -> run(program, List.of(), 1)).getMessage());
    assertTrue(message.contains("needs a display at Asks.java:9;"), message);
    assertTrue(message.contains("--window"), message);
  }

  /** As programs do that draw their own window. */
  @Test
  void simulator_thatAProgramStarts_isStepped_untilItIsStopped()
      throws IOException, DataFormatException, ProgramException {
    PoseTrace.Row last =
        lastRow(
            "Own",
            """
            public class Own {
              static Simulator simulator;
              public static void main(String[] args) {
                EnvironmentDescription e = Driver.world(new Driver() {
                  public void performBehavior() {
                    super.performBehavior();
                    if (getCounter() == 29) { simulator.stopSimulation(); }
                  }
                });
                simulator = new Simulator(new JDesktopPane(), new World(e), e);
                simulator.startSimulation();
              }
            }
            """);
    assertEquals(30, last.step());
    assertEquals(1.5, last.xM(), 1e-9);
  }

  /** 2 s are 40 steps, however fast they are done. */
  @Test
  void mainThatSleeps_getsTheStepsOfThatTime()
      throws IOException, DataFormatException, ProgramException {
    PoseTrace.Row last =
        lastRow(
            "Sleeper",
            """
            public class Sleeper {
              public static void main(String[] args) throws InterruptedException {
                Driver driver = new Driver();
                new Simbad(Driver.world(driver), false);
                long before = System.currentTimeMillis();
                Thread.sleep(2000);
                if (System.currentTimeMillis() - before < 2000) { throw new IllegalStateException(); }
                driver.moveToPosition(100 + driver.getCounter(), 0);
              }
            }
            """);
    assertEquals(100, last.step());
    assertEquals(143, last.xM(), 1e-9);
  }

  /** As programs do that keep to Swing's rules; what an event asks for later comes after it. */
  @Test
  void eventsOfTheWindow_areDone_whenTheMainHasEnded_andAfterSteps()
      throws IOException, DataFormatException, ProgramException {
    PoseTrace.Row last =
        lastRow(
            "Late",
            """
            public class Late {
              static String order = "";
              public static void main(String[] args) throws Exception {
                SwingUtilities.invokeLater(() -> {
                  order += "b";
                  EventQueue.invokeLater(() -> order += "d");
                  Driver driver = new Driver() {
                    public void performBehavior() {
                      super.performBehavior();
                      if (getCounter() == 10) {
                        SwingUtilities.invokeLater(() -> moveToPosition(order.equals("abcd") ? 50 : 0, 0));
                        moveToPosition(-50, 0);
                      }
                    }
                  };
                  new Simbad(Driver.world(driver), false);
                  order += "c";
                });
                order += "a";
              }
            }
            """);
    assertEquals(100, last.step());
    // 100 steps of 5 cm, of which the first eleven end at x = 50.
    assertEquals(50 + 89 * 0.05, last.xM(), 1e-9);
  }

  @Test
  void worldThatAThreadMakes_isStepped() throws Exception {
    PoseTrace.Row last =
        lastRow(
            "Threaded",
            """
            public class Threaded {
              public static void main(String[] args) {
                new Thread(() -> {
                  try { Thread.sleep(200); } catch (InterruptedException e) { return; }
                  new Simbad(Driver.world(new Driver()), false);
                }).start();
              }
            }
            """);
    assertEquals(100, last.step());
  }

  /** What a thread does between making its world and stepping it may take time. */
  @Test
  void worldThatAThreadStepsItself_isStepped() throws Exception {
    PoseTrace.Row last =
        lastRow(
            "ThreadedBatch",
            """
            public class ThreadedBatch {
              public static void main(String[] args) {
                new Thread(() -> {
                  Simbatch batch = new Simbatch(Driver.world(new Driver()), false);
                  try { Thread.sleep(300); } catch (InterruptedException e) { return; }
                  batch.reset();
                  for (int i = 0; i < 100; i++) batch.step();
                }).start();
              }
            }
            """);
    assertEquals(100, last.step());
  }

  /** It says what came out after its last step, in each of its worlds. */
  @Test
  void batchProgram_goesOnAfterItsLastStep() throws Exception {
    Path program =
        sources(
            "Batch",
            """
            public class Batch {
              public static void main(String[] args) {
                for (int world = 0; world < 3; world++) {
                  Driver driver = new Driver();
                  Simbatch batch = new Simbatch(Driver.world(driver), false);
                  batch.reset();
                  for (int i = 0; i < 100; i++) batch.step();
                }
              }
            }
            """);
    ProgramRun run = run(program, List.of(), 1);
    assertEquals(3, run.worlds());
    assertEquals(300, run.steps());
  }

  /** As in {@code java -cp .}. */
  @Test
  void programThatIsOnItsOwnClassPath_isReadOnce() throws Exception {
    Path program =
        sources(
            "Own",
            """
            public class Own {
              public static void main(String[] args) {
                new Simbad(Driver.world(new Driver()), false);
              }
            }
            """);
    assertEquals(100, run(program, List.of(program), 1).steps());
  }

  @Test
  void comparison_saysWhereTheyPart_andHowFar() throws Exception {
    String text =
        """
        public class Away {
          public static void main(String[] args) {
            new Simbad(Driver.world(new Driver() {
              public void performBehavior() {
                boolean away = args.length > 0 && getCounter() >= 20 && getCounter() < 40;
                setTranslationalVelocity(away ? (getCounter() < 30 ? 3 : -1) : 1);
              }
            }), false);
          }
        }
        """;
    Path program = sources("Away", text);
    ProgramFile file = ProgramFile.read(program, List.of(), errors::add);
    RunPlan.Settings settings = new RunPlan.Settings("", 100, 1, true);
    PoseTrace plain = ProgramRun.run(file.plan(null, List.of(), settings), null).trace();
    PoseTrace away = ProgramRun.run(file.plan(null, List.of("x"), settings), null).trace();
    assertEquals("all poses agree to 1e-6", plain.comparedTo(plain));
    assertEquals(
        "they part at step 21: driver by 0.100, furthest at step 30: driver by 1.00,"
            + " after step 100 not at all (m or rad)",
        plain.comparedTo(away));
  }

  @Test
  void clockAndChance_followFromTheSeed_inLibrariesToo() throws Exception {
    Path library = Files.createDirectories(folder.resolve("lib"));
    Path source =
        Files.writeString(
            folder.resolve("Luck.java"),
            """
            package helper;
            public class Luck {
              public static double of(java.util.function.DoubleSupplier more) {
                return Math.random() + more.getAsDouble();
              }
            }
            """);
    assertEquals(0, compile(library, source));
    Files.delete(source);
    Path program =
        sources(
            "Lucky",
            """
            public class Lucky {
              public static void main(String[] args) {
                new Simbad(Driver.world(new Driver() {
                  final Random random = new Random(System.currentTimeMillis());
                  public void performBehavior() {
                    java.util.List<Integer> numbers = Arrays.asList(1, 2, 3, 4, 5, 6, 7, 8);
                    Collections.shuffle(numbers);
                    double more = java.util.concurrent.ThreadLocalRandom.current().nextDouble();
                    setTranslationalVelocity(helper.Luck.of(Math::random) + random.nextDouble() + more);
                    setRotationalVelocity(numbers.get(0) + System.nanoTime() % 7);
                  }
                }), false);
              }
            }
            """);
    List<Path> libraries = List.of(library);
    String first = run(program, libraries, 1).trace().csv();
    assertEquals(first, run(program, libraries, 1).trace().csv());
    assertNotEquals(first, run(program, libraries, 2).trace().csv());
  }

  private static int compile(Path into, Path source) {
    return javax.tools.ToolProvider.getSystemJavaCompiler()
        .run(
            null,
            OutputStream.nullOutputStream(),
            OutputStream.nullOutputStream(),
            "-d",
            into.toString(),
            source.toString());
  }

  @Test
  void jar_saysWhatIsToBeStarted() throws Exception {
    Path program =
        sources(
            "Two",
            """
            public class Two {
              public static void main(String[] args) {
                new Simbad(Driver.world(new Driver()), false);
              }
            }
            class Another {
              public static void main(String[] args) { throw new IllegalStateException(); }
            }
            """);
    String several =
        String.valueOf(
            assertThrows(DataFormatException.class, () -> run(program, List.of(), 1)).getMessage());
    assertTrue(several.contains("--main: [Another, Two]"), several);
    assertEquals(100, run(jar(program, "Two"), List.of(), 1).steps());
  }

  private Path jar(Path sources, String main) throws IOException, DataFormatException {
    Manifest manifest = new Manifest();
    manifest.getMainAttributes().put(Attributes.Name.MANIFEST_VERSION, "1.0");
    manifest.getMainAttributes().put(Attributes.Name.MAIN_CLASS, main);
    Path file = folder.resolve("program.jar");
    try (JarOutputStream jar = new JarOutputStream(Files.newOutputStream(file), manifest)) {
      Map<String, byte[]> classes =
          SourceCompiler.compile(sources, List.of(), List.of(), errors::add);
      for (Map.Entry<String, byte[]> entry : classes.entrySet()) {
        jar.putNextEntry(new JarEntry(entry.getKey() + ".class"));
        jar.write(entry.getValue());
      }
    }
    return file;
  }

  /** Sources that carry a Simbad of their own, with members that this one has not. */
  @Test
  void editedSources_runWithThisSimbad_asFarAsItGoes() throws Exception {
    Path program =
        sources(
            "Edits",
            """
            public class Edits {
              public static void main(String[] args) {
                new Simbad(Driver.world(new Driver() {
                  public void performBehavior() {
                    super.performBehavior();
                    if (getCounter() == Integer.parseInt(args.length > 0 ? args[0] : "1000")) {
                      mine(heading);
                    }
                  }
                }), false);
              }
            }
            """);
    Path own = Files.createDirectories(program.resolve("simbad/sim")).resolve("Agent.java");
    Files.writeString(
        own,
        """
        package simbad.sim;
        public class Agent extends SimpleAgent {
          public double heading;
          public Agent(javax.vecmath.Vector3d p, String n) { super(p, n); }
          public void setTranslationalVelocity(double v) {}
          public void mine(double h) {}
        }
        """);
    ProgramFile file = ProgramFile.read(program, List.of(), errors::add);
    assertEquals(
        List.of(
            "passed over: 1 classes of a Simbad of its own, such as simbad.sim.Agent",
            "not there: Edits.java:13: simbad.sim.Agent.heading",
            "not there: Edits.java:13: simbad.sim.Agent.mine(double)"),
        file.notes());
    RunPlan.Settings settings = new RunPlan.Settings("", 100, 1, true);
    assertEquals(100, ProgramRun.run(file.plan(null, List.of(), settings), null).steps());
    RunPlan asking = file.plan(null, List.of("10"), settings);
    String message =
        String.valueOf(
            assertThrows(ProgramException.class, () -> ProgramRun.run(asking, null)).getMessage());
    assertTrue(message.startsWith("step 11: java.lang.NoSuchFieldError"), message);
    assertTrue(message.endsWith(" at Edits.java:13"), message);
  }

  @Test
  void editedSources_thatNothingCompiles_areRefused() throws Exception {
    Path program = sources("Wrong", "public class Wrong { void m(Driver d) { d.mine(); } }\n");
    Path own = Files.createDirectories(program.resolve("simbad/sim")).resolve("Agent.java");
    Files.writeString(own, "package simbad.sim; public class Agent {}");
    String message =
        String.valueOf(
            assertThrows(DataFormatException.class, () -> run(program, List.of(), 1)).getMessage());
    assertTrue(message.contains("in place of its own 1 classes: 1 errors"), message);
    assertTrue(errors.get(0).contains("Wrong.java:7: cannot find symbol"), errors.toString());
  }
}
