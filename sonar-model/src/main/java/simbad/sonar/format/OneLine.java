package simbad.sonar.format;

import java.util.regex.Pattern;

/**
 * Texts that stand in one line: names, lines of a header, complaints. What comes from a file or a
 * command line may be megabytes long and hold line breaks and a terminal's control characters.
 */
public final class OneLine {
  /** Characters of a name. */
  public static final int LONGEST_NAME = 200;

  /** What is expected where a name stands. */
  public static final String NAME = "a name of at most " + LONGEST_NAME + " characters on one line";

  /** Characters of what a file says about itself in one line. */
  public static final int LONGEST_TEXT = 10_000;

  private static final String BREAK = "[\\p{Cc}\\u2028\\u2029]";
  private static final Pattern BREAKS = Pattern.compile(BREAK + "+");
  private static final Pattern BLANKS = Pattern.compile("\\s*" + BREAK + "+\\s*");

  private OneLine() {}

  /** Returns a text with a blank in the place of line breaks and control characters. */
  public static String of(String text) {
    // Most have none, and looking for blanks round a break takes time where blanks are many.
    return BREAKS.matcher(text).find() ? BLANKS.matcher(text).replaceAll(" ") : text;
  }

  /**
   * Returns a text on one line, its middle left out where it is long: the begin tells what is
   * there, the end what is wrong with it.
   *
   * @param text any
   * @param longest characters that are kept, at least 2
   */
  public static String of(String text, int longest) {
    int half = longest / 2;
    return of(
        text.length() <= longest
            ? text
            : text.substring(0, half) + "..." + text.substring(text.length() - half));
  }

  /** Tells whether a text can be a name: at most {@value #LONGEST_NAME} characters on one line. */
  public static boolean isName(String text) {
    return isWithin(text, LONGEST_NAME);
  }

  /** Tells whether a text can be a line of a header: at most {@value #LONGEST_TEXT} characters. */
  public static boolean isText(String text) {
    return isWithin(text, LONGEST_TEXT);
  }

  private static boolean isWithin(String text, int longest) {
    return text.length() <= longest && text.chars().noneMatch(OneLine::isBreak);
  }

  /** The same as {@link #BREAK}; a long table asks it of each row. */
  private static boolean isBreak(int character) {
    return Character.isISOControl(character) || character == 0x2028 || character == 0x2029;
  }
}
