package simbad.blindworld.generate;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import simbad.blindworld.motion.MotionChange;
import simbad.blindworld.motion.MotionForecast;
import simbad.blindworld.motion.MotionWorld;
import simbad.blindworld.motion.Outing;
import simbad.blindworld.motion.Track;
import simbad.blindworld.motion.Windows;
import simbad.blindworld.motionchange.MotionEffect;
import simbad.blindworld.motionchange.MotionSite;
import simbad.blindworld.motionchange.MotionVocabulary;
import simbad.blindworld.motiondrive.MotionDesign;
import simbad.blindworld.motiondrive.MotionSetup;
import simbad.blindworld.world.Chance;

/**
 * Draws one case of motion: a robot, a drive, a set-up and effects of log-uniform size, again and
 * again until each effect shows in the windows beside the others.
 */
final class MotionDrawing {

  private static final double LEAST_STANDARD_ERRORS = 5;

  /** What a robot's own scatter may show where no reference tells of it. */
  private static final double MOST_OF_SETUP = 2;

  /** By which share of the gap something without a name has to show. */
  private static final double LEAST_OUTSIDE = 0.04;

  /** After so many draws in vain sizes begin to grow. */
  private static final int PATIENCE = 15;

  /** After so many draws in vain another pair is tried, or an unknown by itself. */
  private static final int OTHER_PAIR = 45;

  private static final int DRAWS = 400;
  private static final int CHECK_REPEATS = 40;

  private final Plan.Assignment assignment;
  private final Order order;
  private final Chance random;
  private List<String> names;
  private int draws;

  MotionDrawing(Plan.Assignment assignment, Order order) {
    this.assignment = assignment;
    this.order = order;
    this.random = new Chance(assignment.seed());
    this.names = assignment.names();
  }

  /** A robot that is driven, before anything is at work. */
  record Ground(MotionDesign design, MotionSetup setup, Outing outing, Windows windows) {

    MotionWorld world(List<MotionEffect> effects) {
      List<MotionChange> all = new ArrayList<>(setup.own());
      effects.forEach(effect -> all.add(effect.change()));
      return new MotionWorld(setup.robot(), setup.seeing(), all);
    }

    MotionForecast forecast(List<MotionEffect> effects, int repeats, long seed) {
      return MotionForecast.of(world(effects), outing, repeats, seed);
    }
  }

  /** A log of a case with what is at work in it. */
  record Shown(Ground ground, List<MotionEffect> effects, Track track, MotionForecast whole) {

    double[][] displacements() {
      return ground.windows.displacements(track);
    }

    /** By how much the true world forecasts better than one with other effects. */
    MotionEvidence.Gain over(List<MotionEffect> others, int repeats, long seed) {
      MotionForecast rival = ground.forecast(others, repeats, seed);
      return MotionEvidence.of(whole, rival, ground.windows, displacements());
    }

    List<MotionEffect> without(MotionEffect effect) {
      return effects.stream().filter(other -> !other.name().equals(effect.name())).toList();
    }
  }

  MotionCase draw() {
    while (draws < DRAWS) {
      draws++;
      names = draws % OTHER_PAIR == 0 ? easier() : names;
      Ground ground = ground();
      boolean fits =
          ground.windows.size() > 0
              && names.stream().allMatch(n -> MotionVocabulary.applies(n, site(ground, 1)));
      if (fits) {
        List<Double> sizes = new ArrayList<>();
        Shown shown = shown(ground, effects(ground, sizes));
        OptionalDouble z = z(shown);
        Optional<MotionCase> drawn =
            z.isPresent() ? findComplete(shown, sizes, z.getAsDouble()) : Optional.empty();
        if (drawn.isPresent()) {
          return drawn.get();
        }
      }
    }
    throw new IllegalStateException(
        "no case with " + assignment.names() + " that shows, in " + DRAWS + " draws");
  }

  /**
   * Another pair with the same first effect; what is unknown stands alone, and later gives way to
   * something else.
   */
  private List<String> easier() {
    List<String> outside = MotionVocabulary.outside();
    return switch (assignment.kind()) {
      case PAIR -> Plan.otherPair(order, names.get(0), random);
      case TRIPLE -> Plan.otherTriple(order, names.get(0), random);
      case UNKNOWN ->
          draws > OTHER_PAIR && order.effects().isEmpty()
              ? List.of(outside.get(random.nextInt(outside.size())))
              : names.subList(names.size() - 1, names.size());
      case NONE, SINGLE, WITHHELD -> names;
    };
  }

  private Ground ground() {
    MotionDesign design = MotionDesign.draw(random.split());
    MotionSetup setup =
        assignment.reference()
            ? MotionSetup.off(design, random.split())
            : MotionSetup.asBelieved(design, random.split());
    Outing outing =
        design.outing(seconds(order.rows().least(), order.rows().most()), random.split());
    return new Ground(design, setup, outing, Windows.of(outing));
  }

  private double seconds(double least, double most) {
    return least + (most - least) * random.nextDouble();
  }

  private MotionSite site(Ground ground, double size) {
    return new MotionSite(ground.setup.robot(), ground.outing, random.split(), size);
  }

  private double size() {
    double grown = Math.min(1.5, Math.max(0, (double) (draws - PATIENCE) / PATIENCE));
    return order.size(assignment.kind(), grown, random);
  }

