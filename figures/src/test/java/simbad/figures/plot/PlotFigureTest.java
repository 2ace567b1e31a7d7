package simbad.figures.plot;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import javax.imageio.ImageIO;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PlotFigureTest {
  @Test
  void everyKindOfPicture_hasTheSameBytesTwice() {
    List<PlotFigure> again = List.copyOf(Gallery.figures().values());
    List<PlotFigure> figures = List.copyOf(Gallery.figures().values());
    for (int i = 0; i < figures.size(); i++) {
      checkSameBytes(figures.get(i), again.get(i));
    }
  }

  @Test
  void oneFigure_writesTheSameBytesAgain() {
    PlotFigure figure = small(PlotSamples.CAPTION);
    byte[] svg = figure.svg();
    byte[] png = figure.png(100);
    figure.png(37);
    assertArrayEquals(svg, figure.svg());
    assertArrayEquals(png, figure.png(100));
  }

  @Test
  void locale_changesNothing() {
    PlotFigure here = Gallery.errors().figure();
    byte[] svg = here.svg();
    Locale before = Locale.getDefault();
    Locale.setDefault(Locale.forLanguageTag("ar-EG"));
    try {
      assertArrayEquals(svg, Gallery.errors().figure().svg());
    } finally {
      Locale.setDefault(before);
    }
  }

  private static void checkSameBytes(PlotFigure first, PlotFigure second) {
    assertArrayEquals(first.png(60), second.png(60));
    assertArrayEquals(first.svg(), second.svg());
  }

  @Test
  void svg_isWellFormedAndSaysTitleAndProvenance() throws Exception {
    Caption caption = new Caption("r < T & \"so\" $1", "table: reconstructed, 90° to 270°");
    byte[] svg = small(caption).svg();
    var factory = DocumentBuilderFactory.newInstance();
    factory.setFeature("http://apache.org/xml/features/nonvalidating/load-external-dtd", false);
    var root = factory.newDocumentBuilder().parse(new ByteArrayInputStream(svg));
    assertEquals(caption.title(), text(root, "title"));
    assertEquals(caption.provenance(), text(root, "desc"));
  }

  private static String text(org.w3c.dom.Document document, String element) {
    return document.getElementsByTagName(element).item(0).getTextContent();
  }

  @Test
  void provenance_isDrawn() {
    PlotFigure silent = small(new Caption("t", "."));
    PlotFigure loud = small(new Caption("t", "table: reconstructed"));
    assertTrue(pathBytes(loud) > pathBytes(silent) + 500, "outlines of the words");
    assertEquals("table: reconstructed", loud.caption().provenance());
  }

  private static int pathBytes(PlotFigure figure) {
    return new String(figure.svg(), StandardCharsets.UTF_8)
        .replaceAll("<desc>.*</desc>", "")
        .length();
  }

  @Test
  void longProvenance_takesMoreLines() {
    PlotFigure figure = small(new Caption("t", "table: reconstructed from words ".repeat(12)));
    assertTrue(figure.heightPt() > small(PlotSamples.CAPTION).heightPt() + 30);
  }

  @Test
  void caption_mustSaySomething() {
    assertThrows(IllegalArgumentException.class, () -> new Caption("title", " "));
    assertThrows(IllegalArgumentException.class, () -> new Caption("", "table: measured"));
  }

  @ParameterizedTest
  @ValueSource(ints = {72, 150})
  void png_hasTheResolutionAskedFor(int dpi) throws IOException {
    PlotFigure figure = small(PlotSamples.CAPTION);
    byte[] png = figure.png(dpi);
    var image = ImageIO.read(new ByteArrayInputStream(png));
    assertEquals(Math.round(figure.widthPt() * dpi / 72.0), image.getWidth());
    assertEquals(Math.round(figure.heightPt() * dpi / 72.0), image.getHeight());
    String raw = new String(png, StandardCharsets.ISO_8859_1);
    assertTrue(raw.contains("pHYs") && raw.contains(PlotSamples.CAPTION.provenance()));
  }

  @ParameterizedTest
  @ValueSource(ints = {0, -1, 1201})
  void resolution_outsideItsRange_isRefused(int dpi) {
    PlotFigure figure = small(PlotSamples.CAPTION);
    assertThrows(IllegalArgumentException.class, () -> figure.png(dpi));
  }

  @Test
  void files_holdTheBytes(@TempDir Path folder) throws IOException {
    PlotFigure figure = small(PlotSamples.CAPTION);
    Files.write(folder.resolve("a.png"), figure.png(72));
    Files.write(folder.resolve("a.svg"), figure.svg());
    assertArrayEquals(figure.png(72), Files.readAllBytes(folder.resolve("a.png")));
    assertArrayEquals(figure.svg(), Files.readAllBytes(folder.resolve("a.svg")));
  }

  @Test
  void gallery_writesEveryPicture(@TempDir Path folder) throws IOException {
    Gallery.main(new String[] {folder.toString()});
    try (var files = Files.list(folder)) {
      assertEquals(2L * Gallery.figures().size(), files.count());
    }
  }

  private static PlotFigure small(Caption caption) {
    return new PolarPlot(caption, List.of(PlotSamples.tableSeries()), List.of()).figure();
  }
}
