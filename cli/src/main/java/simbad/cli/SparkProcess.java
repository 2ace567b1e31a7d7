package simbad.cli;

import java.io.FileDescriptor;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.locks.LockSupport;
import simbad.cli.machine.Children;
import simbad.cli.machine.Launcher;
import simbad.sonar.format.WholeFile;

/**
 * The program once more, as a process that has Apache Spark among its jars. Only those who ask for
 * Spark get it: it is added to the build that runs when it is asked for first.
 */
final class SparkProcess {
  private static final String OPTIONS = "java-options";
  private static final long LOOK_NS = 500_000_000;

  private SparkProcess() {}

  /**
   * Has such a process do a command, with the streams of this one.
   *
   * @param launcher of this process
   * @param words the command line
   * @param err told that Spark is built
   * @return its exit status
   */
  static int run(Launcher launcher, List<String> words, PrintWriter err)
      throws IOException, InterruptedException {
    Path spark = launcher.build().resolve("spark");
    if (!Files.isDirectory(spark)) {
      add(launcher, spark, err);
    }
    JavaProgram program = JavaProgram.withSpark(spark, OwnClasses.named());
    return Children.run(new ProcessBuilder(program.with(words)).inheritIO());
  }

  private static void add(Launcher launcher, Path spark, PrintWriter err)
      throws IOException, InterruptedException {
    Path build = launcher.build();
    if (!Files.isWritable(build)) {
      String owner = Files.getOwner(build).getName();
      throw new IOException(
          "Spark is not built in, and this account may not write to "
              + build
              + "; let "
              + owner
              + " type the command once");
    }
    err.println("simbad: building for Spark");
    err.flush();
    try (StagedDirectory staged = StagedDirectory.beside(spark)) {
      Path log = build.resolveSibling("spark.log");
      Path home = staged.path();
      launcher.pack(launcher.project(), "cluster", log, List.of("-Dspark.home=" + home));
      Path source = launcher.project().resolve("cluster").resolve("src").resolve("main");
      WholeFile.write(home.resolve(OPTIONS), Files.readAllBytes(source.resolve(OPTIONS)));
      // For all accounts, as the launcher makes the rest.
      permit(home, "rwxr-xr-x");
      permit(home.resolve(OPTIONS), "rw-r--r--");
      staged.publish();
    } catch (FileAlreadyExistsException e) {
      // Another process, asked at the same time, was quicker.
      return;
    }
  }

  private static void permit(Path file, String permissions) throws IOException {
    Files.setPosixFilePermissions(file, PosixFilePermissions.fromString(permissions));
  }

  /**
   * Begins it. It ends when the process does that started it, which also says that it was
   * interrupted.
   *
   * @param words the command line
   */
  public static void main(String... words) {
    Thread watch = new Thread(SparkProcess::endAfterStarter, "starter");
    watch.setDaemon(true);
    watch.start();
    System.exit(Main.runInThisProcess(Main.utf8(FileDescriptor.err), words));
  }

  /** Whose starter is gone gets another parent. */
  private static void endAfterStarter() {
    Optional<ProcessHandle> starter = ProcessHandle.current().parent();
    while (ProcessHandle.current().parent().equals(starter)) {
      LockSupport.parkNanos(LOOK_NS);
    }
    System.exit(ExitStatus.FAILED);
  }
}
