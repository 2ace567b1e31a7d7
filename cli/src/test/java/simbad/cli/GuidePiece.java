package simbad.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.commonmark.node.AbstractVisitor;
import org.commonmark.node.Code;
import org.commonmark.node.FencedCodeBlock;
import org.commonmark.node.IndentedCodeBlock;
import org.commonmark.node.Node;
import org.commonmark.parser.IncludeSourceSpans;
import org.commonmark.parser.Parser;

/**
 * Code in a page of Markdown.
 *
 * @param line of the page where it begins, from 1
 * @param kind what a fence says it is, {@link #INDENTED}, or {@link #SPAN} within a line of words
 * @param text the code
 * @param names code among the words of the paragraph before a block, in their order
 */
record GuidePiece(int line, String kind, String text, List<String> names) {
  static final String INDENTED = "indented";
  static final String SPAN = "span";

  GuidePiece {
    names = List.copyOf(names);
  }

  /** All code of a page, in the page's order. */
  static List<GuidePiece> of(Path page) throws IOException {
    Node document =
        Parser.builder()
            .includeSourceSpans(IncludeSourceSpans.BLOCKS_AND_INLINES)
            .build()
            .parse(Files.readString(page));
    Collector collector = new Collector();
    document.accept(collector);
    return collector.pieces;
  }

  /** Lines of shell, those that end in a backslash joined with the next. */
  List<String> commands() {
    return text.replaceAll("\\\\\\n\\s*", "").lines().filter(line -> !line.isBlank()).toList();
  }

  private static final class Collector extends AbstractVisitor {
    private final List<GuidePiece> pieces = new ArrayList<>();

    @Override
    public void visit(FencedCodeBlock block) {
      // The code begins below the fence.
      add(block, 1, block.getInfo(), block.getLiteral());
    }

    @Override
    public void visit(IndentedCodeBlock block) {
      add(block, 0, INDENTED, block.getLiteral());
    }

    @Override
    public void visit(Code code) {
      add(code, 0, SPAN, code.getLiteral());
    }

    private void add(Node node, int below, String kind, String text) {
      int line = node.getSourceSpans().get(0).getLineIndex() + 1 + below;
      pieces.add(new GuidePiece(line, kind, text, names(node.getPrevious())));
    }

    private static List<String> names(Node paragraph) {
      List<String> names = new ArrayList<>();
      if (paragraph != null) {
        paragraph.accept(
            new AbstractVisitor() {
              @Override
              public void visit(Code code) {
                names.add(code.getLiteral());
              }
            });
      }
      return names;
    }
  }
}
