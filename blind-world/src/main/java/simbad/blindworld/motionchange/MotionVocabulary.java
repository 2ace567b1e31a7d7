package simbad.blindworld.motionchange;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;

/** The names of effects of motion, with the stage at which each acts, and every form of each. */
public final class MotionVocabulary {

  private static final Map<String, String> STAGES =
      Map.ofEntries(
          Map.entry("speed-scale", "scale"),
          Map.entry("turn-scale", "scale"),
          Map.entry("wheel-scale", "scale"),
          Map.entry("wheel-asymmetry", "turning"),
          Map.entry("turn-bias", "turning"),
          Map.entry("actuation-latency", "time"),
          Map.entry("actuation-lag", "time"),
          Map.entry("time-offset", "time"),
          Map.entry("dead-band", "command"),
          Map.entry("saturation", "command"),
          Map.entry("command-quantization", "command"),
          Map.entry("slip", "chance"),
          Map.entry("motion-noise", "chance"),
          Map.entry("capture-offset", "track"));

  private static final List<MotionForm> FORMS =
      Stream.of(
              CommandForms.all(),
              TimeForms.all(),
              ScaleForms.all(),
              ChanceForms.all(),
              OutsideMotion.all())
          .flatMap(List::stream)
          .toList();

  private MotionVocabulary() {}

  /** The vocabulary's names, sorted. */
  public static List<String> names() {
    return STAGES.keySet().stream().sorted().toList();
  }

  /** The names of changes that the vocabulary does not cover, sorted. */
  public static List<String> outside() {
    return FORMS.stream()
        .map(MotionForm::effect)
        .distinct()
        .filter(n -> !contains(n))
        .sorted()
        .toList();
  }

  /** True for one of the vocabulary's names. */
  public static boolean contains(String name) {
    return STAGES.containsKey(name);
  }

  /** True when the two act at different stages, so that a pair of them is a fair question. */
  public static boolean isFairPair(String first, String second) {
    String a = STAGES.get(first);
    return a != null && !a.equals(STAGES.get(second));
  }

  /** True when both are names of the vocabulary and act at the same stage. */
  public static boolean isSameStage(String first, String second) {
    String a = STAGES.get(first);
    return a != null && a.equals(STAGES.get(second));
  }

  /** The labels of the forms of an effect. */
  public static List<String> forms(String name) {
    return FORMS.stream().filter(f -> f.effect().equals(name)).map(MotionForm::label).toList();
  }

  /** True when at least one form of the effect can be put in. */
  public static boolean applies(String name, MotionSite site) {
    return FORMS.stream().anyMatch(f -> f.effect().equals(name) && f.applies().test(site));
  }

  /** An effect in one of the forms that apply, drawn by chance. */
  public static MotionEffect draw(String name, MotionSite site) {
    List<MotionForm> fitting =
        FORMS.stream().filter(f -> f.effect().equals(name) && f.applies().test(site)).toList();
    return fitting.get(site.random().nextInt(fitting.size())).in(site);
  }

  /** An effect in the form with the label. */
  public static MotionEffect draw(String name, String label, MotionSite site) {
    return FORMS.stream()
        .filter(f -> f.effect().equals(name) && f.label().equals(label))
        .findFirst()
        .orElseThrow(() -> new IllegalArgumentException(name + " " + label + ": no such form"))
        .in(site);
  }

  /**
   * The sets of names by which an effect may be called whatever its size: what physics cannot part,
   * and what adds up to it.
   */
  public static List<Set<String>> accept(String name) {
    return switch (name) {
      case "wheel-scale" -> List.of(Set.of("wheel-scale"), Set.of("speed-scale", "turn-scale"));
      case "actuation-latency" -> List.of(Set.of("actuation-latency"), Set.of("time-offset"));
      case "time-offset" -> List.of(Set.of("time-offset"), Set.of("actuation-latency"));
      default -> List.of(Set.of(name));
    };
  }

  /** The names that may do the same as an effect where a log shows little of it. */
  public static List<String> rivals(String name) {
    List<String> rivals = new ArrayList<>();
    for (List<String> group : LIKE) {
      if (group.contains(name)) {
        group.stream().filter(n -> !n.equals(name) && !rivals.contains(n)).forEach(rivals::add);
      }
    }
    return rivals;
  }

  private static final List<List<String>> LIKE =
      List.of(
          List.of("actuation-latency", "actuation-lag"),
          List.of("time-offset", "actuation-lag"),
          List.of("speed-scale", "wheel-scale", "saturation"),
          List.of("turn-scale", "wheel-scale"),
          List.of("wheel-asymmetry", "turn-bias"),
          List.of("slip", "motion-noise"),
          List.of("dead-band", "command-quantization"),
          List.of("dead-band", "speed-scale"));
}
