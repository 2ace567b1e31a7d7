package simbad.gap.fit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Modes;
import simbad.sonar.effect.Parameter;

/**
 * Looks for ranges that walk by the same step from ping to ping: the step that most strange echoes
 * keep from one to the next, then the length of their round on which most of them agree.
 */
final class WalkSearch {
  private static final int LARGEST_LAG = 4;
  private static final double WINDOW_M = 0.01;
  private static final int STEPS = 4;
  private static final double NEAR_STEP_M = 0.003;
  private static final double FINE_STEP_M = 0.0005;
  private static final double SHORT_M = 0.2;
  private static final double BEYOND_M = 0.5;
  private static final double FINE_END_M = 0.01;
  private static final double AGREE_M = 0.03;
  private static final int FEWEST = 8;
  private static final double SPREAD_M = 0.01;

  private final LogClues clues;
  private final int[] strange;

  WalkSearch(LogClues clues) {
    this.clues = clues;
    strange = clues.strangeEchoes().toArray();
  }

  /** A walk, and how many strange echoes agree with where it starts. */
  private record Walk(double stepM, double bandM, double startM, long votes) {}

  /** Values of a {@code walking} form to start from; its neutral ones where nothing walks. */
  List<double[]> starts(Form form) {
    List<double[]> starts = new ArrayList<>();
    if (strange.length >= FEWEST) {
      double share = Math.min(0.7, (double) strange.length / clues.log.size());
      double low = Arrays.stream(strange).mapToDouble(clues.log::rangeM).min().orElse(0);
      double nearest = form.parameters().get(1).clamp(low);
      Parameter sense = form.parameters().get(3);
      for (double step : steps().stream().filter(sense::permits).toList()) {
        Walk walk = best(step, form.parameters().get(2));
        starts.add(
            new double[] {share, nearest, walk.bandM(), walk.stepM(), walk.startM(), SPREAD_M});
      }
    }
    return starts.isEmpty() ? List.of(form.neutral()) : starts;
  }

  private List<Double> steps() {
    return Modes.of(
        IntStream.range(1, strange.length)
            .filter(i -> isLater(strange[i - 1], strange[i]))
            .mapToDouble(
                i ->
                    (clues.log.rangeM(strange[i]) - clues.log.rangeM(strange[i - 1]))
                        / (strange[i] - strange[i - 1])),
        WINDOW_M,
        STEPS);
  }

  private boolean isLater(int before, int ping) {
    return ping - before <= LARGEST_LAG && clues.log.sequenceStart(ping) <= before;
  }

  private Walk best(double about, Parameter round) {
    double farthest = Arrays.stream(strange).mapToDouble(clues.log::rangeM).max().orElse(1);
    double shortest = round.clamp(farthest - SHORT_M);
    double longest = round.clamp(farthest + BEYOND_M);
    Walk best = new Walk(about, shortest, 0, 0);
    for (double step = about - NEAR_STEP_M; step <= about + NEAR_STEP_M; step += FINE_STEP_M) {
      for (double band = shortest; band <= longest; band += FINE_END_M) {
        Walk walk = voted(step, band);
        best = walk.votes() > best.votes() ? walk : best;
      }
    }
    return best;
  }

  private Walk voted(double step, double band) {
    int[] votes = new int[(int) Math.ceil(band / AGREE_M) + 1];
    int most = 0;
    for (int ping : strange) {
      int order = ping - clues.log.sequenceStart(ping);
      double start = clues.log.rangeM(ping) - step * order;
      int window = (int) ((start - band * Math.floor(start / band)) / AGREE_M);
      votes[window]++;
      most = votes[window] > votes[most] ? window : most;
    }
    return new Walk(step, band, (most + 0.5) * AGREE_M, votes[most]);
  }
}
