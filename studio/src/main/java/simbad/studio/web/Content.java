package simbad.studio.web;

import java.nio.charset.StandardCharsets;

/**
 * What an address is answered with.
 *
 * @param type media type, with the charset of a text
 * @param body text, sent as UTF-8
 */
public record Content(String type, String body) {
  /** Returns a page. */
  public static Content html(String body) {
    return new Content("text/html; charset=utf-8", body);
  }

  /** Returns a JSON text. */
  public static Content json(String body) {
    return new Content("application/json", body);
  }

  byte[] bytes() {
    return body.getBytes(StandardCharsets.UTF_8);
  }
}
