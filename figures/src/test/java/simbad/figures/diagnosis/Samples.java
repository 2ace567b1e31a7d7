package simbad.figures.diagnosis;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import simbad.definition.Effect;
import simbad.experiments.dataset.MadeDataSet;
import simbad.experiments.dataset.TableGrid;
import simbad.gap.diagnosis.BudgetEntry;
import simbad.gap.diagnosis.DataSet;
import simbad.gap.diagnosis.Diagnosis;
import simbad.gap.diagnosis.DiagnosisProvenance;
import simbad.gap.diagnosis.EffectFinding;
import simbad.gap.diagnosis.FittedParameter;
import simbad.gap.diagnosis.GapFigures;
import simbad.gap.diagnosis.GapKind;
import simbad.gap.diagnosis.Interval;
import simbad.gap.diagnosis.NextExperiment;
import simbad.gap.diagnosis.Place;
import simbad.gap.diagnosis.Undetectable;
import simbad.gap.diagnosis.Verdict;
import simbad.gap.fit.Hypothesis;
import simbad.obstacles.Catalogue;
import simbad.sonar.effect.Definitions;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;

/** Diagnoses by hand, of the square's readings against the original sensor. */
final class Samples {
  static final DiagnosisProvenance PROVENANCE =
      new DiagnosisProvenance(
          Map.of("scene.json", "0".repeat(64), "readings.csv", "a".repeat(64)), "1 <b>", 7);

  private static final double INFINITE = Double.POSITIVE_INFINITY;

  private Samples() {}

  static DataSet data(String name) {
    MadeDataSet made =
        TableGrid.of(
            Catalogue.find("square").orElseThrow(), Catalogue.srf04(), new SplittableRandom(1));
    return new DataSet(name, made.setup(), made.readings(), List.of());
  }

  /** Everything that a page can hold. */
  static Diagnosis explained(DataSet data) {
    Form gain = form(Effect.GAIN, data);
    return new Diagnosis(
        Verdict.EXPLAINED,
        "",
        List.of(Effect.GAIN),
        effects(
            finding(
                Effect.GAIN,
                0.991,
                List.of(Effect.ABSORPTION),
                new FittedParameter("factor", 0.5, new Interval(0.45, 0.55))),
            finding(
                Effect.ABSORPTION,
                0.4,
                List.of(Effect.GAIN),
                new FittedParameter("loss_per_m", 0.1234567, new Interval(-INFINITE, INFINITE))),
            finding(Effect.LATENCY, 0.004, List.of())),
        0.03,
        0.999,
        List.of(),
        new GapFigures(1500, 178.8, 60.25, 51.5, 0.663, new Interval(0.61, 0.7)),
        List.of(
            new BudgetEntry("gain", 118.55, new Interval(100, 130)),
            new BudgetEntry(BudgetEntry.REST, 8.75, new Interval(5, 12)),
            new BudgetEntry(BudgetEntry.FLOOR, 51.5, new Interval(50, 53))),
        places(),
        List.of(
            new Undetectable(Effect.DEAD_ZONE, "end_m", OptionalDouble.of(0.06)),
            new Undetectable(Effect.STALE_READING, "hold_s", OptionalDouble.empty())),
        Optional.of(
            new NextExperiment(
                List.of(Effect.GAIN, Effect.ABSORPTION), data.readings().subList(0, 40), 7.25)),
        Hypothesis.NONE.and(gain, 0.5),
        Hypothesis.NONE,
        List.of(
            new Diagnosis.Attempt(List.of(Effect.GAIN), 5000, 0),
            new Diagnosis.Attempt(List.of(Effect.GAIN, Effect.LATENCY), 4990.04, 20),
            new Diagnosis.Attempt(List.of(), 0, 4990)),
        Map.of(),
        Optional.empty(),
        List.of());
  }

  static Diagnosis without(Verdict verdict, DataSet data) {
    double unknown = verdict == Verdict.NONE ? 0.0001 : 0.97;
    return new Diagnosis(
        verdict,
        verdict == Verdict.UNDECIDED ? "there are <too few> readings" : "",
        List.of(),
        effects(),
        unknown,
        0.01,
        List.of(),
        new GapFigures(data.readings().size(), 2, 2, 1.95, 0, new Interval(-0.02, 0.02)),
        List.of(),
        List.of(),
        List.of(),
        Optional.empty(),
        Hypothesis.NONE,
        Hypothesis.NONE,
        List.of(new Diagnosis.Attempt(List.of(), 0, 0)),
        Map.of(),
        Optional.empty(),
        List.of());
  }

  static Form form(Effect effect, DataSet data) {
    return Forms.all(data.setup(), List.of("SRF04")).stream()
        .filter(form -> form.effect() == effect && form.parameters().size() == 1)
        .findFirst()
        .orElseThrow();
  }

  private static List<Place> places() {
    Place.Condition bearing =
        new Place.Condition("bearing_deg", Optional.of(new Interval(100, 170)), Optional.empty());
    Place.Condition distance =
        new Place.Condition(
            "distance_m", Optional.of(new Interval(0.5, INFINITE)), Optional.empty());
    Place.Condition run =
        new Place.Condition("run", Optional.empty(), Optional.of("<i>run</i>".repeat(9)));
    return List.of(
        new Place(List.of(bearing, distance), 310, 0.41, 420, 90, GapKind.MISSED_ECHO, 0.0002),
        new Place(List.of(run), 40, 0.05, 60, 61, GapKind.RANGE_ERROR, 0.04));
  }

  private static EffectFinding finding(
      Effect effect, double probability, List<Effect> tied, FittedParameter... parameters) {
    Optional<String> form = parameters.length == 0 ? Optional.empty() : Optional.of("factor");
    return new EffectFinding(effect, probability, form, List.of(parameters), tied);
  }

  private static List<EffectFinding> effects(EffectFinding... first) {
    List<EffectFinding> all = new ArrayList<>(List.of(first));
    List<Effect> there = all.stream().map(EffectFinding::effect).toList();
    Definitions.effects().stream()
        .filter(effect -> !there.contains(effect))
        .forEach(effect -> all.add(finding(effect, 0, List.of())));
    return all;
  }

  /** The page of a diagnosis. */
  static String page(Diagnosis diagnosis, DataSet data) {
    List<RowFinding> rows =
        RowSurvey.of(data, diagnosis.fitted().changes(), new SplittableRandom(7));
    return DiagnosisPage.of(diagnosis, data, rows, PROVENANCE);
  }
}
