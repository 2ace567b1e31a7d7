package simbad.gap.fit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Parameter;

/** Where the search for a form's values starts: at its own tries, or where the log points. */
final class Starts {
  private static final int QUANTILES = 20;
  private static final int MODES = 4;

  /** Of detours, over their length. */
  private static final List<Double> SPREADS = List.of(0.03, 0.25);

  private final Clues clues;

  Starts(Clues clues) {
    this.clues = clues;
  }

  /** Values to start from; at least one set. */
  List<double[]> of(Form form) {
    List<List<Double>> tries = new ArrayList<>();
    form.parameters().forEach(parameter -> tries.add(parameter.tries()));
    return switch (form.effect()) {
      case SOUND_SPEED -> speeds(form, tries);
      case FLOOR_ECHO -> floor(form, tries);
      case UNMODELLED_OBJECT -> object(form);
      case MULTIPATH -> multipath(form, tries);
      case PREVIOUS_PING -> ghosts(form, tries);
      case CROSSTALK -> crosstalk(form, tries.get(0));
      case COARSE_RESOLUTION -> product(form, new Rhythm(clues.log).steps());
      case NEAR_CLAMP -> product(form, leastReadings(tries.get(0)));
      case DEAD_ZONE, EARLY_TIMEOUT ->
          tries.size() == 1
              ? product(form, distances(tries.get(0)))
              : product(form, distances(tries.get(0)), tries.get(1));
      case ORIENTATION_SHADOW -> shadows(form);
      case NO_ECHO_CODE ->
          product(form, codes(form.parameters().get(0)), tries.get(1), tries.get(2));
      case WRAP -> product(form, moduli(tries.get(0)));
      default -> all(form, tries);
    };
  }

  @SafeVarargs
  @SuppressWarnings("varargs")
  private static List<double[]> product(Form form, List<Double>... tries) {
    return all(form, List.of(tries));
  }

  /** All combinations, each value moved into its parameter's interval. */
  private static List<double[]> all(Form form, List<List<Double>> tries) {
    List<double[]> all = List.of(new double[0]);
    for (int i = 0; i < tries.size(); i++) {
      Parameter parameter = form.parameters().get(i);
      List<Double> values = tries.get(i).isEmpty() ? parameter.tries() : tries.get(i);
      List<double[]> longer = new ArrayList<>();
      for (double[] begun : all) {
        for (double value : values) {
          double[] more = Arrays.copyOf(begun, begun.length + 1);
          more[begun.length] = parameter.clamp(value);
          longer.add(more);
        }
      }
      all = longer;
    }
    return all;
  }

  /** Numbers that strange readings have again and again, to the millimetre. */
  private List<Double> codes(Parameter code) {
    return modes(strange().filter(range -> code.permits(range)), 1e-3);
  }

  /** What readings that are too near are too near by. */
  private List<Double> moduli(List<Double> tries) {
    List<Double> moduli = new ArrayList<>(tries);
    moduli.addAll(
        modes(
            clues
                .echoesInCone()
                .filter(i -> clues.log.rangeM(i) < clues.nearestM(i) - 0.05)
                .mapToDouble(i -> clues.nearestM(i) - clues.log.rangeM(i)),
            0.01));
    return moduli;
  }

  /** A form that is about no single obstacle has no number: each obstacle's waves may be all's. */
  private List<double[]> shadows(Form form) {
    if (form.name().indexOf('#') < 0) {
      return IntStream.range(0, clues.geometry.obstacles())
          .mapToObj(obstacle -> new TableSearch(clues, obstacle).waves())
          .toList();
    }
    return List.of(
        form.isTable()
            ? TableSearch.tables(clues, form)
            : new TableSearch(clues, TableSearch.obstacles(form)[0]).waves());
  }

  private DoubleStream strange() {
    return clues.strangeEchoes().mapToDouble(clues.log::rangeM);
  }

  private static List<Double> modes(DoubleStream values, double width) {
    return Modes.of(values, width, MODES);
  }

  private List<double[]> object(Form form) {
    return form.name().equals("post")
        ? new PostSearch(clues, form.parameters().get(3).high()).starts()
        : new FaceSearch(clues).starts(form);
  }

  /** That of which most readings are the same multiple of a distance, beside the usual ones. */
  private List<double[]> speeds(Form form, List<List<Double>> tries) {
    DoubleStream logarithms =
        clues
            .echoesInCone()
            .filter(i -> clues.log.rangeM(i) > 0 && clues.nearestM(i) > 0)
            .mapToDouble(i -> Math.log(clues.log.rangeM(i) / clues.nearestM(i)));
    List<Double> speeds = new ArrayList<>(tries.get(0));
    double assumed = form.parameters().get(0).neutral();
    modes(logarithms, 0.02).forEach(logarithm -> speeds.add(assumed / Math.exp(logarithm)));
    return product(form, speeds);
  }

  private List<double[]> floor(Form form, List<List<Double>> tries) {
    tries.set(0, modes(strange(), 0.02));
    tries.set(1, List.of(0.01, 0.04));
    return all(form, tries);
  }

