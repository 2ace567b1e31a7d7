package simbad.bench.link;

import com.fazecast.jSerialComm.SerialPort;
import com.fazecast.jSerialComm.SerialPortInvalidPortException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFileAttributes;
import java.nio.file.attribute.PosixFilePermission;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;

/** A serial port of this machine, 19200 baud 8N1, held for this program alone. */
public final class PortLink implements SerialLink {
  private static final int BAUD = 19200;
  private static final int DATA_BITS = 8;

  /** How long the library waits at a time; a close is noticed after that. */
  private static final int SLICE_MS = 20;

  /** A port that is gone answers at once that there is nothing, again and again. */
  private static final int QUICK_ANSWERS = 40;

  private static final long QUICK_NS = 5_000_000;

  /** ENOTTY of Linux and macOS: a device, but none with a line. */
  private static final int NOT_A_TERMINAL = 25;

  private final Path path;
  private final SerialPort port;
  private volatile boolean open = true;
  private int quickAnswers;

  private PortLink(Path path, SerialPort port) {
    this.path = path;
    this.port = port;
  }

  /** Returns the ports that the system lists; pseudo-terminals and links to ports are not. */
  public static List<String> ports() {
    return Arrays.stream(SerialPort.getCommPorts())
        .map(SerialPort::getSystemPortPath)
        .sorted()
        .toList();
  }

  /**
   * Opens a port.
   *
   * @param path a device, or a link to one such as the simulated board's
   * @throws IOException if there is none, another program holds it, or this user may not open it;
   *     in one line that says which
   */
  public static PortLink open(Path path) throws IOException {
    if (!Files.exists(path)) {
      throw new IOException(path + ": there is no such port; ports here: " + listed());
    }
    if (Files.isDirectory(path) || Files.isRegularFile(path)) {
      throw new IOException(path + ": is not a serial port; ports here: " + listed());
    }
    if (!Files.isReadable(path) || !Files.isWritable(path)) {
      throw new IOException(path + ": no permission; " + remedy(path));
    }
    return opened(path);
  }

  private static PortLink opened(Path path) throws IOException {
    SerialPort port;
    try {
      port = SerialPort.getCommPort(path.toString());
    } catch (SerialPortInvalidPortException e) {
      throw new IOException(path + ": is not a serial port; ports here: " + listed(), e);
    }
    port.setComPortParameters(BAUD, DATA_BITS, SerialPort.ONE_STOP_BIT, SerialPort.NO_PARITY);
    port.setComPortTimeouts(SerialPort.TIMEOUT_READ_SEMI_BLOCKING, SLICE_MS, 0);
    if (!port.openPort(0)) {
      if (port.getLastErrorCode() == NOT_A_TERMINAL) {
        throw new IOException(path + ": is not a serial port; ports here: " + listed());
      }
      throw new IOException(
          path
              + ": cannot be opened; most likely another program holds it (error "
              + port.getLastErrorCode()
              + ")");
    }
    return new PortLink(path, port);
  }

  private static String listed() {
    List<String> ports = ports();
    return ports.isEmpty() ? "none" : ports.stream().collect(Collectors.joining(", "));
  }

  /** Most ports belong to a group, whatever its name here. */
  private static String remedy(Path path) {
    try {
      PosixFileAttributes port = Files.readAttributes(path, PosixFileAttributes.class);
      if (port.permissions().contains(PosixFilePermission.GROUP_READ)
          && port.permissions().contains(PosixFilePermission.GROUP_WRITE)) {
        String group = port.group().getName();
        return "your user must be in the group %s (sudo usermod -aG %s USER; then log in again)"
            .formatted(group, group);
      }
      return "only its owner, %s, may open it".formatted(port.owner().getName());
    } catch (IOException | UnsupportedOperationException e) {
      return "your user must be in the group that may open it, dialout on most systems";
    }
  }

  @Override
  public int read(byte[] buffer, Duration limit) throws IOException {
    if (limit.isZero() && port.bytesAvailable() == 0) {
      requireOpen();
      return 0;
    }
    long endNs = System.nanoTime() + limit.toNanos();
    int count;
    do {
      count = slice(buffer);
    } while (count == 0 && System.nanoTime() < endNs);
    return count;
  }

  private int slice(byte[] buffer) throws IOException {
    requireOpen();
    long begunNs = System.nanoTime();
    int count = port.readBytes(buffer, buffer.length);
    boolean quick = count <= 0 && System.nanoTime() - begunNs < QUICK_NS;
    quickAnswers = quick ? quickAnswers + 1 : 0;
    if (count < 0 || quickAnswers > QUICK_ANSWERS) {
      close();
      throw gone();
    }
    return count;
  }

  private void requireOpen() throws IOException {
    if (!open) {
      throw new IOException(path + ": the port is closed");
    }
  }

  private IOException gone() {
    return new IOException(path + ": the port is gone");
  }

  @Override
  public void write(byte[] bytes) throws IOException {
    requireOpen();
    if (port.writeBytes(bytes, bytes.length) != bytes.length) {
      close();
      throw gone();
    }
  }

  @Override
  public synchronized void close() {
    if (open) {
      open = false;
      port.closePort();
    }
  }
}
