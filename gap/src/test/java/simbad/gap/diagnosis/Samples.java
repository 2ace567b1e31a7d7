package simbad.gap.diagnosis;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import simbad.definition.Effect;
import simbad.gap.fit.Hypothesis;
import simbad.sonar.catalogue.SetupForms;
import simbad.sonar.effect.Definitions;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Point;
import simbad.sonar.frame.Pose;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.scene.UniformDetection;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;
import simbad.sonar.shape.Outline;

/** A data set of two rows and a diagnosis with everything in it, by hand. */
final class Samples {
  static final SensingSetup SETUP =
      new SensingSetup(
          new SonarSpec("S", 0.5, 0.03, 4, 0.1, 343, 0.01, 0.005, 0.01, 0.02, 0.1),
          new Scene(
              List.of(
                  new Obstacle(
                      "post",
                      new Placement(0, 0, 0),
                      Outline.of(List.of(new Point(0, 0), new Point(0.1, 0), new Point(0, 0.1))),
                      new UniformDetection(2)))),
          4);

  static final DataSet DATA =
      new DataSet(
          "by-hand",
          SETUP,
          List.of(
              new ReadingRow("a", "s", 0, Pose.of(1, 0, Math.PI), new Echo(0.9)),
              new ReadingRow("a", "s", 1, Pose.of(3, 0, Math.PI), NoEcho.NO_ECHO)),
          List.of());

  static final DiagnosisProvenance PROVENANCE =
      new DiagnosisProvenance(
          Map.of("scene.json", "0".repeat(64), "readings.csv", "a".repeat(64)), "1", 7);

  private Samples() {}

  static Diagnosis diagnosis() {
    return diagnosis(Verdict.UNEXPLAINED);
  }

  static Diagnosis diagnosis(Verdict verdict) {
    Form offset = Forms.find(Effect.RANGE_OFFSET, "constant", SETUP, List.of("s")).orElseThrow();
    Form tails = SetupForms.find("tails", SETUP, List.of()).orElseThrow();
    Place.Condition bearing =
        new Place.Condition(
            "bearing_deg", Optional.of(new Interval(10, 20.00000001)), Optional.empty());
    Place.Condition run = new Place.Condition("run", Optional.empty(), Optional.of("a"));
    return new Diagnosis(
        verdict,
        "offset_m stands at the end",
        List.of(Effect.RANGE_OFFSET),
        findings(),
        0.0625,
        0.96,
        List.of(new AtBound(Effect.RANGE_OFFSET, "offset_m", 1, new Interval(-1, 1))),
        new GapFigures(2, 3.2, 1.6, 1.5, 0.5, new Interval(Double.NEGATIVE_INFINITY, 0.6)),
        List.of(
            new BudgetEntry("range-offset", 1.6, new Interval(1.2, 1.9)),
            new BudgetEntry(BudgetEntry.REST, 0.1, new Interval(0, 0.3)),
            new BudgetEntry(BudgetEntry.FLOOR, 1.5, new Interval(1.4, 1.6))),
        List.of(new Place(List.of(bearing, run), 30, 0.4, 9, 1, GapKind.MISSED_ECHO, 1e-9)),
        List.of(
            new Undetectable(Effect.DEAD_ZONE, "least_m", OptionalDouble.empty()),
            new Undetectable(Effect.LATENCY, "delay_s", OptionalDouble.of(0.25))),
        Optional.of(
            new NextExperiment(
                List.of(Effect.RANGE_OFFSET, Effect.SOUND_SPEED), DATA.readings(), 12.5)),
        Hypothesis.NONE.and(offset, 0.05),
        Hypothesis.NONE.and(tails, 0.1, 0.03),
        List.of(
            new Diagnosis.Attempt(List.of(Effect.RANGE_OFFSET), 123.456, 0),
            new Diagnosis.Attempt(List.of(), 0, Double.POSITIVE_INFINITY)),
        Map.of("misfit", 0.25),
        Optional.empty(),
        List.of());
  }

  private static List<EffectFinding> findings() {
    List<EffectFinding> findings = new ArrayList<>();
    findings.add(
        new EffectFinding(
            Effect.RANGE_OFFSET,
            1,
            Optional.of("constant"),
            List.of(
                new FittedParameter(
                    "offset_m", 1 / 3.0, new Interval(0.04, Double.POSITIVE_INFINITY))),
            List.of(Effect.SOUND_SPEED)));
    Definitions.effects().stream()
        .filter(effect -> effect != Effect.RANGE_OFFSET)
        .map(effect -> new EffectFinding(effect, 0, Optional.empty(), List.of(), List.of()))
        .forEach(findings::add);
    return findings;
  }
}
