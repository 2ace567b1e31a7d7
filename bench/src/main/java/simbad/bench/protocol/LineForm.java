package simbad.bench.protocol;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Function;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** What a kind of line looks like, and what becomes of it. */
record LineForm(Pattern pattern, Function<MatchResult, FrameLine> made) {
  private static final List<LineForm> ALL =
      List.of(
          form(
              "P (\\d{1,5}) (\\d{1,5}) (echo|no-echo|too-near) (\\d{1,5})",
              m -> ping(m, OptionalInt.of(number(m, 2)))),
          form("P (\\d{1,5}) (low|high) (stuck) (\\d{1,5})", m -> ping(m, OptionalInt.empty())),
          form(
              "A (\\d{1,3}) ([0-9A-F]{2}) (\\d{1,5})",
              m ->
                  new FrameLine.Answer(
                      number(m, 1), Integer.parseInt(m.group(2), 16), number(m, 3))),
          form(
              "I (\\S+) (\\S+) (\\S+) (\\S+)",
              m -> new FrameLine.Identity(m.group(1), m.group(2), m.group(3), m.group(4))));

  private static LineForm form(String pattern, Function<MatchResult, FrameLine> made) {
    return new LineForm(Pattern.compile(pattern), made);
  }

  private static FrameLine ping(MatchResult match, OptionalInt echoUs) {
    PingStatus status = PingStatus.find(match.group(3)).orElseThrow();
    return new FrameLine.Ping(number(match, 1), status, echoUs, number(match, 4));
  }

  private static int number(MatchResult match, int group) {
    return Integer.parseInt(match.group(group));
  }

  /** What the text before a checksum says; empty when it is no line of frame mode. */
  static Optional<FrameLine> parse(String text) {
    for (LineForm form : ALL) {
      Matcher matcher = form.pattern.matcher(text);
      if (matcher.matches()) {
        return Optional.of(form.made.apply(matcher));
      }
    }
    return Optional.empty();
  }
}
