package simbad.benchmarks;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import simbad.experiments.dataset.MadeDataSet;
import simbad.experiments.dataset.TableGrid;
import simbad.gap.Diagnoser;
import simbad.gap.diagnosis.DataSet;
import simbad.gap.diagnosis.Diagnosis;
import simbad.obstacles.Catalogue;
import simbad.sonar.frame.Pose;
import simbad.sonar.model.NominalModel;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.Reading;
import simbad.sonar.sensing.ReadingRow;

/**
 * A whole diagnosis, all effects and pairs of them, by the number of readings: those round a post
 * as the simulator expects them, but 3 cm too long, and one echo in ten is lost.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.SingleShotTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(1)
@Warmup(iterations = 3)
@Measurement(iterations = 5)
@SuppressWarnings("NullAway.Init") // JMH calls the setup before anything else.
public class DiagnosisBenchmark {
  private static final long SEED = 1;
  private static final double OFFSET_M = 0.03;
  private static final double LOST_SHARE = 0.1;

  /** How many readings. */
  @Param({"300", "1000", "3000", "10000"})
  int rows;

  private DataSet data;

  /** Makes the readings: as many rounds over the same poses, shuffled, as it takes. */
  @Setup
  public void makeReadings() {
    SplittableRandom random = new SplittableRandom(SEED);
    MadeDataSet grid =
        TableGrid.of(Catalogue.find("round").orElseThrow(), Catalogue.srf04(), random);
    NominalModel model = new NominalModel(grid.setup().sensor(), grid.setup().scene());
    List<ReadingRow> readings = new ArrayList<>();
    for (int i = 0; i < rows; i++) {
      int place = i % grid.readings().size();
      Pose pose = grid.readings().get(place).pose();
      Reading expected = model.distribution(pose).sample(random);
      String run = "run " + i / grid.readings().size() + "-" + i % 2;
      readings.add(new ReadingRow(run, "S", i, pose, changed(expected, random)));
    }
    data = new DataSet("grid", grid.setup(), readings, List.of());
  }

  private static Reading changed(Reading expected, SplittableRandom random) {
    if (expected instanceof Echo echo && random.nextDouble() >= LOST_SHARE) {
      return new Echo(echo.rangeM() + OFFSET_M);
    }
    return NoEcho.NO_ECHO;
  }

  /** Diagnoses. */
  @Benchmark
  public Diagnosis diagnose() {
    return new Diagnoser(SEED, Set.of()).diagnose(data);
  }
}
