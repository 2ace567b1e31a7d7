package simbad.experiments.fidelity;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;
import simbad.experiments.run.Experiment;
import simbad.experiments.run.RunResult;
import simbad.experiments.run.RunSettings;
import simbad.experiments.run.SensorKind;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleType;
import simbad.sonar.model.SensorModel;
import simbad.sonar.scene.SonarSpec;

/**
 * The suite as JUnit tests: extend it, name a model, and every obstacle becomes a test. JUnit is
 * not among what this project brings along at run time; the program that extends this class has it.
 */
public abstract class FidelitySuite {
  private static final double SPEED_M_PER_S = 0.05;

  /** Returns the model to test. */
  protected abstract SensorModel model();

  /** Returns the obstacles with their tables; the thesis's three unless overridden. */
  protected List<ObstacleType> obstacles() {
    return Catalogue.types();
  }

  /** Returns the sonar's figures; the SRF04's unless overridden. */
  protected SonarSpec sonar() {
    return Catalogue.srf04();
  }

  /** Returns what has to be reached. */
  protected FidelityLimits limits() {
    return FidelityLimits.STANDARD;
  }

  @TestFactory
  final Stream<DynamicTest> model_isFaithfulToTheTable() {
    return obstacles().stream()
        .map(type -> DynamicTest.dynamicTest(type.name(), () -> checkFaithful(type)));
  }

  private void checkFaithful(ObstacleType type) {
    FidelityVerdict verdict = FidelityVerdict.of(run(type), limits());
    assertTrue(verdict.passes(), type.name() + ": " + verdict.sentence());
  }

  private RunResult run(ObstacleType type) {
    SensorKind kind = SensorKind.of("tested", model());
    return Experiment.run(
            new RunSettings(
                List.of(type), List.of(kind), sonar(), SPEED_M_PER_S, Optional.empty(), 1),
            result -> {})
        .get(0);
  }
}
