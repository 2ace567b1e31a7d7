package simbad.studio.web;

import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.SecureRandom;
import java.util.HexFormat;
import java.util.Set;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/**
 * Who is answered: who has the token. At the loopback address only programs of this computer, and
 * no page of another site, whatever name that site has given to this computer.
 */
public final class Guard {
  private static final int TOKEN_BYTES = 16;
  private static final Set<String> LOCAL_NAMES = Set.of("localhost", "127.0.0.1", "[::1]");

  /** What may follow the token in an address: what is asked about. */
  private static final Pattern ABOUT = Pattern.compile("&path=[^&]*$");

  private final String token = secret();
  private final boolean localOnly;

  private Guard(boolean localOnly) {
    this.localOnly = localOnly;
  }

  /** Returns the guard for an address, with a token of its own. */
  public static Guard of(InetAddress address) {
    return new Guard(address.isLoopbackAddress());
  }

  private static String secret() {
    byte[] bytes = new byte[TOKEN_BYTES];
    new SecureRandom().nextBytes(bytes);
    return HexFormat.of().formatHex(bytes);
  }

  /** Returns what every address must end with: the token. */
  public String query() {
    return "?token=" + token;
  }

  /**
   * Whether a request is answered.
   *
   * @param query of its address
   * @param host of its header
   * @param origin of its header: the site whose page asks
   */
  boolean admits(@Nullable String query, @Nullable String host, @Nullable String origin) {
    boolean own = origin == null || origin.equals("http://" + host);
    return own
        && isToken("?" + ABOUT.matcher(String.valueOf(query)).replaceFirst(""))
        && (!localOnly || isLocal(String.valueOf(host)));
  }

  /** Takes the same time for every wrong one. */
  private boolean isToken(String query) {
    return MessageDigest.isEqual(
        query.getBytes(StandardCharsets.UTF_8), query().getBytes(StandardCharsets.UTF_8));
  }

  private static boolean isLocal(String host) {
    return LOCAL_NAMES.contains(host.replaceFirst(":\\d+$", ""));
  }
}
