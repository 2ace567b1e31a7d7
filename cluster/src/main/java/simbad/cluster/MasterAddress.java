package simbad.cluster;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Where a standalone cluster's master listens.
 *
 * @param host name or address
 * @param port in [1, 65535]
 */
record MasterAddress(String host, int port) {
  private static final String STANDALONE = "spark://";
  private static final String EXPECTED =
      "expected a running Spark master, " + STANDALONE + "HOST:PORT";
  private static final Pattern ADDRESS = Pattern.compile("(.+):(\\d{1,5})");
  private static final int GREATEST_PORT = 65_535;
  private static final int PATIENCE_MS = 5000;

  /**
   * Asks whether a master answers. Spark itself would ask for a minute, and then say only that a
   * job failed.
   *
   * @param master as Spark names it; whatever is no standalone cluster's is left to Spark
   * @throws IOException naming the host and what was expected, when none of the masters answers
   */
  static void requireAnswer(String master) throws IOException {
    if (!master.startsWith(STANDALONE)) {
      return;
    }
    List<String> faults = new ArrayList<>();
    for (MasterAddress address : all(master)) {
      String fault = address.fault();
      if (fault.isEmpty()) {
        return;
      }
      faults.add(fault);
    }
    throw new IOException("--spark " + master + ": " + String.join("; ", faults) + "; " + EXPECTED);
  }

  /** Several masters, of which one leads, are named with commas between. */
  private static List<MasterAddress> all(String master) throws IOException {
    List<MasterAddress> all = new ArrayList<>();
    for (String word : master.substring(STANDALONE.length()).split(",", -1)) {
      Matcher parts = ADDRESS.matcher(word);
      int port = parts.matches() ? Integer.parseInt(parts.group(2)) : 0;
      if (port < 1 || port > GREATEST_PORT) {
        throw new IOException(
            "--spark " + master + ": '" + word + "' is not HOST:PORT; " + EXPECTED);
      }
      all.add(new MasterAddress(parts.group(1), port));
    }
    return all;
  }

  /** Why nothing answers there; empty when something does. */
  private String fault() {
    InetSocketAddress there = new InetSocketAddress(host, port);
    if (there.isUnresolved()) {
      return "host " + host + " is not known";
    }
    try (Socket socket = new Socket()) {
      socket.connect(there, PATIENCE_MS);
      return "";
    } catch (IOException e) {
      return "host " + host + " does not answer on port " + port + " (" + e.getMessage() + ")";
    }
  }
}
