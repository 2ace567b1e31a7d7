package simbad.figures.web;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Base64;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The Content-Security-Policy of a page that brings its script and its style along. */
public final class PagePolicy {
  private PagePolicy() {}

  /**
   * Returns the policy: the browser runs the page's own script elements and no other script, uses
   * its own style elements, asks nobody but the server, and shows the page in no frame.
   *
   * @param page HTML whose script and style elements have no attributes
   */
  public static String of(String page) {
    return "default-src 'none'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'; connect-src 'self'"
        + sources("style", page)
        + sources("script", page);
  }

  private static String sources(String element, String page) {
    StringBuilder sources = new StringBuilder("; ").append(element).append("-src");
    Matcher matcher =
        Pattern.compile("<" + element + ">(.*?)</" + element + ">", Pattern.DOTALL).matcher(page);
    while (matcher.find()) {
      sources.append(" 'sha256-").append(digest(matcher.group(1))).append('\'');
    }
    return sources.toString();
  }

  private static String digest(String text) {
    try {
      byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
      return Base64.getEncoder().encodeToString(MessageDigest.getInstance("SHA-256").digest(bytes));
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every Java has SHA-256", e);
    }
  }
}
