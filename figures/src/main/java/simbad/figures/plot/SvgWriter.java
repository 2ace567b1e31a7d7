package simbad.figures.plot;

import de.erichseifert.vectorgraphics2d.VectorGraphics2D;
import de.erichseifert.vectorgraphics2d.svg.SVGProcessor;
import de.erichseifert.vectorgraphics2d.util.PageSize;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import simbad.figures.markup.Markup;

/**
 * SVG by the library that XChart's own VectorGraphicsEncoder uses; that encoder paints a bare chart
 * only. The library's one id is made of the clip rectangle's coordinates, which are the same in
 * every run.
 */
final class SvgWriter {
  private static final Pattern ROOT = Pattern.compile("<svg\\b[^>]*>");

  private SvgWriter() {}

  static byte[] write(PlotFigure figure) {
    VectorGraphics2D graphics = new VectorGraphics2D();
    figure.paint(graphics);
    PageSize page = new PageSize(0, 0, figure.widthPt(), figure.heightPt());
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try {
      new SVGProcessor().getDocument(graphics.getCommands(), page).writeTo(out);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return described(out.toString(StandardCharsets.UTF_8), figure.caption());
  }

  /** All text is outlines; this is what search and screen readers find. */
  private static byte[] described(String svg, Caption caption) {
    String words =
        "<title>"
            + Markup.escaped(caption.title())
            + "</title><desc>"
            + Markup.escaped(caption.provenance())
            + "</desc>";
    String whole = ROOT.matcher(svg).replaceFirst("$0" + Matcher.quoteReplacement(words));
    return whole.getBytes(StandardCharsets.UTF_8);
  }
}
