package simbad.gap.search;

import java.util.DoubleSummaryStatistics;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import simbad.definition.Effect;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fit.NearestRange;
import simbad.gap.fit.Placements;
import simbad.gap.score.PlacementScatter;
import simbad.sonar.effect.Definitions;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.LogDesign;
import simbad.sonar.effect.Modes;
import simbad.sonar.effect.Tries;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.PingLog;
import simbad.sonar.ping.Scenes;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.UniformDetection;
import simbad.sonar.shape.Outline;

/**
 * What physics, symmetry or the design of a log forbids: an effect that cannot be there, or that
 * nothing in the log could show, is not looked for.
 */
final class Gates {
  /** A polygon of so many corners whose distances from the axis differ by less is round. */
  private static final int ROUND_CORNERS = 12;

  private static final double ROUND = 0.97;

  /**
   * A scale that is off by a tenth then differs from an offset by a hundredth of the distance: no
   * more than a tape is.
   */
  private static final double ONE_DISTANCE = 0.1;

  private Gates() {}

  /** Returns those of some forms that are possible, with the values that are. */
  static List<Form> open(CalibratedLog given, List<Form> forms) {
    LogDesign design = design(given);
    return forms.stream()
        .filter(form -> Definitions.of(form.effect()).canShow(form, design))
        .map(form -> Definitions.of(form.effect()).within(form, design))
        .toList();
  }

  /** Returns, of each effect that has any, what a log cannot tell from it as it was taken. */
  static Map<Effect, Set<Effect>> twins(CalibratedLog given) {
    LogDesign design = design(given);
    Map<Effect, Set<Effect>> twins = new TreeMap<>();
    for (Effect effect : Definitions.effects()) {
      Set<Effect> alike = Definitions.of(effect).twins(design);
      if (!alike.isEmpty()) {
        twins.put(effect, alike);
      }
    }
    return twins;
  }

  /** Returns which effects of a set the way in which a log was taken invites. */
  static Function<Hypothesis, Set<Effect>> invited(CalibratedLog given) {
    LogDesign design = design(given);
    return set ->
        IntStream.range(0, set.forms().size())
            .filter(i -> isInvited(set.forms().get(i), design, set.valuesOf(i)))
            .mapToObj(i -> set.forms().get(i).effect())
            .collect(Collectors.toSet());
  }

  /** Returns those of some forms that the way in which a log was taken invites, at any values. */
  static List<Form> invited(CalibratedLog given, List<Form> forms) {
    LogDesign design = design(given);
    return forms.stream()
        .filter(form -> Tries.all(form).stream().anyMatch(v -> isInvited(form, design, v)))
        .toList();
  }

  private static boolean isInvited(Form form, LogDesign design, double... values) {
    return Definitions.of(form.effect()).isInvited(form, design, values);
  }

  private static LogDesign design(CalibratedLog given) {
    SensingSetup setup = given.setup();
    Placements placements = new Placements(given.log());
    boolean repeated = placements.areRepeated();
    boolean off = repeated && PlacementScatter.isFurtherOff(given, placements);
    boolean noisier = !repeated || PlacementScatter.isNoisier(given, placements);
    double wayM = medianPeriodS(given.log()) * setup.sensor().assumedSoundSpeedMPerS() / 2;
    return new LogDesign(
        setup, given.log(), repeated, off, noisier, wayM, round(setup), isOfOneDistance(given));
  }

  /** As the simulator believes it: nine of ten pings with something before them within a tenth. */
  private static boolean isOfOneDistance(CalibratedLog given) {
    Geometry believed = new Geometry(given.log(), given.setup(), List.of());
    double[] nearest =
        IntStream.range(0, believed.pings())
            .mapToDouble(ping -> NearestRange.inConeM(believed, ping))
            .filter(Double::isFinite)
            .sorted()
            .toArray();
    return nearest.length > 0
        && Modes.quantile(nearest, 0.95) < (1 + ONE_DISTANCE) * Modes.quantile(nearest, 0.05);
  }

  /** The obstacles that look the same from all sides. */
  private static Set<String> round(SensingSetup setup) {
    Set<String> round = new HashSet<>();
    List<String> labels = Scenes.labels(setup.scene());
    for (int i = 0; i < labels.size(); i++) {
      Obstacle obstacle = setup.scene().obstacles().get(i);
      if (obstacle.detection() instanceof UniformDetection && isRound(obstacle.outline())) {
        round.add(labels.get(i));
      }
    }
    return round;
  }

  private static boolean isRound(Outline outline) {
    DoubleSummaryStatistics radii =
        outline.corners().stream()
            .mapToDouble(corner -> Math.hypot(corner.xM(), corner.zM()))
            .summaryStatistics();
    return radii.getCount() >= ROUND_CORNERS && radii.getMin() > ROUND * radii.getMax();
  }

  /** From ping to ping of one sensor in one run, seconds; 0 where there is no second ping. */
  private static double medianPeriodS(PingLog log) {
    double[] periods =
        IntStream.range(0, log.size())
            .filter(i -> i > log.sequenceStart(i))
            .mapToDouble(i -> log.timeS(i) - log.timeS(i - 1))
            .sorted()
            .toArray();
    return periods.length == 0 ? 0 : periods[periods.length / 2];
  }
}
