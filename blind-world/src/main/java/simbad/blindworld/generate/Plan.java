package simbad.blindworld.generate;

import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeSet;
import simbad.blindworld.world.Chance;

/**
 * Which cases there will be, before any is drawn: kinds in the asked shares, effects evenly, in
 * random order under random names.
 */
public final class Plan {

  private static final double BESIDE_SHARE = 0.2;

  /** After so many names in vain nothing is fair. */
  private static final int TRIES = 200;

  /**
   * One case to make.
   *
   * @param id its random name
   * @param kind what it asks
   * @param names the effects to put in
   * @param reference whether the set-up is off and a reference comes with it
   * @param seed of its own chance
   */
  record Assignment(String id, Kind kind, List<String> names, boolean reference, long seed) {}

  private Plan() {}

  static List<Assignment> of(Order order) {
    Chance random = new Chance(order.seed());
    List<List<String>> contents = new ArrayList<>();
    List<Kind> kinds = new ArrayList<>();
    Worlds worlds = order.worlds();
    Wheel inside = wheel(order, inside(order), random);
    Wheel outside = wheel(order, worlds.outside(), random);
    // Drawn last, so that orders without it keep their bytes.
    Wheel withheld = new Wheel(order.withheld(), withheldChance(order, random));
    for (Map.Entry<Kind, Integer> part : counts(order).entrySet()) {
      for (int i = 0; i < part.getValue(); i++) {
        kinds.add(part.getKey());
        contents.add(names(part.getKey(), new Wheels(inside, outside, withheld, worlds), random));
      }
    }
    List<Integer> shuffled = new ArrayList<>();
    for (int i = 0; i < kinds.size(); i++) {
      shuffled.add(i);
    }
    Collections.shuffle(shuffled, new Random(random.nextLong()));
    List<Assignment> plan = new ArrayList<>();
    int references = 0;
    for (String id : ids(kinds.size(), random)) {
      int which = shuffled.get(plan.size());
      boolean reference = (plan.size() + 1) * order.referenceShare() - references >= 0.999999;
      references += reference ? 1 : 0;
      plan.add(
          new Assignment(id, kinds.get(which), contents.get(which), reference, random.nextLong()));
    }
    return plan;
  }

  /** By largest remainders, in the order of the kinds. */
  private static Map<Kind, Integer> counts(Order order) {
    double weight = order.mix().values().stream().mapToDouble(Double::doubleValue).sum();
    Map<Kind, Integer> counts = new EnumMap<>(Kind.class);
    double due = 0;
    int given = 0;
    for (Kind kind : Kind.values()) {
      due += order.mix().getOrDefault(kind, 0.0) / weight * order.cases();
      int count = (int) Math.round(due) - given;
      counts.put(kind, count);
      given += count;
    }
    return counts;
  }

  private static Random withheldChance(Order order, Chance random) {
    return new Random(order.withheld().isEmpty() ? 0 : random.nextLong());
  }

  /** What each kind takes its names from. */
  private record Wheels(Wheel inside, Wheel outside, Wheel withheld, Worlds worlds) {}

  private static List<String> names(Kind kind, Wheels wheels, Chance random) {
    Wheel inside = wheels.inside();
    Wheel outside = wheels.outside();
    return switch (kind) {
      case NONE -> List.of();
      case SINGLE -> List.of(inside.next());
      case PAIR -> pair(inside, wheels.worlds());
      case UNKNOWN ->
          random.nextDouble() < BESIDE_SHARE && !inside.isEmpty()
              ? List.of(inside.next(), outside.next())
              : List.of(outside.next());
      case WITHHELD -> List.of(wheels.withheld().next());
      case TRIPLE -> triple(inside, wheels.worlds());
    };
  }

  private static List<String> pair(Wheel inside, Worlds worlds) {
    String first = inside.next();
    for (int tries = 0; tries < TRIES; tries++) {
      String second = inside.next();
      if (worlds.isFairPair(first, second)) {
        return List.of(first, second);
      }
    }
    throw new IllegalArgumentException("no effect that " + first + " makes a fair pair with");
  }

  /** A pair with a third effect that is fair beside both. */
  private static List<String> triple(Wheel inside, Worlds worlds) {
    List<String> two = pair(inside, worlds);
    for (int tries = 0; tries < TRIES; tries++) {
      String third = inside.next();
      if (areFair(two, third, worlds)) {
        return List.of(two.get(0), two.get(1), third);
      }
    }
    throw new IllegalArgumentException("no effect that is fair beside " + two);
  }

  /** Three effects, the first of which is given. */
  static List<String> otherTriple(Order order, String first, Chance random) {
    Wheel wheel = wheel(order, inside(order), random);
    List<String> two = otherPair(order, first, random);
    String third = wheel.next();
    for (int tries = 0; !areFair(two, third, order.worlds()); tries++) {
      if (tries % TRIES == TRIES - 1) {
        // No third one may be fair beside these two.
        two = otherPair(order, first, random);
      }
      third = wheel.next();
    }
    return List.of(first, two.get(1), third);
  }

  private static boolean areFair(List<String> two, String third, Worlds worlds) {
    return two.stream().allMatch(name -> worlds.isFairPair(name, third));
  }

  /** Whether each effect has two others that are fair beside it and beside one another. */
  public static boolean hasTripleForEach(List<String> effects, Worlds worlds) {
    return effects.stream()
        .allMatch(
            one ->
                effects.stream()
                    .filter(other -> worlds.isFairPair(one, other))
                    .anyMatch(
                        other ->
                            effects.stream()
                                .anyMatch(third -> areFair(List.of(one, other), third, worlds))));
  }

  /** A pair of an effect with any other that is fair beside it. */
  static List<String> otherPair(Order order, String first, Chance random) {
    Wheel wheel = wheel(order, inside(order), random);
    String second = wheel.next();
    while (!order.worlds().isFairPair(first, second)) {
      second = wheel.next();
    }
    return List.of(first, second);
  }

  private static List<String> inside(Order order) {
    return order.effects().isEmpty() ? order.worlds().names() : order.worlds().all();
  }

  private static Wheel wheel(Order order, List<String> all, Chance random) {
    List<String> wanted =
        all.stream()
            .filter(name -> order.effects().isEmpty() || order.effects().contains(name))
            .filter(name -> !order.withheld().contains(name))
            .toList();
    return new Wheel(wanted, new Random(random.nextLong()));
  }

  private static List<String> ids(int count, Chance random) {
    TreeSet<String> ids = new TreeSet<>();
    while (ids.size() < count) {
      ids.add("c" + String.format("%07x", random.nextInt(1 << 28)));
    }
    return List.copyOf(ids);
  }

  /** Names in turn, each round in another order. */
  private static final class Wheel {

    private final List<String> names;
    private final Random random;
    private final List<String> left = new ArrayList<>();

    Wheel(List<String> names, Random random) {
      this.names = names;
      this.random = random;
    }

    boolean isEmpty() {
      return names.isEmpty();
    }

    String next() {
      if (names.isEmpty()) {
        throw new IllegalArgumentException("no effect to choose from for a kind of the mix");
      }
      if (left.isEmpty()) {
        left.addAll(names);
        Collections.shuffle(left, random);
      }
      return left.remove(left.size() - 1);
    }
  }
}
