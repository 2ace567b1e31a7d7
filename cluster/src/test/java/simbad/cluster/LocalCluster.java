package simbad.cluster;

import java.io.File;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/** A Spark master and workers of one core each, processes of their own on this machine. */
final class LocalCluster implements AutoCloseable {
  private static final Path HOME = Path.of(System.getProperty("simbad.spark.home", ""));
  private static final Path JAVA_OPTIONS = Path.of("src", "main", "java-options");
  private static final String HOST = "127.0.0.1";

  private final Path folder;
  private final String url;
  private final Process master;
  private final List<Process> workers = new ArrayList<>();

  LocalCluster(Path folder, int workerCount) throws IOException, InterruptedException {
    this.folder = folder;
    int port = freePort();
    url = "spark://" + HOST + ":" + port;
    master = start("master", "org.apache.spark.deploy.master.Master", "--port", "" + port);
    await("master", "I have been elected leader");
    for (int i = 1; i <= workerCount; i++) {
      workers.add(
          start(
              "worker" + i,
              "org.apache.spark.deploy.worker.Worker",
              "--cores",
              "1",
              "--memory",
              "1g",
              "--work-dir",
              folder.resolve("work" + i).toString(),
              url));
      await("worker" + i, "Successfully registered with master");
    }
  }

  private static int freePort() throws IOException {
    try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      return socket.getLocalPort();
    }
  }

  private Process start(String name, String daemon, String... arguments) throws IOException {
    List<String> command =
        new ArrayList<>(
            List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "@" + JAVA_OPTIONS.toAbsolutePath(),
                "-Dspark.master.rest.enabled=false",
                "-cp",
                HOME.resolve("jars") + File.separator + "*",
                daemon,
                "--host",
                HOST,
                "--webui-port",
                "0"));
    command.addAll(List.of(arguments));
    ProcessBuilder process = new ProcessBuilder(command).redirectErrorStream(true);
    process.environment().put("SPARK_HOME", HOME.toString());
    process.environment().put("SPARK_SCALA_VERSION", "2.13");
    process.environment().put("SPARK_LOCAL_IP", HOST);
    return process.redirectOutput(log(name).toFile()).start();
  }

  private Path log(String name) {
    return folder.resolve(name + ".log");
  }

  private void await(String name, String words) throws IOException, InterruptedException {
    while (!Files.readString(log(name)).contains(words)) {
      if (name.equals("master") && !master.isAlive()) {
        throw new IOException(Files.readString(log(name)));
      }
      Thread.sleep(50);
    }
  }

  String url() {
    return url;
  }

  /** Tells whether a worker was given a part in some work. */
  boolean hadExecutor(int worker) throws IOException {
    Path apps = folder.resolve("work" + (worker + 1));
    try (Stream<Path> entries = Files.walk(apps)) {
      return entries.anyMatch(path -> path.endsWith("stderr"));
    }
  }

  boolean isAlive(int worker) {
    return workers.get(worker).isAlive();
  }

  /** As when a machine loses its power: the worker and what it runs end at once. */
  void kill(int worker) {
    Process process = workers.get(worker);
    Stream.concat(Stream.of(process.toHandle()), process.descendants())
        .toList()
        .forEach(ProcessHandle::destroyForcibly);
  }

  @Override
  public void close() {
    for (int i = 0; i < workers.size(); i++) {
      kill(i);
    }
    master.destroyForcibly();
  }
}
