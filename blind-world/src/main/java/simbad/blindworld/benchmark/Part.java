package simbad.blindworld.benchmark;

import java.util.EnumMap;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import simbad.blindworld.generate.Kind;
import simbad.blindworld.generate.Order;
import simbad.blindworld.generate.Worlds;

/**
 * A part of the benchmark SRB-1: worlds of one level of independence. What stands here is frozen: a
 * change of it, or of what is drawn, makes another benchmark with another number.
 */
public enum Part {
  /** The diagnosis' own equations, set up as the scene says. */
  L1(
      0,
      350,
      0,
      Worlds.EQUATIONS,
      "b0fdcdcdc17062beca8fcdbd94b3192ddff80eb870bf41101f08421e8f2cf872"),
  /** As L1, with a set-up that is a little off, and a reference. */
  L2(
      1,
      350,
      1,
      Worlds.EQUATIONS,
      "60f82dc179390f1f5fc2e7ab9dcf809b37d1284ef2e7d42f1d8778e0fffa2449"),
  /** Waves, with a user's calibration and a reference. */
  L2W(2, 300, 0, Worlds.WAVE, "68c07ae0fc75f9488db5d052f9e53b27776794b55e74d43017cc229adb52a55b"),
  /** Robots that drive before a tracker, three in ten of them a little off, with a reference. */
  MOTION(
      3,
      300,
      0.3,
      Worlds.MOTION,
      "a4fb7cc27f68c5345d713275ca9aa4c2a4ba1bac446f61e83e9a5c89e3e1ddaf");

  /** Name and version: of what is drawn, not of the program. */
  public static final String VERSION = "SRB-1.1";

  /** Chance of the first half, which everybody may draw. */
  public static final long FIRST_HALF = 20_271_101;

  /** SHA-256 of the seed of the second half, written in decimal digits, until it is used. */
  public static final String SECOND_HALF_SHA256 =
      "f1c43c27ef0575897c487f4686e26ae7229237a64f8d6a87c3a3029716f673be";

  /** The greatest seed of practice. */
  public static final int MOST_PRACTICE = 1_000_000;

  private static final long PRACTICE = 1_000_000_000;

  /** Between two seeds of practice, so that no part has another one's chance. */
  private static final int STEP = 10;

  private static final Order.Rows EQUATION_ROWS = new Order.Rows(800, 2500);
  private static final Order.Rows WAVE_ROWS = new Order.Rows(700, 2500);

  /** Of motion, seconds. */
  private static final Order.Rows MOTION_SECONDS = new Order.Rows(120, 360);

  private static final Order.Sizes SIZES = new Order.Sizes(0.4, 4);

  /** Single effects are of all sizes, so that power can be told; the others have to show. */
  private static final Set<Kind> PLAIN = EnumSet.of(Kind.PAIR, Kind.TRIPLE, Kind.UNKNOWN);

  /** Repeats of the true world behind a forecast of the sealed rows. */
  private static final int REPEATS = 200;

  private final int number;
  private final int cases;
  private final double referenceShare;
  private final Worlds worlds;
  private final String root;

  Part(int number, int cases, double referenceShare, Worlds worlds, String root) {
    this.number = number;
    this.cases = cases;
    this.referenceShare = referenceShare;
    this.worlds = worlds;
    this.root = root;
  }

  /** The part of a name as it is typed, whatever its case. */
  public static Optional<Part> find(String name) {
    return List.of(values()).stream().filter(p -> p.word().equalsIgnoreCase(name)).findFirst();
  }

  /** Its name: L1, L2, L2w or motion. */
  public String word() {
    return switch (this) {
      case L1, L2 -> name();
      case L2W -> "L2w";
      case MOTION -> "motion";
    };
  }

  /** How many cases each half has. */
  public int cases() {
    return cases;
  }

  /** The root over the commitments of all its cases of the first half. */
  public String root() {
    return root;
  }

  /**
   * What is drawn for a half of it.
   *
   * @param seed of the half; each part has chance of its own
   */
  public Order half(long seed) {
    return order(seed, cases);
  }

  /**
   * Cases of the same kind to practise and to learn on, none of which is of the benchmark.
   *
   * @param seed from 0 to {@link #MOST_PRACTICE}, a range in which neither half's is
   * @param count how many
   */
  public Order practice(int seed, int count) {
    return order(PRACTICE + (long) STEP * seed, count);
  }

  private Order order(long seed, int count) {
    return new Order(
        count,
        seed + number,
        mix(),
        referenceShare,
        List.of(),
        List.of(),
        rows(),
        REPEATS,
        worlds,
        Optional.of(SIZES),
        PLAIN);
  }

  private Order.Rows rows() {
    return switch (worlds) {
      case EQUATIONS -> EQUATION_ROWS;
      case WAVE -> WAVE_ROWS;
      case MOTION -> MOTION_SECONDS;
    };
  }

  /** One case in four holds nothing, one in five something without a name. */
  private static Map<Kind, Double> mix() {
    Map<Kind, Double> mix = new EnumMap<>(Kind.class);
    mix.put(Kind.NONE, 0.25);
    mix.put(Kind.SINGLE, 0.4);
    mix.put(Kind.PAIR, 0.1);
    mix.put(Kind.TRIPLE, 0.05);
    mix.put(Kind.UNKNOWN, 0.2);
    return mix;
  }

  @Override
  public String toString() {
    return VERSION + " " + word();
  }
}