  private List<double[]> multipath(Form form, List<List<Double>> tries) {
    return switch (form.name()) {
      case "added" -> product(form, tries.get(0), longerBy(), SPREADS);
      case "factor" -> product(form, tries.get(0), longerTimes(), SPREADS);
      case "tail" -> all(form, tries);
      default ->
          product(form, List.of(0.1), longerBy(), List.of(0.1), longerTimes(), List.of(0.03));
    };
  }

  /** Echoes that came by a longer way than to the nearest obstacle. */
  private IntStream late() {
    return clues.echoesInCone().filter(i -> clues.log.rangeM(i) > clues.nearestM(i) + 0.02);
  }

  private List<Double> longerBy() {
    return modes(late().mapToDouble(i -> clues.log.rangeM(i) - clues.nearestM(i)), 0.04);
  }

  private List<Double> longerTimes() {
    return modes(late().mapToDouble(i -> clues.log.rangeM(i) / clues.nearestM(i)), 0.04);
  }

  private List<double[]> ghosts(Form form, List<List<Double>> tries) {
    if (form.name().equals("shift")) {
      tries.set(
          1, modes(early().mapToDouble(i -> clues.log.rangeM(i - 1) - clues.log.rangeM(i)), 0.03));
    } else if (form.name().equals("line")) {
      return lines(form, tries, early().toArray());
    } else if (form.name().startsWith("read")) {
      return lines(form, tries, clues.strangeEchoes().filter(clues::hasEchoBefore).toArray());
    } else if (form.name().equals("nearer")) {
      return nearer(form, tries);
    } else {
      tries.set(
          1, modes(early().mapToDouble(i -> clues.log.rangeM(i) / clues.log.rangeM(i - 1)), 0.03));
    }
    return all(form, tries);
  }

  /** On lines that many of some echoes lie on. */
  private List<double[]> lines(Form form, List<List<Double>> tries, int... echoes) {
    List<double[]> starts = new ArrayList<>();
    for (LineSearch.Line line : new LineSearch(clues.log, echoes).best()) {
      starts.addAll(
          product(form, tries.get(0), List.of(line.slope()), List.of(line.shiftM()), tries.get(3)));
    }
    return starts.isEmpty() ? all(form, tries) : starts;
  }

  /** Echoes too near by an amount: for pairs of factors the shift that most agree on. */
  private List<double[]> nearer(Form form, List<List<Double>> tries) {
    int[] near =
        clues
            .echoesInCone()
            .filter(clues::hasEchoBefore)
            .filter(i -> clues.log.rangeM(i) < clues.nearestM(i) - 0.02)
            .toArray();
    List<double[]> starts = new ArrayList<>();
    for (int pair = 0; pair < tries.get(1).size(); pair++) {
      double own = tries.get(1).get(pair);
      double before = tries.get(2).get(pair);
      List<Double> shift =
          Modes.of(
              Arrays.stream(near)
                  .mapToDouble(
                      i ->
                          own * clues.nearestM(i)
                              + before * clues.log.rangeM(i - 1)
                              - clues.log.rangeM(i)),
              0.03,
              1);
      starts.addAll(
          product(form, tries.get(0), List.of(own), List.of(before), shift, tries.get(4)));
    }
    return starts;
  }

  /** Strange echoes that are nearer than the reading before. */
  private IntStream early() {
    return clues
        .strangeEchoes()
        .filter(clues::hasEchoBefore)
        .filter(i -> clues.log.rangeM(i) < clues.log.rangeM(i - 1));
  }

  private List<double[]> crosstalk(Form form, List<Double> shares) {
    if (form.name().startsWith("walking")) {
      return new WalkSearch(clues).starts(form);
    }
    double[] sorted = strange().sorted().toArray();
    if (sorted.length == 0) {
      return product(form, shares, List.of(), List.of());
    }
    double low = Modes.quantile(sorted, 0.02) - 0.02;
    double high = Modes.quantile(sorted, 0.98) + 0.02;
    double most = form.parameters().get(2).high();
    double share = (double) sorted.length / clues.log.size();
    List<Double> bands = List.of(high - low, most);
    return product(form, List.of(share, 2 * share), List.of(low, 0.05), bands);
  }

  private List<Double> leastReadings(List<Double> tries) {
    List<Double> least = new ArrayList<>(tries);
    IntStream.range(0, clues.log.size())
        .filter(clues.log::echo)
        .mapToDouble(clues.log::rangeM)
        .min()
        .ifPresent(
            range -> {
              least.add(range);
              least.add(range + 0.005);
            });
    return least;
  }

  private List<Double> distances(List<Double> tries) {
    double[] sorted = clues.audibleM().sorted().toArray();
    if (sorted.length == 0) {
      return tries;
    }
    return IntStream.rangeClosed(1, QUANTILES)
        .mapToObj(i -> Modes.quantile(sorted, (double) i / (QUANTILES + 1)))
        .toList();
  }
}
