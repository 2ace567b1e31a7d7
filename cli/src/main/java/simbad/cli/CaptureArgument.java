package simbad.cli;

import java.nio.file.Path;
import picocli.CommandLine.Parameters;
import simbad.experiments.bench.CaptureFolder;

/** {@code DIR} of the commands that go on with a capture. */
final class CaptureArgument {
  @Parameters(paramLabel = "DIR", description = "Folder of the capture.")
  private Path folder = Path.of("");

  CaptureFolder folder() {
    return new CaptureFolder(folder);
  }
}
