package simbad.gap.diagnosis;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.math.BigDecimal;
import java.math.MathContext;

/**
 * Numbers in diagnosis.json, of sensing and of motion: rounded to six digits, null where there is
 * no finite one.
 */
public final class JsonFigures {
  private static final MathContext DIGITS = new MathContext(6);

  private JsonFigures() {}

  /** Sets a field of an object. */
  public static void put(ObjectNode node, String field, double value) {
    if (Double.isFinite(value)) {
      node.put(field, rounded(value));
    } else {
      node.putNull(field);
    }
  }

  /** Adds both ends of an interval to a list. */
  public static void interval(ArrayNode array, Interval interval) {
    for (double end : new double[] {interval.low(), interval.high()}) {
      if (Double.isFinite(end)) {
        array.add(rounded(end));
      } else {
        array.addNull();
      }
    }
  }

  /** Returns a finite number with six digits. */
  public static double rounded(double value) {
    return new BigDecimal(value).round(DIGITS).doubleValue();
  }
}
