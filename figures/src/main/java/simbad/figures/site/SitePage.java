package simbad.figures.site;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.commonmark.Extension;
import org.commonmark.ext.gfm.tables.TablesExtension;
import org.commonmark.ext.heading.anchor.HeadingAnchorExtension;
import org.commonmark.node.AbstractVisitor;
import org.commonmark.node.Heading;
import org.commonmark.node.Image;
import org.commonmark.node.Link;
import org.commonmark.node.Node;
import org.commonmark.parser.Parser;
import org.commonmark.renderer.html.HtmlRenderer;
import org.commonmark.renderer.text.TextContentRenderer;

/**
 * One page of Markdown.
 *
 * @param source relative to the project
 * @param document as parsed; not to be changed
 */
record SitePage(Path source, Node document) {
  private static final List<Extension> EXTENSIONS =
      List.of(TablesExtension.create(), HeadingAnchorExtension.create());

  static SitePage of(Path source, String markdown) {
    return new SitePage(source, Parser.builder().extensions(EXTENSIONS).build().parse(markdown));
  }

  /** The first heading's words; the file's name where there is none. */
  String title() {
    for (Node node = document.getFirstChild(); node != null; node = node.getNext()) {
      if (node instanceof Heading heading) {
        return TextContentRenderer.builder().build().render(heading).strip();
      }
    }
    return String.valueOf(source.getFileName());
  }

  /** All words, for the search. */
  String text() {
    TextContentRenderer plain = TextContentRenderer.builder().extensions(EXTENSIONS).build();
    return plain.render(document).replaceAll("<!--.*?-->", "").replaceAll("\\s+", " ").strip();
  }

  String html() {
    return HtmlRenderer.builder()
        .extensions(EXTENSIONS)
        .attributeProviderFactory(
            context ->
                (node, tag, attributes) ->
                    attributes.computeIfPresent("href", (name, link) -> target(link)))
        .build()
        .render(document);
  }

  /** Where the page lies in the site. */
  String file() {
    return target(source.toString().replace('\\', '/'));
  }

  private static String target(String link) {
    return isOutside(link)
        ? link
        : link.replaceFirst("^README\\.md", "index.html")
            .replaceFirst("/README\\.md", "/index.html")
            .replaceFirst("\\.md(#|$)", ".html$1");
  }

  static boolean isOutside(String link) {
    return link.matches("[a-z]+:.*");
  }

  /** The places in the project that the page links to or shows, anchors left off. */
  List<Path> linked() {
    List<Path> linked = new ArrayList<>();
    document.accept(
        new AbstractVisitor() {
          @Override
          public void visit(Link link) {
            add(link.getDestination());
            visitChildren(link);
          }

          @Override
          public void visit(Image image) {
            add(image.getDestination());
          }

          private void add(String destination) {
            String place = destination.replaceFirst("#.*", "");
            if (!place.isEmpty() && !isOutside(place)) {
              linked.add(source.resolveSibling(place).normalize());
            }
          }
        });
    return List.copyOf(linked);
  }
}
