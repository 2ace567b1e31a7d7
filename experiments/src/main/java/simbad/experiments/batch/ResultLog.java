package simbad.experiments.batch;

import de.siegmar.fastcsv.reader.CsvParseException;
import de.siegmar.fastcsv.reader.CsvReader;
import de.siegmar.fastcsv.reader.CsvRecord;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.TextFile;
import simbad.sonar.format.WholeFile;

/**
 * The results of a batch in its folder, results.csv, and the traces beside it.
 *
 * <p>Rows are added in the order of their numbers and each is on the disk before the next: at any
 * time the file is the first part of what it will be in the end, but for a last line that was torn
 * when the process ended. A run's trace is there before its row is.
 */
public final class ResultLog implements AutoCloseable {
  static final String RESULTS = "results.csv";
  private static final String TRACES = "traces";
  private static final int BLOCK = 1 << 16;

  private final Path file;
  private final Path traces;
  private final int digits;
  private final FileChannel channel;
  private long done;
  private long failed;

  private ResultLog(Path folder, long runs, FileChannel channel) {
    file = folder.resolve(RESULTS);
    traces = folder.resolve(TRACES);
    digits = Long.toString(runs - 1).length();
    this.channel = channel;
  }

  /**
   * Opens the results of a batch, cuts off a torn line, and counts what is there.
   *
   * @param folder of the batch
   * @param job the batch
   * @throws DataFormatException if the rows that are there are not the batch's first
   * @throws IOException if it cannot be written, or another process writes it
   */
  public static ResultLog open(Path folder, BatchJob job) throws IOException, DataFormatException {
    if (job.keepsTraces()) {
      Files.createDirectories(folder.resolve(TRACES));
    }
    FileChannel channel =
        FileChannel.open(
            folder.resolve(RESULTS),
            StandardOpenOption.CREATE,
            StandardOpenOption.READ,
            StandardOpenOption.WRITE);
    ResultLog log = new ResultLog(folder, job.size(), channel);
    try {
      log.lock();
      log.cutTornLine();
      log.begin(job);
      return log;
    } catch (IOException | DataFormatException | RuntimeException e) {
      channel.close();
      throw e;
    }
  }

  /** Until the process ends. */
  private void lock() throws IOException {
    FileLock lock;
    try {
      lock = channel.tryLock();
    } catch (OverlappingFileLockException e) {
      lock = null;
    }
    if (lock == null) {
      throw new IOException(file + ": another process is working on this batch");
    }
  }

  private void cutTornLine() throws IOException {
    long end = channel.size();
    ByteBuffer block = ByteBuffer.allocate(BLOCK);
    while (end > 0) {
      long begin = Math.max(0, end - BLOCK);
      block.clear().limit((int) (end - begin));
      while (block.hasRemaining() && channel.read(block, begin + block.position()) >= 0) {}
      int last = block.position() - 1;
      while (last >= 0 && block.get(last) != '\n') {
        last--;
      }
      if (last >= 0) {
        end = begin + last + 1;
        break;
      }
      end = begin;
    }
    channel.truncate(end);
    channel.position(end);
  }

  private void begin(BatchJob job) throws IOException, DataFormatException {
    if (channel.size() == 0) {
      try {
        write(job.columns().header());
      } catch (IOException e) {
        throw WholeFile.naming(file, e);
      }
      return;
    }
    List<String> names = job.columns().names();
    int status = names.indexOf(ResultColumns.STATUS);
    try (CsvReader<CsvRecord> rows =
        CsvReader.builder().allowMissingFields(true).ofCsvRecord(file)) {
      for (CsvRecord row : rows) {
        if (row.getStartingLineNumber() == 1) {
          check(row, row.getFields().equals(names), "the columns of this batch");
        } else {
          boolean next = done < job.size() && row.getField(0).equals(Long.toString(done));
          check(row, next, done < job.size() ? "the row of run " + done : "no more rows");
          check(row, row.getFieldCount() == names.size(), names.size() + " fields");
          done++;
          failed += row.getField(status).equals(ResultColumns.FAILED) ? 1 : 0;
        }
      }
    } catch (CsvParseException e) {
      throw DataFormatException.inFile(file, "is not what a batch wrote: " + e.getMessage());
    }
  }

  private void check(CsvRecord row, boolean right, String expected) throws DataFormatException {
    if (!right) {
      throw DataFormatException.inField(
          file,
          row.getStartingLineNumber(),
          ResultColumns.NUMBER,
          "found '" + row.getField(0) + "', expected " + expected);
    }
  }

  /**
   * Adds the next row.
   *
   * @param outcome of the run whose number is {@link #done}
   * @throws IOException if it cannot be written; the file is then as it was
   */
  public synchronized void append(BatchOutcome outcome) throws IOException {
    if (outcome.number() != done) {
      throw new IllegalArgumentException(
          "run " + outcome.number() + " is not the next, which is " + done);
    }
    try {
      if (!outcome.trace().isEmpty()) {
        String name = "%0" + digits + "d.csv";
        TextFile.write(traces.resolve(name.formatted(outcome.number())), outcome.trace());
      }
      write(outcome.row());
    } catch (IOException e) {
      throw new IOException(
          file.getParent()
              + ": run "
              + done
              + ": "
              + e.getMessage()
              + "; the runs before it are kept, the same command goes on",
          e);
    }
    done++;
    failed += outcome.failed() ? 1 : 0;
  }

  private void write(String line) throws IOException {
    long before = channel.position();
    try {
      ByteBuffer bytes = ByteBuffer.wrap(line.getBytes(StandardCharsets.UTF_8));
      while (bytes.hasRemaining()) {
        channel.write(bytes);
      }
      channel.force(false);
    } catch (IOException e) {
      channel.truncate(before);
      throw e;
    }
  }

  /** Returns how many runs are on the disk; they are the first ones. */
  public synchronized long done() {
    return done;
  }

  /** Returns how many of them failed. */
  public synchronized long failed() {
    return failed;
  }

  @Override
  public void close() throws IOException {
    channel.close();
  }
}
