package simbad.gap.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/**
 * What a hypothesis is worth on blocks that it was not fitted to.
 *
 * @param full the fit to all blocks
 * @param folds the fit that left each fold out
 * @param blockScores log score per block, foretold by the fit that left it out
 * @param residuals of every window, by the fit that left it out
 */
@SuppressWarnings("ArrayRecordComponent") // Numbers by window, never compared.
record HeldOut(Fit full, List<Fit> folds, double[] blockScores, double[][] residuals) {

  static HeldOut of(Evidence evidence, Fit full) {
    Fitter fitter = new Fitter(evidence);
    List<Fit> folds =
        IntStream.range(0, Evidence.FOLDS)
            .parallel()
            .mapToObj(fold -> fitter.fit(full.hypothesis(), fitter.without(fold)))
            .toList();
    double[] scores = new double[evidence.blockCount()];
    double[][] residuals = new double[evidence.size()][];
    for (int i = 0; i < evidence.size(); i++) {
      Fit fold = folds.get(evidence.fold(i));
      residuals[i] = fold.residuals()[i];
      scores[evidence.block(i)] += fold.scatter().logDensity(residuals[i]);
    }
    return new HeldOut(full, new ArrayList<>(folds), scores, residuals);
  }

  /** Returns by how many of its standard errors this foretells better than another. */
  double z(HeldOut other) {
    return z(blockScores, other.blockScores);
  }

  /** The same for any score per block; 0 where there are too few blocks to tell. */
  static double z(double[] these, double[] others) {
    int n = these.length;
    if (n < 4) {
      return 0;
    }
    double mean = 0;
    for (int i = 0; i < n; i++) {
      mean += (these[i] - others[i]) / n;
    }
    double square = 0;
    for (int i = 0; i < n; i++) {
      double off = these[i] - others[i] - mean;
      square += off * off;
    }
    return square == 0 ? 0 : mean / Math.sqrt(square / (n - 1) / n);
  }
}
