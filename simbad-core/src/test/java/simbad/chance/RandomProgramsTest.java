package simbad.chance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import javax.vecmath.Point3d;
import org.junit.jupiter.api.Test;
import simbad.chance.RandomProgram.Kind;
import simbad.chance.RandomProgram.Outcome;
import simbad.chance.RandomProgram.Thing;
import simbad.chance.RandomProgram.Watcher;
import simbad.sim.Compatibility;
import simbad.sim.SimpleAgent;
import simbad.sim.Simulator;
import simbad.sim.World;

/**
 * Programs made by chance: what they do by default and as the original did differs by nothing but
 * switches that the run names; none fails, no bodies overlap, no energy comes from nowhere. {@code
 * -Dchance.programs=10000} for more of them.
 */
class RandomProgramsTest {
  private static final int PROGRAMS = Integer.getInteger("chance.programs", 300);
  private static final Set<Compatibility> NONE = EnumSet.noneOf(Compatibility.class);
  private static final Set<Compatibility> UPSTREAM = Compatibility.parse("upstream");
  private static final double DEEPEST_M = 1e-3;
  private static final Watcher NOBODY = (step, simulator) -> {};

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
    // No single decision depends on these; ./simbad program names them wherever robots measure or
    // see robots.
    wanted.add(Compatibility.ROBOTS_ARE_PRISMS);
    wanted.add(Compatibility.NOSES_FLOAT);
    return named.addAll(wanted);
  }

  @Test
  void bodies_doNotOverlap() {
    forAll(
        program -> {
          boolean[] holds = {true};
          program.run(NONE, (step, simulator) -> holds[0] &= !overlap(simulator));
          return holds[0];
        });
  }

  private static boolean overlap(Simulator simulator) {
    List<SimpleAgent> agents = simulator.getAgentList();
    for (int i = 0; i < agents.size(); i++) {
      SimpleAgent one = agents.get(i);
      if (isWithinAnObject(one, simulator.getWorld())) {
        return true;
      }
      for (int j = 0; j < i; j++) {
        SimpleAgent other = agents.get(j);
        double reachM = one.getRadius() + other.getRadius() - DEEPEST_M;
        boolean solid = !one.getCanBeTraversed() && !other.getCanBeTraversed();
        if (solid && at(one).distance(at(other)) < reachM) {
          return true;
        }
      }
    }
    return false;
  }

  private static boolean isWithinAnObject(SimpleAgent agent, World world) {
    Point3d at = at(agent);
    return world.getScene().stopsBall(at.x, at.y, at.z, agent.getRadius() - DEEPEST_M);
  }

  private static Point3d at(SimpleAgent agent) {
    Point3d at = new Point3d();
    agent.getCoords(at);
    return at;
  }

  /** What balls have by their heights and velocities together; a reset gives it back. */
  @Test
  void energy_neverGrows_withoutMotors() {
    forAll(
        program -> {
          if (program.hasMotors() || !program.physics()) {
            return true;
          }
          double[] most = new double[1];
          boolean[] holds = {true};
          program.run(
              NONE,
              (step, simulator) -> {
                double energy = energy(simulator.getAgentList());
                boolean begins = step == 1 || step % program.resetEvery() == 0;
                holds[0] &= begins || energy <= most[0] + 1e-9;
                most[0] = energy;
              });
          return holds[0];
        });
  }

  /** Found among ten thousand: what is thrown up by something low has its weight from the start. */
  @Test
  void ballThatIsThrownUp_gainsNothing() {
    RandomProgram program =
        new RandomProgram(
            List.of(
                new RandomProgram.Thing(
                    RandomProgram.Kind.BALL,
                    -0.045913538800582465,
                    0,
                    1.715843937577981,
                    -4994659633068311202L),
                new RandomProgram.Thing(
                    RandomProgram.Kind.WALL,
                    -0.8215002040569748,
                    0,
                    2.627594417673679,
                    6278998917130724956L)),
            true,
            47,
            20);
    List<Double> energies = new ArrayList<>();
    program.run(NONE, (step, simulator) -> energies.add(energy(simulator.getAgentList())));
    for (int i = 1; i < energies.size(); i++) {
      assertTrue(energies.get(i) <= energies.get(i - 1) + 1e-9, energies::toString);
    }
  }

  private static double energy(List<SimpleAgent> agents) {
    return agents.stream()
        .filter(RandomBall.class::isInstance)
        .mapToDouble(agent -> ((RandomBall) agent).energy())
        .sum();
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
