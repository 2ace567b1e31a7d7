package simbad.experiments.site;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Measured figures in pages. Between {@code <!-- figures: NAME -->} and {@code <!-- end of figures
 * -->} stands what {@code docs/figures/NAME.txt} holds, as a block of code: nobody types a figure.
 */
public final class FigureBlocks {
  private static final Pattern BLOCK =
      Pattern.compile(
          "(<!-- figures: ([a-z0-9-]+) -->\\n)(.*?)(<!-- end of figures -->)", Pattern.DOTALL);

  private FigureBlocks() {}

  /**
   * Returns a page with its blocks as the measured files have them.
   *
   * @param page Markdown
   * @param figures the folder of measured files
   * @throws IOException if one of them cannot be read
   */
  public static String filled(String page, Path figures) throws IOException {
    StringBuilder filled = new StringBuilder();
    Matcher block = BLOCK.matcher(page);
    while (block.find()) {
      String measured = Files.readString(figures.resolve(block.group(2) + ".txt"));
      String code = "\n" + measured.stripTrailing().indent(4).replaceAll(" +\n", "\n") + "\n";
      block.appendReplacement(
          filled, Matcher.quoteReplacement(block.group(1) + code + block.group(4)));
    }
    return block.appendTail(filled).toString();
  }
}
