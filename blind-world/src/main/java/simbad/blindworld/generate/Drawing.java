package simbad.blindworld.generate;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import simbad.blindworld.design.Design;
import simbad.blindworld.design.Scenes;
import simbad.blindworld.effect.Circumstances;
import simbad.blindworld.effect.Effect;
import simbad.blindworld.effect.Vocabulary;
import simbad.blindworld.world.Chance;
import simbad.blindworld.world.Change;
import simbad.blindworld.world.Forecast;
import simbad.blindworld.world.Recording;
import simbad.blindworld.world.Scene;
import simbad.blindworld.world.Setup;
import simbad.blindworld.world.World;

/**
 * Draws one case: a design, a scene, a set-up and effects of log-uniform size, again and again
 * until the rows hold echoes enough and each effect shows in them beside the others. Where sizes
 * are asked for, effects need not show; the truth says how plainly they do.
 */
final class Drawing {

  private static final double LEAST_ECHO_SHARE = 0.07;
  private static final double MOST_ECHO_SHARE = 0.8;
  private static final double LEAST_STANDARD_ERRORS = 5;
  private static final double LEAST_OUTSIDE_GAIN_CM = 0.8;
  private static final double LEAST_OUTSIDE_SEALED_CM = 0.5;

  /** After so many draws in vain sizes begin to grow: some pairs hide each other. */
  private static final int PATIENCE = 60;

  /** After so many draws in vain another pair is tried, or an unknown by itself. */
  private static final int OTHER_PAIR = 200;

  private static final int DRAWS = 1000;
  private static final int CHECK_REPEATS = 80;

  private final Plan.Assignment assignment;
  private final Order order;
  private final Chance random;
  private List<String> names;
  private int draws;

  Drawing(Plan.Assignment assignment, Order order) {
    this.assignment = assignment;
    this.order = order;
    this.random = new Chance(assignment.seed());
    this.names = assignment.names();
  }

  /** A design with a scene, a set-up and rows before them. */
  private record Ground(Design design, Scene scene, Setup setup, Recording recording) {}

  Case draw() {
    while (draws < DRAWS) {
      draws++;
      if (draws % OTHER_PAIR == 0) {
        names = easier();
      }
      Ground ground = ground();
      Circumstances circumstances = circumstances(ground);
      double share = circumstances.echoShare();
      boolean fits =
          share >= LEAST_ECHO_SHARE
              && share <= MOST_ECHO_SHARE
              && names.stream().allMatch(name -> Vocabulary.applies(name, circumstances));
      if (fits) {
        List<Double> sizes = new ArrayList<>();
        List<Effect> effects = effects(ground, sizes);
        double[] readings = world(ground, effects).at(ground.recording).read(random.nextLong());
        OptionalDouble z = z(ground, effects, readings);
        if (z.isPresent()) {
          Case drawn = complete(ground, effects, readings, shown(sizes, z.getAsDouble()));
          if (matters(drawn)) {
            return drawn;
          }
        }
      }
    }
    throw new IllegalStateException(
        "no case with " + assignment.names() + " that shows, in " + DRAWS + " draws");
  }

  /** Another pair with the same first effect; what is unknown stands alone. */
  private List<String> easier() {
    return switch (assignment.kind()) {
      case PAIR -> Plan.otherPair(order, names.get(0), random);
      case TRIPLE -> Plan.otherTriple(order, names.get(0), random);
      case UNKNOWN -> names.subList(names.size() - 1, names.size());
      case NONE, SINGLE, WITHHELD -> names;
    };
  }

  private Ground ground() {
    Design design = design();
    Scene scene = Scenes.draw(random.split(), design.periodS());
    Setup setup =
        assignment.reference()
            ? Scenes.offSetup(random.split(), scene.sensor())
            : Setup.nominal(scene.sensor());
    int rows = random.nextInt(order.rows().least(), order.rows().most() + 1);
    return new Ground(design, scene, setup, design.record(scene, rows, random.split()));
  }

  private Design design() {
    if (names.stream().anyMatch(Vocabulary::needsPlacements)) {
      return Design.placed(random.split());
    }
    List<String> kinds = Design.kinds();
    return Design.draw(kinds.get(random.nextInt(kinds.size())), random.split());
  }

  private Circumstances circumstances(Ground ground) {
    return circumstances(ground, size());
  }

  private Circumstances circumstances(Ground ground, double size) {
    boolean driven = ground.design.kind().equals("run");
    return new Circumstances(ground.scene, ground.recording, driven, random.split(), size);
  }

  private double size() {
    double grown = Math.min(1.5, Math.max(0, (double) (draws - PATIENCE) / PATIENCE));
    return order.size(assignment.kind(), grown, random);
  }

  private Optional<Case.Shown> shown(List<Double> sizes, double z) {
    return order.sizes().map(asked -> new Case.Shown(sizes, z));
  }

