package simbad.scattering;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class HankelTest {
  /** Computed with SciPy 1.17.1: j0, y0, j1, y1. */
  @ParameterizedTest
  @CsvSource({
    "0.001, 0.9999997500000155, -4.471416611375923, 0.0004999999375000026, -636.6221672311395",
    "0.1, 0.99750156206604, -1.534238651350367, 0.049937526036242, -6.458951094702027",
    "1, 0.7651976865579665, 0.08825696421567697, 0.4400505857449336, -0.7812128213002888",
    "3, -0.2600519549019335, 0.3768500100127906, 0.3390589585259365, 0.3246744247918001",
    "7.5, 0.2663396578803784, 0.1173132861482086, 0.1352484275797055, -0.2591285104861162",
    "11.9, 0.02504944169958986, -0.2298332139433751, -0.228983249661924, -0.03471149833403043",
    "12.1, 0.06966677360680752, -0.2184383805509255, -0.2157489733769249, -0.07873693145139557",
    "15, -0.0142244728267806, 0.2054642960389182, 0.2051040386135228, 0.02107362803687372",
    "26, 0.1559993155224212, 0.01204462586075547, 0.01504573058691597, -0.1557965532296027",
    "50, 0.05581232766925209, -0.09806499547007692, -0.09751182812517509, -0.05679566856201487",
    "150, -0.0007740903753941157, -0.06514222150903737, -0.06514516365772736, 0.0005569563495603133"
  })
  void values_areThoseOfAnotherProgram(double x, double j0, double y0, double j1, double y1) {
    Hankel h = Hankel.at(x);
    double scale = Math.hypot(j0, y0);
    assertEquals(j0, h.j0(), 1e-10 * scale);
    assertEquals(y0, h.y0(), 1e-10 * scale);
    double scale1 = Math.hypot(j1, y1);
    assertEquals(j1, h.j1(), 1e-10 * scale1);
    assertEquals(y1, h.y1(), 1e-10 * scale1);
  }

  /** The Wronskian J1 Y0 - J0 Y1 = 2 / (pi x). */
  @Property(seed = "7")
  void wronskian_holds(@ForAll @DoubleRange(min = 0.01, max = 200) double x) {
    Hankel h = Hankel.at(x);
    double expected = 2 / (Math.PI * x);
    assertEquals(expected, h.j1() * h.y0() - h.j0() * h.y1(), 1e-9 * expected);
  }

  @Test
  void series_andExpansion_meet() {
    Hankel below = Hankel.at(12);
    Hankel above = Hankel.at(Math.nextUp(12.0));
    assertEquals(below.j0(), above.j0(), 1e-10);
    assertEquals(below.y1(), above.y1(), 1e-10);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, -1, Double.NaN, Double.POSITIVE_INFINITY})
  void argument_outOfRange_isRefused(double x) {
    assertThrows(IllegalArgumentException.class, () -> Hankel.at(x));
  }
}
