package simbad.gap.fit;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.WeakHashMap;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import simbad.sonar.change.BeamMisalignment;
import simbad.sonar.model.ReadingDistribution;
import simbad.sonar.ping.Change;
import simbad.sonar.ping.Geometry;
import simbad.sonar.predict.Answers;
import simbad.sonar.predict.ChangedModel;
import simbad.sonar.scene.SensingSetup;

/**
 * How probable readings are where headings are known to some degrees only: the mean over what each
 * heading may be, by Gauss and Hermite's rule of five points.
 *
 * <p>A cone's border is sharp. Where a model puts it beside a reading, a third of a degree decides
 * whether there is an echo; taken exactly, two such readings outweigh all others. Only pings at
 * which another heading sees something else are asked again. Safe for use by several threads.
 */
final class UnsureHeadings {
  /** In standard deviations; Abramowitz and Stegun 25.10, for a normal weight. */
  private static final double[] AT = {
    -2.856970013872806, -1.355626179974266, 1.355626179974266, 2.856970013872806
  };

  private static final double[] WEIGHT = {
    0.01125741132772069, 0.2220759220056126, 0.2220759220056126, 0.01125741132772069
  };

  private final SensingSetup setup;
  private final double sigmaRad;

  /** A geometry is one of a model's: it is known by itself. */
  private final Map<Geometry, Sides> known = new WeakHashMap<>();

  /** What is seen beside the headings as written, of which pings. */
  private static final class Sides {
    final List<Side> sides;
    final boolean @Nullable [] only;

    Sides(List<Side> sides, boolean @Nullable [] only) {
      this.sides = sides;
      this.only = only;
    }
  }

  /** What is seen with all headings turned by so much, and at which pings it is something else. */
  private static final class Side {
    final Geometry geometry;
    final boolean[] differs;
    final double weight;

    Side(Geometry geometry, boolean[] differs, double weight) {
      this.geometry = geometry;
      this.differs = differs;
      this.weight = weight;
    }
  }

  private UnsureHeadings(SensingSetup setup, double sigmaRad) {
    this.setup = setup;
    this.sigmaRad = sigmaRad;
  }

  /**
   * Empty where headings are exact, under the level law, which has no border, and of drives: there
   * few readings have one border in common, and all geometry would cost four times more.
   *
   * @param setup as the simulator believes it
   * @param plain geometry of the log
   */
  static Optional<UnsureHeadings> of(SensingSetup setup, Geometry plain) {
    double sigma = setup.details().headingSigmaRad();
    return sigma > 0 && plain.ears() == null && plain.log().isOfOnePlace()
        ? Optional.of(new UnsureHeadings(setup, sigma))
        : Optional.empty();
  }

  /**
   * Takes the mean over headings.
   *
   * @param model of a hypothesis
   * @param geometry of the log under it
   * @param into how probable each reading is at the headings as written; takes the mean
   * @param echoes the same of any echo; null if it is not asked for
   * @param only which pings are asked for, null for all
   */
  void average(
      ChangedModel model,
      Geometry geometry,
      double[] into,
      double @Nullable [] echoes,
      boolean @Nullable [] only) {
    double[] straight = into.clone();
    double[] straightEchoes = echoes == null ? null : echoes.clone();
    double[] there = new double[into.length];
    double[] echoesThere = echoes == null ? null : new double[into.length];
    for (Side side : sides(model, geometry, only)) {
      boolean[] asked = asked(side, only);
      model.likelihood(side.geometry, there, echoesThere, asked, new Answers());
      for (int i = 0; i < asked.length; i++) {
        if (asked[i]) {
          into[i] += side.weight * (there[i] - straight[i]);
          if (echoes != null && echoesThere != null && straightEchoes != null) {
            echoes[i] += side.weight * (echoesThere[i] - straightEchoes[i]);
          }
        }
      }
    }
  }

  /**
   * Takes the mean of forecasts.
   *
   * @param model of a hypothesis
   * @param geometry of the log under it
   * @param straight forecast of each ping at the heading as written
   */
  List<ReadingDistribution> average(
      ChangedModel model, Geometry geometry, List<ReadingDistribution> straight) {
    List<Side> sides = sides(model, geometry, null);
    List<List<ReadingDistribution>> there =
        sides.stream().map(side -> model.forecast(side.geometry)).toList();
    List<ReadingDistribution> mixed = new ArrayList<>(straight);
    for (int ping = 0; ping < mixed.size(); ping++) {
      List<ReadingDistribution> others = new ArrayList<>();
      DoubleStream.Builder shares = DoubleStream.builder();
      for (int i = 0; i < there.size(); i++) {
        if (sides.get(i).differs[ping]) {
          others.add(there.get(i).get(ping));
          shares.add(sides.get(i).weight);
        }
      }
      if (!others.isEmpty()) {
        mixed.set(ping, straight.get(ping).mixed(others, shares.build().toArray()));
      }
    }
    return mixed;
  }

  private static boolean[] asked(Side side, boolean @Nullable [] only) {
    boolean[] asked = side.differs.clone();
    for (int i = 0; only != null && i < asked.length; i++) {
      asked[i] &= only[i];
    }
    return asked;
  }

  private List<Side> sides(ChangedModel model, Geometry geometry, boolean @Nullable [] only) {
    synchronized (known) {
      Sides before = known.get(geometry);
      if (before != null && (before.only == null || before.only == only)) {
        return before.sides;
      }
    }
    List<Side> sides = new ArrayList<>();
    for (int i = 0; i < AT.length; i++) {
      List<Change> turned = new ArrayList<>(model.changes());
      turned.add(new BeamMisalignment(AT[i] * sigmaRad, Optional.empty()));
      Geometry there = new Geometry(geometry.log(), setup, turned, geometry, only);
      boolean[] differs = differs(geometry, there);
      if (IntStream.range(0, differs.length).anyMatch(ping -> differs[ping])) {
        sides.add(new Side(there, differs, WEIGHT[i]));
      }
    }
    synchronized (known) {
      known.put(geometry, new Sides(sides, only));
    }
    return sides;
  }

  private static boolean[] differs(Geometry straight, Geometry turned) {
    boolean[] differs = new boolean[straight.log().size()];
    for (int line = 0; line < differs.length * straight.obstacles(); line++) {
      differs[line / straight.obstacles()] |=
          NearestRange.isAnother(straight.sensor(), straight.nearestM(line), turned.nearestM(line));
    }
    return differs;
  }
}
