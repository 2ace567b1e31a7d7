package simbad.experiments.batch;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import simbad.experiments.report.TraceTable;
import simbad.experiments.run.Trace;
import simbad.experiments.workers.Job;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.TemporaryFolder;
import simbad.sonar.format.TextFile;

/**
 * The runs of a batch: its spec, and the contents of all files that the spec names. Thread-safe.
 */
public final class BatchJob implements Job<BatchOutcome> {
  private static final long serialVersionUID = 1;

  private final String specName;
  private final String spec;
  private final TreeMap<String, String> inputs;

  /** Made where the runs are done. */
  private transient volatile @Nullable Prepared prepared;

  private record Prepared(BatchPlan plan, ResultColumns columns) {}

  BatchJob(String specName, String spec, SortedMap<String, String> inputs) {
    this.specName = specName;
    this.spec = spec;
    this.inputs = new TreeMap<>(inputs);
  }

  /**
   * Reads a spec and all files that it names.
   *
   * @param specFile JSON
   * @param text of that file
   * @throws DataFormatException naming file, line and field of the first fault in any of them
   */
  public static BatchJob read(Path specFile, String text) throws DataFormatException {
    BatchSpec spec = BatchSpec.parse(specFile, text);
    InputPlace originals = InputPlace.originals(specFile);
    BatchPlan.read(spec, originals).checkEffects();
    return new BatchJob(specFile.toString(), text, InputFiles.gather(spec, originals));
  }

  /** Returns the spec's text. */
  String spec() {
    return spec;
  }

  /** Returns the texts of the files that the spec names, by the names of their copies. */
  SortedMap<String, String> inputs() {
    return Collections.unmodifiableSortedMap(inputs);
  }

  /** Returns how many runs there are. */
  public long size() {
    return prepared().plan().size();
  }

  /** Returns the columns of the results. */
  ResultColumns columns() {
    return prepared().columns();
  }

  /** Tells whether the batch keeps traces. */
  public boolean keepsTraces() {
    return prepared().plan().spec().traces();
  }

  @Override
  public BatchOutcome piece(long number) {
    BatchRun run = prepared().plan().run(number);
    ResultColumns columns = prepared().columns();
    try {
      Trace trace = run.drive();
      String text = keepsTraces() ? TraceTable.text(run.circuit().sensor().word(), trace) : "";
      return new BatchOutcome(number, false, columns.row(run, trace), text);
    } catch (RuntimeException | AssertionError | LinkageError | StackOverflowError e) {
      return new BatchOutcome(number, true, columns.row(run, e), "");
    }
  }

  private Prepared prepared() {
    Prepared now = prepared;
    if (now == null) {
      synchronized (this) {
        now = prepared == null ? prepare() : prepared;
        prepared = now;
      }
    }
    return now;
  }

  /** The readers of all formats take files: the contents stand in some for as long as it takes. */
  private Prepared prepare() {
    try {
      try (TemporaryFolder temporary = TemporaryFolder.create("simbad-batch")) {
        Path folder = temporary.path();
        write(folder);
        BatchSpec parsed = BatchSpec.parse(Path.of(specName), spec);
        BatchPlan plan = BatchPlan.read(parsed, InputPlace.copies(folder));
        return new Prepared(plan, new ResultColumns(plan));
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    } catch (DataFormatException e) {
      throw new IllegalStateException(e);
    }
  }

  /**
   * Writes the files that the spec names.
   *
   * @param folder that is there
   */
  void write(Path folder) throws IOException {
    for (var input : inputs.entrySet()) {
      Path file = folder.resolve(input.getKey());
      Files.createDirectories(file.getParent());
      TextFile.write(file, input.getValue());
    }
  }
}
