package simbad.blindworld.score;

import java.util.List;
import simbad.blindworld.check.Checks;

/**
 * What an answer says in numbers beside names, held against the truth.
 *
 * @param parameters of effects that it names rightly
 * @param places that it tells, of which sealed rows can say something
 * @param told how many places it tells
 */
public record Particulars(List<Parameter> parameters, List<Place> places, int told) {

  /** Narrows an interval of 95 % to one of 90 % where errors are normal. */
  private static final double OF_95 = 1.6449 / 1.96;

  /** Copies the lists. */
  public Particulars {
    parameters = List.copyOf(parameters);
    places = List.copyOf(places);
  }

  /**
   * A number of an effect.
   *
   * @param effect its name
   * @param off how far the true value is from the stated one, in half widths of the 95 % interval
   *     on its side; infinite where the interval has no width
   */
  public record Parameter(String effect, double off) {
    /** Refuses what is no such thing. */
    public Parameter {
      Checks.number("off", off);
    }

    /** Whether the interval holds the true value. */
    boolean isIn95() {
      return off <= 1;
    }

    /** Whether the interval, narrowed to 90 %, holds it. */
    boolean isIn90() {
      return off <= OF_95;
    }
  }

  /**
   * A place of the gap on sealed rows.
   *
   * @param isLarger whether the true world's forecast takes away more of a reading's gap in it than
   *     beside it, in the mean
   * @param rows share of the sealed rows that lie in it
   * @param removable share of what it takes away of all rows' gaps
   */
  public record Place(boolean isLarger, double rows, double removable) {
    /** Refuses what is no such thing. */
    public Place {
      Checks.share("rows", rows);
      Checks.finite("removable", removable);
    }
  }
}
