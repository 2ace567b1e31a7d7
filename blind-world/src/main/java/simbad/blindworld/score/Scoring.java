package simbad.blindworld.score;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;

/**
 * Answers of several sorts to the same truths, scored side by side and by level of independence.
 */
public final class Scoring {

  private final List<Truth> truths;
  private final Optional<Origin> origin;
  private final Map<String, Map<String, Answer>> answersBySort = new LinkedHashMap<>();
  private final Map<String, Map<String, Particulars>> particulars = new LinkedHashMap<>();

  /** A scoring of answers to these truths. */
  public Scoring(List<Truth> truths) {
    this(truths, Optional.empty());
  }

  /**
   * A scoring of answers to truths of one origin.
   *
   * @param truths what was at work
   * @param origin of all of them; absent for worlds of equations, which are of two levels
   */
  public Scoring(List<Truth> truths, Optional<Origin> origin) {
    this.truths = List.copyOf(truths);
    this.origin = origin;
  }

  /**
   * Where truths come from.
   *
   * @param what they are
   * @param level of independence
   */
  public record Origin(String what, String level) {

    /** This program's worlds of waves. */
    public static final Origin WAVE = new Origin("worlds of waves", "L2w");

    /** This program's robots. */
    public static final Origin MOTION = new Origin("worlds of motion", "M1 and M2");

    /** Data sets of others, with the level that their makers state. */
    public static Origin foreign(String level) {
      return new Origin("foreign data sets", level);
    }

    String part() {
      return what + " (" + level + ")";
    }
  }

  /** Adds answers under the name of a sort, such as "diagnosis", "baseline", "oracle". */
  public void add(String sort, Map<String, Answer> answers) {
    answersBySort.put(sort, Map.copyOf(answers));
  }

  /** Adds what answers of a sort say in numbers, by case. */
  public void addParticulars(String sort, Map<String, Particulars> byCase) {
    particulars.put(sort, Map.copyOf(byCase));
  }

  /** A part of the cases that is scored by itself. */
  private record Part(String name, Predicate<Truth> holds) {}

  /**
   * The parts: without a reference the world keeps to the same equations (L1); with one its set-up
   * differs in physics (L2).
   */
  private static final List<Part> PARTS =
      List.of(
          new Part("all cases (L1 and L2)", t -> true),
          new Part("set-up as believed (L1)", t -> !t.reference()),
          new Part("set-up off, with reference (L2)", Truth::reference));

  /** Of motion: without a reference a robot is as believed (M1), with one a little off (M2). */
  private static final List<Part> MOTION_PARTS =
      List.of(
          new Part("worlds of motion (M1 and M2)", t -> true),
          new Part("robot as believed (M1)", t -> !t.reference()),
          new Part("robot off, with reference (M2)", Truth::reference));

  private List<Part> parts() {
    boolean motion = origin.equals(Optional.of(Origin.MOTION));
    if (origin.isPresent() && !motion) {
      return List.of(new Part(origin.get().part(), t -> true));
    }
    boolean mixed =
        truths.stream().anyMatch(Truth::reference) && !truths.stream().allMatch(Truth::reference);
    boolean off = truths.stream().allMatch(Truth::reference);
    List<Part> all = motion ? MOTION_PARTS : PARTS;
    return mixed ? all : List.of(all.get(off ? 2 : 1));
  }

  private Scores scores(String sort, Part part) {
    return new Scores(
        graded(sort).stream().filter(graded -> part.holds().test(graded.truth())).toList(),
        particulars.getOrDefault(sort, Map.of()));
  }

  private List<Graded> graded(String sort) {
    Map<String, Answer> answers = answersBySort.getOrDefault(sort, Map.of());
    List<Graded> graded = new ArrayList<>();
    for (Truth truth : truths) {
      graded.add(new Graded(truth, Optional.ofNullable(answers.get(truth.id()))));
    }
    return graded;
  }

  /** Each case by itself, as the sort answers it. */
  public List<Object> casesJson(String sort) {
    Optional<String> level = origin.map(Origin::level);
    return origin.equals(Optional.of(Origin.MOTION))
        ? CaseLines.json(graded(sort), "M1", "M2")
        : CaseLines.json(graded(sort), level.orElse("L1"), level.orElse("L2"));
  }

  /** How many of a sort's answers come with predictions. */
  public Proportion predictions(String sort) {
    List<Graded> answered = graded(sort).stream().filter(g -> g.answer().isPresent()).toList();
    return Scores.share(answered, g -> g.answer().orElseThrow().predicts());
  }

  /** Everything, by part and sort. */
  public Map<String, Object> json() {
    Map<String, Object> json = new LinkedHashMap<>();
    for (Part part : parts()) {
      Map<String, Object> bySort = new LinkedHashMap<>();
      answersBySort.keySet().forEach(sort -> bySort.put(sort, scores(sort, part).json()));
      json.put(part.name(), bySort);
    }
    return json;
  }

  /** A table for people. */
  public String text() {
    StringBuilder text = new StringBuilder();
    for (Part part : parts()) {
      Map<String, Scores> bySort = new LinkedHashMap<>();
      answersBySort.keySet().forEach(sort -> bySort.put(sort, scores(sort, part)));
      text.append(new Table(part.name(), bySort).text()).append('\n');
    }
    String first = answersBySort.keySet().stream().findFirst().orElse("");
    text.append("\nby effect, worst first (").append(first).append(")\n");
    List<Graded> all = graded(first);
    for (Effects.Line line : Effects.lines(all)) {
      text.append("  %-24s %s%n".formatted(line.effect(), line.right()));
    }
    return text.append(wrong(all)).toString();
  }

  /** Each case that was answered wrongly: what was so, and what was said. */
  private static String wrong(List<Graded> all) {
    StringBuilder text = new StringBuilder("\nanswered wrongly\n");
    for (Graded g : all) {
      if (!g.right()) {
        text.append(
            "  %-10s %-44s %s%n".formatted(g.truth().id(), CaseLines.so(g.truth()), g.said()));
      }
    }
    return text.toString();
  }
}
