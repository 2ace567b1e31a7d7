package simbad.experiments.batch;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.JsonInput;
import simbad.sonar.format.TextFile;

/**
 * What stands in a batch's folder before the first run: the spec, copies of the files that it
 * names, and batch.json, which says by which program and from what the results are.
 */
public final class BatchFolder {
  private static final String FORMAT = "simbad-batch-results/1";
  private static final String SPEC = "spec.json";
  private static final String INPUTS = "inputs";
  private static final String ORIGIN = "batch.json";

  private BatchFolder() {}

  /** Tells whether a batch was begun in a folder. */
  public static boolean isBegun(Path folder) {
    return Files.exists(folder.resolve(ORIGIN));
  }

  /**
   * Writes all that is needed to go on.
   *
   * @param folder exists and is empty
   * @param job of the batch
   * @param version of this program
   * @throws IOException if something cannot be written
   */
  public static void write(Path folder, BatchJob job, String version) throws IOException {
    TextFile.write(folder.resolve(SPEC), job.spec());
    job.write(Files.createDirectory(folder.resolve(INPUTS)));
    TextFile.write(
        folder.resolve(ORIGIN),
        "{\n  \"format\": \"%s\",\n  \"version\": \"%s\",\n  \"sha256\": \"%s\",\n  \"runs\": %d\n}\n"
            .formatted(FORMAT, version, sha256(job), job.size()));
  }

  /**
   * Reads a batch that was begun. The files that the spec names are not looked at, but their
   * copies.
   *
   * @param folder in which it was begun
   * @param specFile as the user names it
   * @param text of the spec
   * @param version of this program
   * @throws DataFormatException if it was begun with another spec or by another version, or was
   *     changed since
   */
  public static BatchJob read(Path folder, Path specFile, String text, String version)
      throws DataFormatException {
    Path file = folder.resolve(ORIGIN);
    JsonInput origin = JsonInput.parse(file, TextFile.read(file));
    if (!origin.text("format").equals(FORMAT)) {
      throw origin.field("format").isNot("\"" + FORMAT + "\"");
    }
    if (!TextFile.read(folder.resolve(SPEC)).equals(text)) {
      throw DataFormatException.inFile(
          folder.resolve(SPEC),
          "is not the same spec as " + specFile + "; use that spec, or another --out");
    }
    if (!origin.text("version").equals(version)) {
      throw origin
          .field("version")
          .fault(
              "begun by "
                  + origin.text("version")
                  + ", this is "
                  + version
                  + "; use another --out");
    }
    BatchJob job = new BatchJob(specFile.toString(), text, copies(folder.resolve(INPUTS)));
    if (!origin.text("sha256").equals(sha256(job))) {
      throw origin.field("sha256").fault("spec or inputs were changed since the batch began");
    }
    return job;
  }

  private static SortedMap<String, String> copies(Path folder) throws DataFormatException {
    SortedMap<String, String> texts = new TreeMap<>();
    try (var entries = Files.walk(folder)) {
      for (Path file : entries.filter(Files::isRegularFile).toList()) {
        texts.put(folder.relativize(file).toString().replace('\\', '/'), TextFile.read(file));
      }
    } catch (IOException e) {
      throw DataFormatException.inFile(folder, "is not a folder that can be read");
    }
    return texts;
  }

  /** Of the spec and the files, each with its name and length, so that none runs into another. */
  private static String sha256(BatchJob job) {
    try {
      MessageDigest hash = MessageDigest.getInstance("SHA-256");
      add(hash, SPEC, job.spec());
      for (Map.Entry<String, String> input : job.inputs().entrySet()) {
        add(hash, input.getKey(), input.getValue());
      }
      return HexFormat.of().formatHex(hash.digest());
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every Java has SHA-256", e);
    }
  }

  private static void add(MessageDigest hash, String name, String text) {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    hash.update((name + "\n" + bytes.length + "\n").getBytes(StandardCharsets.UTF_8));
    hash.update(bytes);
  }
}
