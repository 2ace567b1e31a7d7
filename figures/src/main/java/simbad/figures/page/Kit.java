package simbad.figures.page;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Base64;
import simbad.sonar.format.ShippedText;

/** The style sheet and the script of every page, and what the browser is told of them. */
final class Kit {
  static final String STYLE = resource("page.css");
  static final String SCRIPT = "\n" + resource("page.js");

  /** Nothing is fetched, and no script runs but this one, whatever a name may hold. */
  static final String POLICY =
      "default-src 'none'; style-src 'unsafe-inline'; script-src 'sha256-"
          + sha256(SCRIPT)
          + "'; base-uri 'none'; form-action 'none'";

  private Kit() {}

  /** Lines end alike on every machine, whatever a checkout made of them. */
  private static String resource(String name) {
    return ShippedText.read(Kit.class, name).replace("\r\n", "\n");
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
