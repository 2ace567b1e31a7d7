package simbad.experiments.cli;

import java.io.IOException;
import java.io.InputStream;
import java.util.Objects;
import java.util.Properties;
import picocli.CommandLine.IVersionProvider;

/** The version and commit of this program, as the build wrote them down. */
final class BuildVersion implements IVersionProvider {
  @Override
  public String[] getVersion() throws IOException {
    return new String[] {"simbad " + text()};
  }

  /**
   * Version and commit in one line; a build of files that differ from the commit says so.
   *
   * @throws IOException when the program's jar cannot be read
   */
  static String text() throws IOException {
    Properties build = new Properties();
    try (InputStream in =
        Objects.requireNonNull(BuildVersion.class.getResourceAsStream("build.properties"))) {
      build.load(in);
    }
    String commit = build.getProperty("commit");
    boolean changed = Boolean.parseBoolean(build.getProperty("changed"));
    return build.getProperty("version")
        + " (commit "
        + commit
        + (changed ? ", with changes" : "")
        + ")";
  }
}
