package simbad.gap.calibrate;

import java.util.List;
import java.util.concurrent.ForkJoinTask;
import java.util.stream.Stream;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Fold;
import simbad.gap.fit.Hypothesis;
import simbad.gap.score.Blocks;
import simbad.gap.unexplained.Surprise;
import simbad.sonar.check.Checks;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SensorLaw;

/**
 * By which law a sensor hears, the threshold rule or the level law: its reference says, and its log
 * has a word in it. A round pole's reference says little (all round it hears alike), and a log that
 * goes where the reference was not may refute what the reference preferred by a little. Then both
 * laws are asked what the log shows, and the one is taken under which reference and log together
 * are likelier.
 */
public final class Laws {
  private Laws() {}

  /**
   * A law, calibrated.
   *
   * @param calibration on the whole reference
   * @param referenceNats by how much better it foretells echoes of the reference that it was not
   *     fitted on than the threshold rule does, natural; 0 for that rule itself and for a law that
   *     nothing was compared with
   */
  public record Law(Calibration calibration, double referenceNats) {
    /** Refuses what is no number. */
    public Law {
      Checks.number("referenceNats", referenceNats);
    }

    /**
     * Returns how well reference and log are foretold, whether there were echoes and not where:
     * comparable between laws.
     *
     * @param given the log, before the set-up that the explanation stands beside
     * @param settled that set-up
     * @param explanation of the log; its own cost is not taken off
     */
    public double nats(CalibratedLog given, Calibration settled, Hypothesis explanation) {
      CalibratedLog open = settled.opened(given, explanation);
      double echoes = new Surprise(open, explanation).echoNats(Fold.ALL);
      return referenceNats + echoes;
    }
  }

  /**
   * Calibrates the law that the scene states; else the one that foretells better what it was not
   * fitted on of the reference, and behind it the other one where the log, with nothing changed,
   * speaks for that by more than the reference does for the first.
   *
   * @param setup as believed
   * @param reference of the same set-up while the simulation was trusted
   * @param log that is diagnosed
   * @return one law or two
   */
  public static List<Law> of(SensingSetup setup, PingLog reference, PingLog log) {
    if (setup.sensor().law().model().isPresent() || !new Blocks(reference).canBeHeldOut()) {
      return List.of(new Law(Calibration.of(setup, reference), 0));
    }
    ForkJoinTask<Double> gains =
        ForkJoinTask.adapt(() -> new Rivals(setup, reference).gainedNats()).fork();
    List<Calibration> calibrated =
        Stream.of(SensorLaw.Model.THRESHOLD, SensorLaw.Model.LEVEL)
            .parallel()
            .map(law -> Calibration.of(setup.under(law), reference))
            .toList();
    double gained = gains.join();
    Law threshold = new Law(calibrated.get(0), 0);
    Law level = new Law(calibrated.get(1), gained);
    Law first = gained > 0 ? level : threshold;
    Law second = gained > 0 ? threshold : level;
    double lead = unchanged(first, setup, log) - unchanged(second, setup, log);
    return lead > 0 ? List.of(first) : List.of(first, second);
  }

  private static double unchanged(Law law, SensingSetup setup, PingLog log) {
    CalibratedLog given = law.calibration.given(setup, log);
    return law.nats(given, law.calibration, Hypothesis.NONE);
  }
}
