package simbad.gap.fit;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import simbad.sonar.change.OrientationShadow;
import simbad.sonar.effect.Clues;
import simbad.sonar.effect.Form;
import simbad.sonar.ping.Change;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.PingLog;
import simbad.sonar.ping.Scenes;
import simbad.sonar.predict.ChangedModel;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.shape.ThresholdTable;

/** What a hypothesis leaves over: readings that it thinks hardly possible, echoes it misses. */
final class LogClues implements Clues {
  /** A reading with less than this is one that the hypothesis does not explain, log probability. */
  private static final double STRANGE = Math.log(1e-3);

  final PingLog log;
  final Geometry geometry;
  private final double[] logLikelihood;
  private final double[] nearest;
  private final CalibratedLog given;
  private final Hypothesis hypothesis;
  private final Fold fold;
  private final Optional<HeardArc> arc;

  LogClues(CalibratedLog given, Hypothesis hypothesis) {
    this(given, hypothesis, Fold.ALL);
  }

  LogClues(CalibratedLog given, Hypothesis hypothesis, Fold fold) {
    this.given = given;
    this.hypothesis = hypothesis;
    this.fold = fold;
    log = given.log();
    ChangedModel model = given.model(hypothesis);
    geometry = given.geometry(model);
    logLikelihood = new double[log.size()];
    given.logLikelihood(model, geometry, logLikelihood);
    nearest = new double[log.size()];
    for (int ping = 0; ping < nearest.length; ping++) {
      nearest[ping] = NearestRange.inConeM(geometry, ping);
    }
    arc = ArcSearch.find(this);
  }

  /** Pings that count and have an obstacle in the cone. */
  IntStream inCone(int obstacle) {
    return IntStream.range(0, log.size())
        .filter(fold::holds)
        .filter(
            ping ->
                geometry.nearestM(ping * geometry.obstacles() + obstacle)
                    < Double.POSITIVE_INFINITY);
  }

  /** Softness of the threshold as believed, metres. */
  double edgeWidthM() {
    return setup().sensor().edgeWidthM();
  }

  /** The set-up as the simulator believes it. */
  SensingSetup setup() {
    return given.setup();
  }

  /** How probable each reading is if the threshold of an obstacle is the same all round. */
  double[] likelihood(List<OrientationShadow> others, int obstacle, double thresholdM) {
    List<Change> changes = new ArrayList<>(hypothesis.changes());
    changes.addAll(others);
    changes.add(shadow(obstacle, ThresholdTable.uniform(ThresholdTable.LEAST_SIZE, thresholdM)));
    double[] likelihood = given.logLikelihood(changes);
    for (int i = 0; i < likelihood.length; i++) {
      likelihood[i] = Math.exp(likelihood[i]);
    }
    return likelihood;
  }

  /** What an obstacle's thresholds would be a table of. */
  OrientationShadow shadow(int obstacle, ThresholdTable table) {
    return new OrientationShadow(Optional.of(Scenes.labels(setup().scene()).get(obstacle)), table);
  }

  @Override
  public PingLog log() {
    return log;
  }

  @Override
  public int obstacles() {
    return geometry.obstacles();
  }

  @Override
  public IntStream strangeEchoes() {
    return IntStream.range(0, log.size())
        .filter(ping -> log.echo(ping) && logLikelihood[ping] < STRANGE);
  }

  @Override
  public IntStream echoesInCone() {
    return IntStream.range(0, log.size())
        .filter(ping -> log.echo(ping) && nearest[ping] < Double.POSITIVE_INFINITY);
  }

  @Override
  public double nearestM(int ping) {
    return nearest[ping];
  }

  @Override
  public DoubleStream audibleM() {
    return IntStream.range(0, log.size() * geometry.obstacles())
        .filter(
            line ->
                geometry.nearestM(line) < Double.POSITIVE_INFINITY
                    && geometry.centreDistanceM(line) < geometry.thresholdM(line))
        .mapToDouble(geometry::nearestM);
  }

  @Override
  public boolean hasEchoBefore(int ping) {
    return ping > log.sequenceStart(ping) && log.echo(ping - 1);
  }

  @Override
  public List<Double> steps() {
    return new Rhythm(log).steps();
  }

  @Override
  public List<Line> lines(int... echoes) {
    return new LineSearch(log, echoes).best();
  }

  @Override
  public List<double[]> posts(double mostReachM) {
    return new PostSearch(this, mostReachM).starts();
  }

  @Override
  public List<double[]> faces(Form form) {
    return new FaceSearch(this).starts(form);
  }

  @Override
  public List<double[]> walks(Form form) {
    return new WalkSearch(this).starts(form);
  }

  @Override
  public double[] tables(int... obstacles) {
    return TableSearch.tables(this, obstacles);
  }

  @Override
  public double[] waves(int obstacle) {
    return new TableSearch(this, obstacle).waves();
  }

  @Override
  public Optional<HeardArc> heardArc() {
    return arc;
  }
}
