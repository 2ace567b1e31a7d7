package simbad.chance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import org.junit.jupiter.api.Test;
import simbad.chance.RandomProgram.Kind;
import simbad.chance.RandomProgram.Outcome;
import simbad.chance.RandomProgram.Thing;
import simbad.chance.RandomProgram.Watcher;
import simbad.sim.BallAgent;
import simbad.sim.Compatibility;
import simbad.sim.SimpleAgent;

/**
 * Programs made by chance: what they do by default and as the original did differs by nothing but
 * switches that the run names; none fails, and no bodies overlap. {@code -Dchance.programs=10000}
 * for more of them.
 */
class RandomProgramsTest {
  private static final int PROGRAMS = Integer.getInteger("chance.programs", 300);
  private static final Set<Compatibility> NONE = EnumSet.noneOf(Compatibility.class);
  private static final Set<Compatibility> UPSTREAM = Compatibility.parse("upstream");
  private static final double DEEPEST_M = 1e-3;
  private static final Watcher NOBODY = (step, agents) -> {};

  private static void forAll(Predicate<RandomProgram> holds) {
    for (long seed = 0; seed < PROGRAMS; seed++) {
      RandomProgram program = RandomProgram.of(seed);
      if (!holds.test(program)) {
        throw new AssertionError(
            "program " + seed + ", shrunk: " + Shrinking.smallest(program, holds.negate()));
      }
    }
  }

  private static boolean same(Outcome one, Outcome other) {
    for (int i = 0; i < one.poses().size(); i++) {
      if (!Arrays.equals(one.poses().get(i), other.poses().get(i))) {
        return false;
      }
    }
    return true;
  }

  @Test
  void sameProgram_sameTrace_andAllNumbers() {
    forAll(
        program -> {
          Outcome once = program.run(NONE, NOBODY);
          boolean numbers =
              once.poses().stream().flatMapToDouble(Arrays::stream).allMatch(Double::isFinite);
          return numbers && same(once, program.run(NONE, NOBODY));
        });
  }

  /** Adds the switches that the run names until it names no more: that is all of upstream's way. */
  @Test
  void differencesToUpstream_areAllNamed() {
    forAll(
        program -> {
          Set<Compatibility> named = EnumSet.noneOf(Compatibility.class);
          Outcome now = program.run(named, NOBODY);
          while (grow(named, now)) {
            now = program.run(named, NOBODY);
          }
          return same(now, program.run(UPSTREAM, NOBODY));
        });
  }

  private static boolean grow(Set<Compatibility> named, Outcome outcome) {
    Set<Compatibility> wanted = EnumSet.noneOf(Compatibility.class);
    wanted.addAll(outcome.touched());
    wanted.retainAll(UPSTREAM);
    // No single decision depends on it; ./simbad program names it wherever robots measure robots.
    wanted.add(Compatibility.ROBOTS_ARE_PRISMS);
    return named.addAll(wanted);
  }

  @Test
  void bodies_doNotOverlap() {
    forAll(
        program -> {
          double[] deepest = {0};
          program.run(NONE, (step, agents) -> deepest[0] = Math.max(deepest[0], depth(agents)));
          return deepest[0] < DEEPEST_M;
        });
  }

  private static double depth(List<SimpleAgent> agents) {
    double deepest = 0;
    for (int i = 0; i < agents.size(); i++) {
      for (int j = 0; j < i; j++) {
        SimpleAgent one = agents.get(i);
        SimpleAgent other = agents.get(j);
        if (!one.getCanBeTraversed() && !other.getCanBeTraversed()) {
          deepest = Math.max(deepest, one.getRadius() + other.getRadius() - distance(one, other));
        }
      }
    }
    return deepest;
  }

  private static double distance(SimpleAgent one, SimpleAgent other) {
    javax.vecmath.Point3d a = new javax.vecmath.Point3d();
    javax.vecmath.Point3d b = new javax.vecmath.Point3d();
    one.getCoords(a);
    other.getCoords(b);
    return a.distance(b);
  }

  @Test
  void heights_neverGrow_withoutMotors() {
    forAll(
        program -> {
          if (program.hasMotors() || !program.physics()) {
            return true;
          }
          double[] highest = new double[20];
          Arrays.fill(highest, Double.POSITIVE_INFINITY);
          boolean[] holds = {true};
          program.run(
              NONE,
              (step, agents) -> {
                double energy = potential(agents);
                if (step == 1 || step % program.resetEvery() == 0) {
                  highest[0] = energy;
                }
                holds[0] &= energy <= highest[0] + 1e-9;
              });
          return holds[0];
        });
  }

  /** Balls start at rest: together they never stand higher than they did. */
  private static double potential(List<SimpleAgent> agents) {
    javax.vecmath.Point3d at = new javax.vecmath.Point3d();
    double sum = 0;
    for (SimpleAgent agent : agents) {
      if (agent instanceof BallAgent) {
        agent.getCoords(at);
        sum += agent.getMass() * 9.8 * at.y;
      }
    }
    return sum;
  }

  @Test
  void shrinking_findsTheTwoThatMatter() {
    RandomProgram program =
        new RandomProgram(
            List.of(
                new Thing(Kind.BOX, 0, 0, 2, 1),
                new Thing(Kind.BALL, 1, 0, 0, 2),
                new Thing(Kind.CHERRY, -1, 0, 2, 3),
                new Thing(Kind.WANDERER, -2, 0, -2, 4)),
            false,
            50,
            100);
    RandomProgram small =
        Shrinking.smallest(
            program,
            p ->
                p.steps() >= 7
                    && p.things().stream().anyMatch(t -> t.kind() == Kind.BALL)
                    && p.things().stream().anyMatch(t -> t.kind() == Kind.BOX));
    assertEquals(2, small.things().size());
    assertEquals(7, small.steps());
    assertTrue(small.things().stream().noneMatch(t -> t.kind() == Kind.CHERRY));
  }
}
