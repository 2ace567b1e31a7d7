package simbad.cli;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Where a page shall be: {@code PORT} on this computer only, or {@code ADDRESS:PORT}. */
final class WebArgument {
  private static final Pattern FORM = Pattern.compile("(?:(\\[?[0-9A-Fa-f.:]+\\]?):)?(\\d{1,5})");
  private static final int GREATEST_PORT = 65535;

  private WebArgument() {}

  /** Empty for what is no such place; names are none, for they may mean any computer. */
  static Optional<InetSocketAddress> parse(String word) {
    Matcher matcher = FORM.matcher(word);
    if (!matcher.matches() || Integer.parseInt(matcher.group(2)) > GREATEST_PORT) {
      return Optional.empty();
    }
    int port = Integer.parseInt(matcher.group(2));
    String address = matcher.group(1);
    try {
      InetAddress at =
          address == null ? InetAddress.getLoopbackAddress() : InetAddress.getByName(address);
      return Optional.of(new InetSocketAddress(at, port));
    } catch (UnknownHostException e) {
      return Optional.empty();
    }
  }
}
