package simbad.figures.site;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.BinaryOperator;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Measured figures in pages, so that nobody types one. Between {@code <!-- figures: NAME -->} and
 * {@code <!-- end of figures -->} stands what {@code docs/figures/NAME.txt} holds, as a block of
 * code; between {@code <!-- figure: NAME -->} and {@code <!-- end -->}, within a line, the one line
 * that it holds. Both say at which commit it was measured, as {@code docs/figures/origins.csv} has
 * it.
 */
public final class FigureBlocks {
  private static final Pattern BLOCK =
      Pattern.compile(
          "(<!-- figures: ([A-Za-z0-9-]+) -->\\n)(.*?)(<!-- end of figures -->)", Pattern.DOTALL);

  private static final Pattern LINE =
      Pattern.compile("(<!-- figure: ([A-Za-z0-9-]+) -->)(.*?)(<!-- end -->)");

  private FigureBlocks() {}

  /**
   * Returns a page with its blocks as the measured files have them.
   *
   * @param page Markdown
   * @param figures the folder of measured files
   * @throws IOException if one of them cannot be read
   */
  public static String filled(String page, Path figures) throws IOException {
    String blocks =
        replaced(
            BLOCK,
            page,
            figures,
            (text, origin) ->
                "\n"
                    + text.stripTrailing().indent(4).replaceAll(" +\n", "\n")
                    + "\nMeasured at commit "
                    + origin
                    + ".\n");
    return replaced(LINE, blocks, figures, (text, origin) -> text.strip() + " (" + origin + ")");
  }

  private static String replaced(
      Pattern place, String page, Path figures, BinaryOperator<String> shown) throws IOException {
    List<FigureOrigin> origins = FigureOrigin.read(figures);
    StringBuilder filled = new StringBuilder();
    Matcher found = place.matcher(page);
    while (found.find()) {
      String measured = Files.readString(figures.resolve(found.group(2) + ".txt"));
      String origin = FigureOrigin.of(found.group(2), origins).commit();
      found.appendReplacement(
          filled,
          Matcher.quoteReplacement(
              found.group(1) + shown.apply(measured, origin) + found.group(4)));
    }
    return found.appendTail(filled).toString();
  }
}
