package simbad.figures.plot;

import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/**
 * PNG at a resolution.
 *
 * @param dpi pixels to the inch
 */
record PngWriter(int dpi) {
  private static final int MOST_DPI = 1200;
  private static final double POINTS_PER_INCH = 72;
  private static final double METRES_PER_INCH = 0.0254;
  private static final String FORMAT = "javax_imageio_png_1.0";

  PngWriter {
    if (dpi < 1 || dpi > MOST_DPI) {
      throw new IllegalArgumentException("dpi = " + dpi + " is not in [1, " + MOST_DPI + "]");
    }
  }

  byte[] write(PlotFigure figure) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    ImageWriter writer = ImageIO.getImageWritersByFormatName("png").next();
    // In memory: by itself ImageIO makes a temporary file, which stays when the process is killed.
    try (ImageOutputStream out = new MemoryCacheImageOutputStream(bytes)) {
      writer.setOutput(out);
      writer.write(new IIOImage(image(figure), null, metadata(writer, figure.caption())));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    } finally {
      writer.dispose();
    }
    return bytes.toByteArray();
  }

  private BufferedImage image(PlotFigure figure) {
    double scale = dpi / POINTS_PER_INCH;
    BufferedImage image =
        new BufferedImage(
            pixels(figure.widthPt(), scale),
            pixels(figure.heightPt(), scale),
            BufferedImage.TYPE_INT_RGB);
    Graphics2D g = image.createGraphics();
    hint(g);
    g.scale(scale, scale);
    figure.paint(g);
    g.dispose();
    return image;
  }

  private static int pixels(int points, double scale) {
    return Math.max(1, (int) Math.round(points * scale));
  }

  private static void hint(Graphics2D g) {
    g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
    // XChart lays its titles out with the context of the graphics: here as in the SVG.
    g.setRenderingHint(
        RenderingHints.KEY_FRACTIONALMETRICS, RenderingHints.VALUE_FRACTIONALMETRICS_ON);
  }

  private IIOMetadata metadata(ImageWriter writer, Caption caption) throws IOException {
    ImageTypeSpecifier type =
        ImageTypeSpecifier.createFromBufferedImageType(BufferedImage.TYPE_INT_RGB);
    IIOMetadata metadata = writer.getDefaultImageMetadata(type, writer.getDefaultWriteParam());
    IIOMetadataNode root = new IIOMetadataNode(FORMAT);
    root.appendChild(resolution());
    root.appendChild(texts(caption));
    metadata.mergeTree(FORMAT, root);
    return metadata;
  }

  private IIOMetadataNode resolution() {
    String perMetre = Long.toString(Math.round(dpi / METRES_PER_INCH));
    IIOMetadataNode node = new IIOMetadataNode("pHYs");
    node.setAttribute("pixelsPerUnitXAxis", perMetre);
    node.setAttribute("pixelsPerUnitYAxis", perMetre);
    node.setAttribute("unitSpecifier", "meter");
    return node;
  }

  /** International text, as provenance lines hold degree signs. */
  private static IIOMetadataNode texts(Caption caption) {
    IIOMetadataNode node = new IIOMetadataNode("iTXt");
    node.appendChild(text("Title", caption.title()));
    node.appendChild(text("Description", caption.provenance()));
    return node;
  }

  private static IIOMetadataNode text(String keyword, String words) {
    IIOMetadataNode node = new IIOMetadataNode("iTXtEntry");
    node.setAttribute("keyword", keyword);
    node.setAttribute("compressionFlag", "FALSE");
    node.setAttribute("compressionMethod", "0");
    node.setAttribute("languageTag", "en");
    node.setAttribute("translatedKeyword", "");
    node.setAttribute("text", words);
    return node;
  }
}