  /** Each with a size of its own, which the list at the end is given. */
  private List<MotionEffect> effects(Ground ground, List<Double> sizes) {
    List<MotionEffect> effects = new ArrayList<>();
    for (String name : names) {
      double size = size();
      sizes.add(size);
      effects.add(MotionVocabulary.draw(name, site(ground, size)));
    }
    return effects;
  }

  private Shown shown(Ground ground, List<MotionEffect> effects) {
    Track track = ground.world(effects).drive(ground.outing, random.nextLong());
    return new Shown(
        ground, effects, track, ground.forecast(effects, CHECK_REPEATS, random.nextLong()));
  }

  /** True for what the diagnosis has no name for. */
  private boolean isOutside(MotionEffect effect) {
    return !MotionVocabulary.contains(effect.name()) || order.withheld().contains(effect.name());
  }

  /**
   * By how many standard errors leaving out any one effect makes the forecast worse, least of all;
   * 0 without effects, nothing where one has to show and does not. What has no name has to show by
   * itself, and against the vocabulary's effects in its place.
   */
  private OptionalDouble z(Shown shown) {
    if (shown.effects.isEmpty()) {
      return setupShows(shown) ? OptionalDouble.empty() : OptionalDouble.of(0);
    }
    boolean hasToShow = order.hasToShow(assignment.kind());
    double least = Double.POSITIVE_INFINITY;
    for (MotionEffect effect : shown.effects) {
      MotionEvidence.Gain gain =
          shown.over(shown.without(effect), CHECK_REPEATS, random.nextLong());
      boolean matters = !isOutside(effect) || gain.share() >= LEAST_OUTSIDE;
      if (hasToShow && (gain.standardErrors() < LEAST_STANDARD_ERRORS || !matters)) {
        return OptionalDouble.empty();
      }
      least = Math.min(least, gain.standardErrors());
    }
    return hasToShow && hides(shown) ? OptionalDouble.empty() : OptionalDouble.of(least);
  }

  /** True when something without a name does what an effect of the vocabulary would do. */
  private boolean hides(Shown shown) {
    return shown.effects.stream()
        .filter(effect -> !MotionVocabulary.contains(effect.name()))
        .anyMatch(effect -> MotionRivals.hides(shown, effect, random.nextLong()));
  }

  /** True when the nominal forecast tells a robot with nothing at work from the nominal one. */
  private boolean setupShows(Shown shown) {
    if (assignment.reference()) {
      return false;
    }
    MotionForecast nominal =
        MotionForecast.of(
            MotionWorld.nominal(shown.ground.setup.robot()),
            shown.ground.outing,
            CHECK_REPEATS,
            random.nextLong());
    return MotionEvidence.of(shown.whole, nominal, shown.ground.windows, shown.displacements())
            .standardErrors()
        > MOST_OF_SETUP;
  }

  private Optional<MotionCase> findComplete(Shown shown, List<Double> sizes, double z) {
    Ground ground = shown.ground;
    Outing sealedOuting = ground.design.outing(seconds(90, 200), random.split());
    Ground sealedGround =
        new Ground(ground.design, ground.setup, sealedOuting, Windows.of(sealedOuting));
    MotionWorld world = ground.world(shown.effects);
    MotionCase.Log sealed = log(world, sealedOuting);
    double[][] moved = sealedGround.windows.displacements(sealed.track());
    if (moved.length == 0) {
      return Optional.empty();
    }
    Optional<MotionCase.Log> reference =
        assignment.reference()
            ? Optional.of(
                log(
                    ground.world(List.of()),
                    ground.design.outing(seconds(120, 360), random.split())))
            : Optional.empty();
    MotionForecast oracle =
        sealedGround.forecast(shown.effects, order.repeats(), random.nextLong());
    return Optional.of(
        new MotionCase(
            assignment,
            ground.design.kind(),
            ground.setup.words(),
            ground.setup.robot(),
            shown.effects,
            new MotionCase.Log(ground.outing, shown.track),
            reference,
            sealed,
            oracle,
            figures(sealedGround, moved, oracle, new Drawn(z, sizes)),
            called(shown)));
  }

  /** How plainly the least effect shows, and how large each one is. */
  private record Drawn(double z, List<Double> sizes) {}

  private MotionCase.Figures figures(
      Ground sealed, double[][] moved, MotionForecast oracle, Drawn drawn) {
    int repeats = order.repeats();
    MotionForecast unchanged = sealed.forecast(List.of(), repeats, random.nextLong());
    MotionWorld believed = MotionWorld.nominal(sealed.setup.robot());
    double[] units =
        MotionForecast.of(believed, sealed.outing, repeats, random.nextLong())
            .losses(sealed.windows, moved);
    return new MotionCase.Figures(
        Arrays.stream(units).boxed().toList(),
        MotionForecast.gap(unchanged.losses(sealed.windows, moved), units),
        MotionForecast.gap(oracle.losses(sealed.windows, moved), units),
        drawn.z,
        drawn.sizes,
        draws);
  }

  private MotionCase.Log log(MotionWorld world, Outing outing) {
    return new MotionCase.Log(outing, world.drive(outing, random.nextLong()));
  }

  private List<MotionCase.Called> called(Shown shown) {
    return shown.effects.stream()
        .map(effect -> MotionRivals.called(shown, effect, random.nextLong()))
        .toList();
  }
}
