package simbad.blindworld.effect;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/** The names of effects, with the stage at which each acts, and every form of each. */
public final class Vocabulary {

  /** Where in the way of a reading an effect acts; those of one stage are hard to tell apart. */
  public enum Stage {
    /** Poses and times. */
    POSE,
    /** What stands where. */
    MAP,
    /** Beam and strength. */
    ENERGY,
    /** Other arrivals, and echoes that are lost. */
    ARRIVAL,
    /** The range of an echo. */
    RANGE,
    /** Scatter, steps and what is reported. */
    OUTPUT
  }

  private static final String PLACED = "placement-error";

  private static final Map<String, Stage> STAGES =
      Map.ofEntries(
          Map.entry("sound-speed", Stage.RANGE),
          Map.entry("range-offset", Stage.RANGE),
          Map.entry("coarse-resolution", Stage.OUTPUT),
          Map.entry("range-noise", Stage.OUTPUT),
          Map.entry("crosstalk", Stage.ARRIVAL),
          Map.entry("multipath", Stage.ARRIVAL),
          Map.entry("dropout", Stage.ARRIVAL),
          Map.entry("gain", Stage.ENERGY),
          Map.entry("absorption", Stage.ENERGY),
          Map.entry("beam-pattern", Stage.ENERGY),
          Map.entry("beam-width", Stage.ENERGY),
          Map.entry("beam-misalignment", Stage.ENERGY),
          Map.entry("floor-echo", Stage.ARRIVAL),
          Map.entry("unmodelled-object", Stage.MAP),
          Map.entry("latency", Stage.POSE),
          Map.entry("stale-reading", Stage.OUTPUT),
          Map.entry("hysteresis", Stage.ARRIVAL),
          Map.entry("obstacle-turn", Stage.MAP),
          Map.entry("obstacle-offset", Stage.MAP),
          Map.entry("odometry-scale", Stage.POSE),
          Map.entry("heading-drift", Stage.POSE),
          Map.entry("dead-zone", Stage.ARRIVAL),
          Map.entry("early-timeout", Stage.ARRIVAL),
          Map.entry("near-clamp", Stage.OUTPUT),
          Map.entry("previous-ping", Stage.ARRIVAL),
          Map.entry("orientation-shadow", Stage.ENERGY),
          Map.entry("no-echo-code", Stage.OUTPUT),
          Map.entry("wrap", Stage.OUTPUT),
          Map.entry(PLACED, Stage.POSE),
          Map.entry("wave-hop", Stage.RANGE),
          Map.entry("range-walk", Stage.RANGE),
          Map.entry("vertical-beam", Stage.ENERGY),
          Map.entry("range-drift", Stage.RANGE));

  /** In the order in which they act when several do. */
  private static final List<Form> FORMS =
      Stream.of(
              PoseForms.all(),
              MapForms.all(),
              EnergyForms.all(),
              ObjectForms.all(),
              ArrivalForms.all(),
              GateForms.all(),
              RangeForms.all(),
              OutputForms.all(),
              OutsideForms.all())
          .flatMap(List::stream)
          .toList();

  private static final List<Form> FURTHER =
      Stream.concat(FurtherForms.all().stream(), PlacementForms.all(PLACED).stream()).toList();

  private static final List<Form> ALL = Stream.concat(FORMS.stream(), FURTHER.stream()).toList();

  private Vocabulary() {}

  /** The names of the vocabulary that have a form here, sorted: the 26 of its first version. */
  public static List<String> names() {
    return FORMS.stream().map(Form::effect).distinct().filter(n -> contains(n)).sorted().toList();
  }

  /** The names of its second version that have a form here, sorted: drawn where asked for. */
  public static List<String> further() {
    return FURTHER.stream().map(Form::effect).distinct().sorted().toList();
  }

  /** True where a hand has to put the sonar in place and read it there several times. */
  public static boolean needsPlacements(String name) {
    return name.equals(PLACED);
  }

  private static Stream<Form> formsOf(String name) {
    return ALL.stream().filter(f -> f.effect().equals(name));
  }

  /** The names of changes that the vocabulary does not cover, sorted. */
  public static List<String> outside() {
    return FORMS.stream().map(Form::effect).distinct().filter(n -> !contains(n)).sorted().toList();
  }

  /** True for one of the vocabulary's 33 names. */
  public static boolean contains(String name) {
    return STAGES.containsKey(name);
  }

  /** True when the two act at different stages, so that a pair of them is a fair question. */
  public static boolean isFairPair(String first, String second) {
    Stage a = STAGES.get(first);
    return a != null && a != STAGES.get(second);
  }

  /** True when both are names of the vocabulary and act at the same stage. */
  public static boolean isSameStage(String first, String second) {
    Stage a = STAGES.get(first);
    return a != null && a == STAGES.get(second);
  }

  /** The labels of the forms of an effect. */
  public static List<String> forms(String name) {
    return formsOf(name).map(Form::label).toList();
  }

  /** True when at least one form of the effect can be put in. */
  public static boolean applies(String name, Circumstances circumstances) {
    return !applying(name, circumstances).isEmpty();
  }

  private static List<Form> applying(String name, Circumstances circumstances) {
    return formsOf(name).filter(f -> f.applies().test(circumstances)).toList();
  }

  /** An effect in one of the forms that apply, drawn by chance. */
  public static Effect draw(String name, Circumstances circumstances) {
    return circumstances.oneOf(applying(name, circumstances)).in(circumstances);
  }

  /** An effect in the form with the label. */
  public static Effect draw(String name, String label, Circumstances circumstances) {
    return applying(name, circumstances).stream()
        .filter(f -> f.label().equals(label))
        .findFirst()
        .orElseThrow(() -> new IllegalArgumentException(name + " " + label + " does not apply"))
        .in(circumstances);
  }

  /** The effects in the order in which they act on a ping. */
  public static List<Effect> inOrder(List<Effect> effects) {
    List<String> order = ALL.stream().map(Form::effect).distinct().toList();
    return effects.stream().sorted(Comparator.comparingInt(e -> order.indexOf(e.name()))).toList();
  }
}
