package simbad.cli;

import java.io.IOException;
import java.io.StringReader;
import java.util.Properties;
import java.util.regex.Pattern;
import picocli.CommandLine.IVersionProvider;
import simbad.sonar.format.ShippedText;

/** The version and commit of this program, as the build wrote them down. */
final class BuildVersion implements IVersionProvider {
  // Where there is no git, the build leaves a placeholder or nothing.
  private static final Pattern COMMIT = Pattern.compile("[0-9a-f]{40,64}(\\+changes)?");

  @Override
  public String[] getVersion() throws IOException {
    return new String[] {"simbad " + text()};
  }

  /**
   * Version and commit in one line; {@code +changes} follows when files differed from the commit.
   *
   * @throws IOException when the program's jar cannot be read
   */
  static String text() throws IOException {
    Properties build = new Properties();
    build.load(new StringReader(ShippedText.read(BuildVersion.class, "build.properties")));
    String commit = build.getProperty("commit");
    String known = COMMIT.matcher(commit).matches() ? commit : "unknown";
    return build.getProperty("version") + " (commit " + known + ")";
  }
}
