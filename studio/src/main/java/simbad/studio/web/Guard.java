package simbad.studio.web;

import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.SecureRandom;
import java.util.HexFormat;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * Who is answered. At the loopback address: programs of this computer, but no page of another site,
 * whatever name that site has given to this computer. At another address: who has the token.
 */
public final class Guard {
  private static final int TOKEN_BYTES = 16;
  private static final Set<String> LOCAL_NAMES = Set.of("localhost", "127.0.0.1", "[::1]");

  private final Optional<String> token;
  private final boolean localOnly;

  private Guard(Optional<String> token, boolean localOnly) {
    this.token = token;
    this.localOnly = localOnly;
  }

  /** Returns the guard for an address, with a token of its own where one is needed. */
  public static Guard of(InetAddress address) {
    boolean local = address.isLoopbackAddress();
    return new Guard(local ? Optional.empty() : Optional.of(secret()), local);
  }

  /** Returns the guard of a page that does work for who asks: it always wants its token. */
  public static Guard withToken(InetAddress address) {
    return new Guard(Optional.of(secret()), address.isLoopbackAddress());
  }

  private static String secret() {
    byte[] bytes = new byte[TOKEN_BYTES];
    new SecureRandom().nextBytes(bytes);
    return HexFormat.of().formatHex(bytes);
  }

  /** Returns what every address must end with: the token, or nothing. */
  public String query() {
    return token.map(secret -> "?token=" + secret).orElse("");
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
        && (token.isEmpty() || isToken("?" + query))
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
