package simbad.studio.web;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Supplier;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import simbad.sonar.format.ShippedText;

/**
 * Pages out of the jar with all the scripts and style sheets that they link to. A link is a name in
 * quotes that begins with {@code ./}; each is given the token along, without which nothing is
 * answered.
 */
public final class PageFiles {
  private static final String OWN = "/simbad/studio/page/";

  /** The library of charts; its files link to nothing. */
  private static final String CHARTS = "/META-INF/resources/webjars/uplot/1.6.30/dist/";

  private static final String OF_CHARTS = "uPlot.";
  private static final Pattern LINK = Pattern.compile("([\"'])\\./([A-Za-z.-]+\\.(?:js|css))\\1");

  private final String query;
  private final Map<String, Supplier<Content>> answers = new LinkedHashMap<>();

  private PageFiles(String query) {
    this.query = query;
  }

  /**
   * Reads pages and what they link to, and so on.
   *
   * @param guard whose token the links carry
   * @param pages names of HTML files by the paths at which they are answered
   * @return answers by path
   * @throws IOException if a file cannot be read
   */
  public static Map<String, Supplier<Content>> of(Guard guard, Map<String, String> pages)
      throws IOException {
    PageFiles files = new PageFiles(guard.query());
    for (Map.Entry<String, String> page : pages.entrySet()) {
      Content html =
          Content.html(files.linked(ShippedText.read(PageFiles.class, OWN + page.getValue())));
      files.answers.put(page.getKey(), () -> html);
    }
    return files.answers;
  }

  /** Returns a text whose links have the token, after what they lead to has been read. */
  private String linked(String text) throws IOException {
    Matcher links = LINK.matcher(text);
    for (String name : links.results().map(link -> link.group(2)).distinct().toList()) {
      if (!answers.containsKey("/" + name)) {
        add(name);
      }
    }
    return links.reset().replaceAll(this::withToken);
  }

  private String withToken(MatchResult link) {
    String quote = link.group(1);
    return Matcher.quoteReplacement(quote + "./" + link.group(2) + query + quote);
  }

  private void add(String name) throws IOException {
    String type = name.endsWith(".js") ? "text/javascript" : "text/css";
    boolean ofCharts = name.startsWith(OF_CHARTS);
    // There before it is followed: two files may link to each other.
    answers.put("/" + name, () -> Content.html(""));
    String text = ShippedText.read(PageFiles.class, (ofCharts ? CHARTS : OWN) + name);
    Content content = new Content(type + "; charset=utf-8", ofCharts ? text : linked(text));
    answers.put("/" + name, () -> content);
  }
}
