package simbad.figures.page;

import java.awt.Color;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * How different two colours are to people who see all colours, and to those who lack one kind of
 * cone. How these see is simulated by Machado, Oliveira and Fernandes (A Physiologically-based
 * Model for Simulation of Color Vision Deficiency, 2009, table of severity 1.0); differences are
 * CIEDE2000 (Sharma, Wu and Dalal, 2005), where 1 is just seen side by side.
 */
public final class ColourSight {
  /** What must be told apart by colour alone differs by this at least. */
  public static final double LEAST = 10;

  private static final double[] ALL = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  private static final double[] NO_RED = {
    0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998
  };
  private static final double[] NO_GREEN = {
    0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881
  };
  private static final double[] NO_BLUE = {
    1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.303900
  };
  private static final List<double[]> EYES = List.of(ALL, NO_RED, NO_GREEN, NO_BLUE);
  private static final double[] XYZ = {
    0.4124564, 0.3575761, 0.1804375, 0.2126729, 0.7151522, 0.0721750, 0.0193339, 0.1191920,
    0.9503041
  };
  private static final double[] WHITE = {0.95047, 1, 1.08883};
  private static final Pattern ROOT = Pattern.compile(":root \\{([^}]*)}");
  private static final Pattern NAMED = Pattern.compile("--(\\w+): (#[0-9a-f]{6}|#[0-9a-f]{3});");

  private ColourSight() {}

  /** Returns the pairs, each with its difference, that somebody takes for one colour. */
  public static List<String> alike(Map<String, Color> colours, String... names) {
    List<String> alike = new ArrayList<>();
    for (int i = 0; i < names.length; i++) {
      for (int j = i + 1; j < names.length; j++) {
        double difference = difference(of(colours, names[i]), of(colours, names[j]));
        if (difference < LEAST) {
          alike.add("%s and %s: %.1f".formatted(names[i], names[j], difference));
        }
      }
    }
    return alike;
  }

  private static Color of(Map<String, Color> colours, String name) {
    Color colour = colours.get(name);
    if (colour == null) {
      throw new AssertionError("there is no colour " + name);
    }
    return colour;
  }

  /** Returns the smallest difference of two colours to any of the four kinds of eyes. */
  public static double difference(Color a, Color b) {
    return EYES.stream()
        .mapToDouble(eye -> difference(lab(seen(a, eye)), lab(seen(b, eye))))
        .min()
        .orElseThrow();
  }

  /** Returns the lightness from 0 to 100 to each of the four kinds of eyes. */
  public static double[] lightness(Color colour) {
    return EYES.stream().mapToDouble(eye -> lab(seen(colour, eye))[0]).toArray();
  }

  /**
   * Returns the colours that a style sheet names: of its first root, then what its second alters.
   */
  public static Map<String, Color> palette(String css, boolean dark) {
    Map<String, Color> colours = new LinkedHashMap<>();
    Matcher root = ROOT.matcher(css);
    for (int theme = 0; theme < (dark ? 2 : 1) && root.find(); theme++) {
      NAMED
          .matcher(root.group(1).replace("\n", " ") + ";")
          .results()
          .forEach(one -> colours.put(one.group(1), colour(one.group(2))));
    }
    return colours;
  }

  /** Returns a colour as style sheets write it. */
  public static Color colour(String hex) {
    return Color.decode(hex.length() == 4 ? hex.replaceAll("([0-9a-f])", "$1$1") : hex);
  }

  private static double[] seen(Color colour, double[] eye) {
    double[] seen = times(eye, linear(colour));
    for (int i = 0; i < 3; i++) {
      seen[i] = Math.min(1, Math.max(0, seen[i]));
    }
    return seen;
  }

  private static double[] linear(Color colour) {
    double[] linear = new double[3];
    float[] shares = colour.getRGBColorComponents(null);
    for (int i = 0; i < 3; i++) {
      linear[i] =
          shares[i] <= 0.04045 ? shares[i] / 12.92 : Math.pow((shares[i] + 0.055) / 1.055, 2.4);
    }
    return linear;
  }

  private static double[] times(double[] matrix, double[] vector) {
    double[] product = new double[3];
    for (int i = 0; i < 9; i++) {
      product[i / 3] += matrix[i] * vector[i % 3];
    }
    return product;
  }

  private static double[] lab(double[] linear) {
    double[] xyz = times(XYZ, linear);
    double[] root = new double[3];
    for (int i = 0; i < 3; i++) {
      double share = xyz[i] / WHITE[i];
      root[i] = share > 216.0 / 24389 ? Math.cbrt(share) : (24389.0 / 27 * share + 16) / 116;
    }
    return new double[] {116 * root[1] - 16, 500 * (root[0] - root[1]), 200 * (root[1] - root[2])};
  }

  /** CIEDE2000 of two colours in L*, a*, b*. */
  static double difference(double[] one, double[] other) {
    double stretch = 1 + 0.5 * (1 - saturation((chroma(one, 1) + chroma(other, 1)) / 2));
    double c1 = chroma(one, stretch);
    double c2 = chroma(other, stretch);
    double h1 = hueDeg(one, stretch);
    double h2 = hueDeg(other, stretch);
    double turnDeg = c1 * c2 == 0 ? 0 : Math.IEEEremainder(h2 - h1, 360);
    double hueDeg = c1 * c2 == 0 ? h1 + h2 : h1 + turnDeg / 2;
    double chroma = (c1 + c2) / 2;
    double light = (one[0] + other[0]) / 2 - 50;
    double dl = (other[0] - one[0]) / (1 + 0.015 * light * light / Math.sqrt(20 + light * light));
    double dc = (c2 - c1) / (1 + 0.045 * chroma);
    double dh = 2 * Math.sqrt(c1 * c2) * sin(turnDeg / 2) / (1 + 0.015 * chroma * weight(hueDeg));
    double blue = (((hueDeg % 360) + 360) % 360 - 275) / 25;
    double rotation = -2 * saturation(chroma) * sin(60 * Math.exp(-blue * blue));
    return Math.sqrt(dl * dl + dc * dc + dh * dh + rotation * dc * dh);
  }

  private static double chroma(double[] lab, double stretch) {
    return Math.hypot(lab[1] * stretch, lab[2]);
  }

  private static double hueDeg(double[] lab, double stretch) {
    return (Math.toDegrees(Math.atan2(lab[2], lab[1] * stretch)) + 360) % 360;
  }

  private static double saturation(double chroma) {
    return Math.sqrt(Math.pow(chroma, 7) / (Math.pow(chroma, 7) + Math.pow(25, 7)));
  }

  private static double weight(double hueDeg) {
    return 1
        - 0.17 * cos(hueDeg - 30)
        + 0.24 * cos(2 * hueDeg)
        + 0.32 * cos(3 * hueDeg + 6)
        - 0.2 * cos(4 * hueDeg - 63);
  }

  private static double sin(double deg) {
    return Math.sin(Math.toRadians(deg));
  }

  private static double cos(double deg) {
    return Math.cos(Math.toRadians(deg));
  }
}