  /** Each with a size of its own, which the list at the end is given. */
  private List<Effect> effects(Ground ground, List<Double> sizes) {
    List<Effect> effects = new ArrayList<>();
    for (String name : names) {
      double size = size();
      sizes.add(size);
      effects.add(Vocabulary.draw(name, circumstances(ground, size)));
    }
    return Vocabulary.inOrder(effects);
  }

  private static World world(Ground ground, List<Effect> effects) {
    List<Change> changes = effects.stream().map(Effect::change).toList();
    return new World(ground.scene, ground.setup, changes);
  }

  private Forecast forecast(Ground ground, List<Effect> effects, Recording rows, int repeats) {
    return Forecast.of(
        world(ground, effects).at(rows), ground.scene.noEchoM(), repeats, random.nextLong());
  }

  /** True for what the diagnosis has no name for. */
  private boolean isOutside(Effect effect) {
    return !Vocabulary.contains(effect.name()) || order.withheld().contains(effect.name());
  }

  /** What has to show: what is outside the vocabulary, where something is. */
  private List<Effect> asked(List<Effect> effects) {
    List<Effect> outside = effects.stream().filter(this::isOutside).toList();
    return outside.isEmpty() ? effects : outside;
  }

  /** True when what is outside the vocabulary costs enough on the sealed rows, too. */
  private boolean matters(Case drawn) {
    return !order.hasToShow(assignment.kind())
        || (assignment.kind() != Kind.UNKNOWN && assignment.kind() != Kind.WITHHELD)
        || drawn.gaps().setupCm() - drawn.gaps().oracleCm() >= LEAST_OUTSIDE_SEALED_CM;
  }

  /**
   * By how many standard errors leaving out any one effect makes the forecast worse, least of all;
   * 0 without effects, nothing where one has to show and does not.
   */
  private OptionalDouble z(Ground ground, List<Effect> effects, double[] readings) {
    if (effects.isEmpty()) {
      return OptionalDouble.of(0);
    }
    boolean hasToShow = order.hasToShow(assignment.kind());
    double least = Double.POSITIVE_INFINITY;
    Forecast whole = forecast(ground, effects, ground.recording, CHECK_REPEATS);
    for (Effect effect : asked(effects)) {
      Evidence.Gain gain = evidence(ground, effects, effect, whole, readings);
      boolean matters = !isOutside(effect) || gain.gainCm() >= LEAST_OUTSIDE_GAIN_CM;
      if (hasToShow && (gain.standardErrors() < LEAST_STANDARD_ERRORS || !matters)) {
        return OptionalDouble.empty();
      }
      least = Math.min(least, gain.standardErrors());
    }
    return OptionalDouble.of(least);
  }

  private Evidence.Gain evidence(
      Ground ground, List<Effect> effects, Effect effect, Forecast whole, double[] readings) {
    List<Effect> others =
        effects.stream().filter(other -> !other.name().equals(effect.name())).toList();
    Forecast without = forecast(ground, others, ground.recording, CHECK_REPEATS);
    return Evidence.of(whole, without, readings, ground.scene.noEchoM());
  }

  private Case complete(
      Ground ground, List<Effect> effects, double[] readings, Optional<Case.Shown> shown) {
    int sealedRows = random.nextInt(order.rows().least(), order.rows().most() + 1);
    Case.Sheet sealed = read(ground, effects, sealedRows);
    Recording rows = sealed.recording();
    Forecast oracle = forecast(ground, effects, rows, order.repeats());
    Forecast setup = forecast(ground, List.of(), rows, order.repeats());
    World nominalWorld = new World(ground.scene, Setup.nominal(ground.scene.sensor()), List.of());
    double noEchoM = ground.scene.noEchoM();
    Forecast nominal =
        Forecast.of(nominalWorld.at(rows), noEchoM, order.repeats(), random.nextLong());
    double[] truth = sealed.rangesM().stream().mapToDouble(Double::doubleValue).toArray();
    Optional<Case.Sheet> reference =
        assignment.reference()
            ? Optional.of(read(ground, List.of(), random.nextInt(1500, 2501)))
            : Optional.empty();
    return new Case(
        assignment,
        ground.design.kind(),
        ground.scene,
        ground.setup,
        effects,
        sheet(ground.recording, readings),
        reference,
        sealed,
        oracle,
        new Case.Gaps(
            nominal.gapCm(truth, noEchoM),
            setup.gapCm(truth, noEchoM),
            oracle.gapCm(truth, noEchoM)),
        shown,
        draws);
  }

  private Case.Sheet read(Ground ground, List<Effect> effects, int rows) {
    Recording recording = ground.design.record(ground.scene, rows, random.split());
    return sheet(recording, world(ground, effects).at(recording).read(random.nextLong()));
  }

  private static Case.Sheet sheet(Recording recording, double[] readings) {
    return new Case.Sheet(recording, Arrays.stream(readings).boxed().toList());
  }
}
