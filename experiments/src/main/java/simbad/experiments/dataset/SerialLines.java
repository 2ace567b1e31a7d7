package simbad.experiments.dataset;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * What a board prints to a serial monitor, as lines of a table: {@code 12:03:44.123 -> Distance:
 * 34.2 cm}. The time before the arrow becomes a column of its own; so does each quantity with a
 * label, and its unit goes to the column's name.
 */
final class SerialLines {
  /** The name of the column with the times before the arrows. */
  static final String TIME = "time";

  private static final Pattern STAMPED =
      Pattern.compile("\\s*(\\d\\d?:\\d\\d:\\d\\d(?:[.,]\\d+)?)\\s*->\\s?(.*)");

  /** A label, a number, perhaps a unit, and what stands before the next label. */
  private static final Pattern LABELLED =
      Pattern.compile(
          "([\\p{L}_][\\p{L}\\d_ ]{0,30}?)\\s{0,3}[:=]\\s{0,3}"
              + "([+-]?\\d+(?:[.,]\\d+)?)\\s{0,3}([\\p{L}\u00b5\u00b0\"]{1,15})?\\s{0,3}(?:[,;|\\t]\\s{0,3}|$|(?<=[ \\t]))");

  /** Of the lines that are looked at, so many have to look alike. */
  private static final double MOST = 0.5;

  private static final int SAMPLE = 200;

  private SerialLines() {}

  /** A line with its time, empty where it has none. */
  private record Said(String time, String text) {
    static Said of(String line) {
      Matcher stamped = STAMPED.matcher(line);
      return stamped.matches()
          ? new Said(stamped.group(1), stamped.group(2).strip())
          : new Said("", line.strip());
    }
  }

  /**
   * Rewrites lines.
   *
   * @param plain the lines of a log; what is none of the table is an empty line
   * @return as many lines, with tabs where they had labels, else as they stood behind their arrows;
   *     empty where most lines have neither
   */
  static Optional<Table> of(String[] plain) {
    List<String> sample = Arrays.stream(plain).filter(l -> !l.isBlank()).limit(SAMPLE).toList();
    double stamped = share(sample, line -> STAMPED.matcher(line).matches());
    double labelled = share(sample, line -> !quantities(Said.of(line).text()).isEmpty());
    if (labelled > MOST) {
      return Optional.of(labelled(plain, stamped > MOST));
    }
    return stamped > MOST ? Optional.of(stamped(plain)) : Optional.empty();
  }

  /**
   * Lines of a table.
   *
   * @param names of its columns; none where the lines have them or nobody has
   * @param lines as many as there were
   * @param stamps the time of each line, where lines have one; else none
   */
  record Table(List<String> names, List<String> lines, List<String> stamps) {
    /** Copies all. */
    Table {
      names = List.copyOf(names);
      lines = List.copyOf(lines);
      stamps = List.copyOf(stamps);
    }
  }

  private interface Test {
    boolean holds(String line);
  }

  private static double share(List<String> lines, Test test) {
    long count = lines.stream().filter(test::holds).count();
    return lines.isEmpty() ? 0 : (double) count / lines.size();
  }

  /** The numbers of a line by their labels, with the units; none if it holds anything else. */
  private static Map<String, String> quantities(String text) {
    Map<String, String> found = new LinkedHashMap<>();
    Matcher next = LABELLED.matcher(text);
    int end = 0;
    while (end < text.length() && next.find(end) && next.start() == end && next.end() > end) {
      String unit = next.group(3) == null ? "" : "_" + next.group(3);
      found.put(next.group(1).strip() + unit, next.group(2));
      end = next.end();
    }
    return end == text.length() ? found : Map.of();
  }

  private static Table stamped(String[] plain) {
    List<String> lines = new ArrayList<>();
    List<String> stamps = new ArrayList<>();
    for (String line : plain) {
      Said said = Said.of(line);
      lines.add(said.text());
      stamps.add(said.time());
    }
    return new Table(List.of(), lines, stamps);
  }

  /** What is said without a label, such as "Out of range", is said of every quantity. */
  private static Table labelled(String[] plain, boolean hasTimes) {
    Set<String> names = new LinkedHashSet<>();
    for (String line : plain) {
      names.addAll(quantities(Said.of(line).text()).keySet());
    }
    List<String> lines = new ArrayList<>();
    List<String> stamps = new ArrayList<>();
    for (String line : plain) {
      Said said = Said.of(line);
      Map<String, String> of = quantities(said.text());
      String other = said.text().replace('\t', ' ').replace('"', '\'');
      List<String> cells =
          names.stream().map(name -> of.isEmpty() ? other : of.getOrDefault(name, "")).toList();
      lines.add(said.text().isEmpty() ? "" : String.join("\t", cells));
      stamps.add(said.time());
    }
    return new Table(List.copyOf(names), lines, hasTimes ? stamps : List.of());
  }
}
