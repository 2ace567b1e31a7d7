package simbad.figures.page;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Base64;
import java.util.List;
import simbad.sonar.format.ShippedText;

/**
 * A report that is written from top to bottom: one file with its style sheet and its script in it,
 * which asks for nothing else and says so to the browser.
 */
public final class Page {
  private static final String HEAD =
      """
      <!DOCTYPE html>
      <html lang="en">
      <head>
      <meta charset="utf-8">
      <meta http-equiv="Content-Security-Policy" content="%s">
      <meta name="viewport" content="width=device-width, initial-scale=1">
      <title>%s</title>
      <style>
      %s</style>
      </head>
      <body>
      <main>
      """;

  /** Lines end alike on every machine, whatever a checkout made of them. */
  private static final String STYLE = resource("page.css");

  private static final String SCRIPT = "\n" + resource("page.js");

  /** Nothing is fetched, and no script runs but this one, whatever a name may hold. */
  private static final String POLICY =
      "default-src 'none'; style-src 'unsafe-inline'; script-src 'sha256-"
          + sha256(SCRIPT)
          + "'; base-uri 'none'; form-action 'none'";

  private final StringBuilder text = new StringBuilder();

  /**
   * Begins a page.
   *
   * @param title for the browser
   * @param heading on the page
   */
  public Page(String title, String heading) {
    text.append(HEAD.formatted(POLICY, Html.of(title), STYLE));
    add(Html.element("h1", "", heading).line());
  }

  /** Adds a piece as it is. */
  public Page add(Html piece) {
    text.append(piece);
    return this;
  }

  /** Begins a section. */
  public Page section(String title) {
    return add(Html.element("h2", "", title).line());
  }

  /** Begins a part of a section. */
  public Page part(String title) {
    return add(Html.element("h3", "", title).line());
  }

  /** Adds a paragraph. */
  public Page say(Object... parts) {
    return add(Html.element("p", "", parts).line());
  }

  /** Adds the answer, in large letters. */
  public Page verdict(Object... parts) {
    return add(Html.styled("p", "verdict", parts).line());
  }

  /** Adds an answer that says that something was missed, in large letters. */
  public Page missed(Object... parts) {
    return add(Html.styled("p", "verdict missed", parts).line());
  }

  /** Adds what a reader must not pass over. */
  public Page note(Object... parts) {
    return add(Html.styled("p", "note", parts).line());
  }

  /** Adds what a reader may pass over. */
  public Page soft(Object... parts) {
    return add(Html.styled("p", "soft", parts).line());
  }

  /** Adds a list. */
  public Page list(List<Html> items) {
    return add(listed(items));
  }

  /** Adds a table. */
  public Page table(Table table) {
    return add(table.html());
  }

  /** Adds pictures side by side, as many as there is room for. */
  public Page pictures(List<PagePicture> pictures) {
    Html all = Html.all(pictures.stream().map(PagePicture::html).toList());
    return add(Html.styled("div", "figures", Html.raw("\n"), all).line());
  }

  /**
   * Returns a list.
   *
   * @param items from top to bottom
   */
  public static Html listed(List<Html> items) {
    Html all = Html.all(items.stream().map(item -> Html.element("li", "", item).line()).toList());
    return Html.element("ul", "", Html.raw("\n"), all).line();
  }

  /**
   * Returns a piece that is opened by whoever wants to see it.
   *
   * @param summary its words while it is closed
   * @param piece what it holds
   */
  public static Html folded(String summary, Html piece) {
    return Html.element("details", "", Html.element("summary", "", summary).line(), piece).line();
  }

  /**
   * Returns a framed part of a page.
   *
   * @param id its name in the page; may be empty
   * @param title above it
   * @param parts what it holds
   */
  public static Html panel(String id, String title, Object... parts) {
    String name = id.isEmpty() ? "" : Html.attribute("id", id);
    return Html.element(
            "section",
            Html.attribute("class", "panel") + name,
            Html.element("h3", "", title).line(),
            Html.of(parts))
        .line();
  }

  /** Returns the whole page. */
  public String html() {
    return text + "</main>\n<script>" + SCRIPT + "</script>\n</body>\n</html>\n";
  }

  private static String resource(String name) {
    return ShippedText.read(Page.class, name).replace("\r\n", "\n");
  }

  private static String sha256(String text) {
    try {
      MessageDigest hash = MessageDigest.getInstance("SHA-256");
      return Base64.getEncoder().encodeToString(hash.digest(text.getBytes(StandardCharsets.UTF_8)));
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every Java has SHA-256", e);
    }
  }
}
