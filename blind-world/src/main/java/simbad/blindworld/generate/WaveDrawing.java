package simbad.blindworld.generate;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import simbad.blindworld.design.Design;
import simbad.blindworld.wave.Alteration;
import simbad.blindworld.wave.WaveWorld;
import simbad.blindworld.wavechange.Site;
import simbad.blindworld.wavechange.WaveEffect;
import simbad.blindworld.wavechange.WaveVocabulary;
import simbad.blindworld.wavesetup.Room;
import simbad.blindworld.wavesetup.User;
import simbad.blindworld.world.Chance;
import simbad.blindworld.world.Forecast;
import simbad.blindworld.world.Recording;
import simbad.blindworld.world.Repeats;
import simbad.blindworld.world.Scene;
import simbad.blindworld.world.Setup;
import simbad.blindworld.world.World;

/**
 * Draws one case of a world of waves: a room, its user's calibration, rows on two days, and a
 * change, again and again until the rows hold echoes enough and the change shows.
 */
final class WaveDrawing {

  private static final double LEAST_ECHO_SHARE = 0.1;
  private static final double MOST_ECHO_SHARE = 0.85;
  private static final double LEAST_STANDARD_ERRORS = 5;
  private static final int DRAWS = 600;

  /** Changes tried on one ground, whose calibration is what takes time. */
  private static final int TRIES = 3;

  /** After so many draws in vain sizes begin to grow. */
  private static final int PATIENCE = 20;

  /** After so many draws in vain another pair is tried, or an unknown by itself. */
  private static final int OTHER_PAIR = 60;

  /** After so many grounds in vain a robot may be tried for a bench, or a bench for a robot. */
  private static final int OTHER_KIND = 25;

  private static final int GROUNDS = 2000;
  private static final String ROBOT = "run";

  private static final int CHECK_REPEATS = 80;

  /** Rows of a sealed sheet; fewer than of a data set, for they are only forecast. */
  private static final int SEALED_ROWS = 700;

  private final Plan.Assignment assignment;
  private final Order order;
  private final Chance random;
  private List<String> names;
  private String kind = "";
  private int draws;

  WaveDrawing(Plan.Assignment assignment, Order order) {
    this.assignment = assignment;
    this.order = order;
    this.random = new Chance(assignment.seed());
    this.names = assignment.names();
  }

  /** A room with its calibration, and the day and rows of the readings. */
  private record Ground(
      Design design,
      Room room,
      User.Calibration calibration,
      WaveWorld.Parts day,
      Recording recording,
      Repeats unchanged) {

    Scene scene() {
      return calibration.scene();
    }

    WaveWorld world(List<WaveEffect> effects) {
      List<Alteration> alterations = effects.stream().map(WaveEffect::alteration).toList();
      return new WaveWorld(day, alterations);
    }
  }

  /** A set of effects with their sizes. */
  private record Changes(List<WaveEffect> effects, List<Double> sizes) {}

  WaveCase draw() {
    for (int grounds = 0; grounds < GROUNDS && draws < DRAWS; grounds++) {
      if (grounds % OTHER_KIND == 0) {
        // Not for every ground: benches hear more than robots, and few robots would be left.
        kind = kind();
      }
      Ground ground = ground();
      double[] plain = ground.unchanged.read(random.nextLong());
      List<Double> heard = Site.heard(plain);
      double share = (double) heard.size() / plain.length;
      boolean fits = share >= LEAST_ECHO_SHARE && share <= MOST_ECHO_SHARE;
      for (int tries = 0; fits && tries < TRIES; tries++) {
        draws++;
        names = draws % OTHER_PAIR == 0 ? easier() : names;
        Optional<WaveCase> drawn = findChanged(ground, plain, heard);
        if (drawn.isPresent()) {
          return drawn.get();
        }
      }
    }
    throw new IllegalStateException(
        "no case with " + assignment.names() + " that shows, in " + draws + " draws");
  }

  private String kind() {
    List<String> kinds = Design.kinds();
    return names.stream().anyMatch(WaveVocabulary::needsRobot)
        ? ROBOT
        : kinds.get(random.nextInt(kinds.size()));
  }

  /** The ground with changes that show, or without any where none are asked for. */
  private Optional<WaveCase> findChanged(Ground ground, double[] plain, List<Double> heard) {
    if (names.isEmpty()) {
      return findComplete(ground, new Changes(List.of(), List.of()), plain, 0);
    }
    Site site = site(ground, heard, 1);
    if (!names.stream().allMatch(name -> WaveVocabulary.applies(name, site))) {
      return Optional.empty();
    }
    Changes changes = changes(ground, heard);
    Repeats altered = ground.world(changes.effects).at(ground.recording);
    double[] readings = altered.read(random.nextLong());
    double z = z(ground, changes.effects, altered, readings);
    return z >= LEAST_STANDARD_ERRORS || !order.hasToShow(assignment.kind())
        ? findComplete(ground, changes, readings, z)
        : Optional.empty();
  }

  /** Another pair with the same first effect; what is unknown stands alone. */
  private List<String> easier() {
    return switch (assignment.kind()) {
      case PAIR -> Plan.otherPair(order, names.get(0), random);
      case TRIPLE -> Plan.otherTriple(order, names.get(0), random);
      case UNKNOWN -> names.subList(names.size() - 1, names.size());
      case NONE, SINGLE, WITHHELD -> names;
    };
  }

  private Ground ground() {
    Design design = Design.draw(kind, random.split());
    Room room = Room.draw(random.split());
    User.Calibration calibration = new User(room, random.split()).calibrate(design.periodS());
    WaveWorld.Parts day = room.onSomeDay(random).with(calibration.counter());
    Recording recording = design.record(calibration.scene(), rows(), random.split());
    Repeats unchanged = new WaveWorld(day, List.of()).at(recording);
    return new Ground(design, room, calibration, day, recording, unchanged);
  }

  private int rows() {
    return random.nextInt(order.rows().least(), order.rows().most() + 1);
  }

  private Site site(Ground ground, List<Double> heard, double size) {
    boolean driven = ground.design.kind().equals(ROBOT);
    return new Site(
        ground.room,
        ground.day,
        ground.scene(),
        ground.recording,
        driven,
        heard,
        random.split(),
        size);
  }

  private double size() {
    double grown = Math.min(1.5, Math.max(0, (double) (draws - PATIENCE) / PATIENCE));
    return order.size(assignment.kind(), grown, random);
  }

  /** Each with a size of its own. */
  private Changes changes(Ground ground, List<Double> heard) {
    List<WaveEffect> effects = new ArrayList<>();
    List<Double> sizes = new ArrayList<>();
    for (String name : names) {
      double size = size();
      sizes.add(size);
      effects.add(WaveVocabulary.draw(name, site(ground, heard, size)));
    }
    return new Changes(effects, sizes);
  }

  /** The least evidence for any one effect beside the others, in standard errors. */
  private double z(Ground ground, List<WaveEffect> effects, Repeats altered, double[] readings) {
    double least = Double.POSITIVE_INFINITY;
    double noEcho = ground.scene().noEchoM();
    Forecast whole = Forecast.of(altered, noEcho, CHECK_REPEATS, random.nextLong());
    for (WaveEffect effect : effects) {
      List<WaveEffect> others =
          effects.stream().filter(other -> !other.name().equals(effect.name())).toList();
      Repeats rest =
          others.isEmpty() ? ground.unchanged : ground.world(others).at(ground.recording);
      Forecast without = Forecast.of(rest, noEcho, CHECK_REPEATS, random.nextLong());
      least = Math.min(least, Evidence.of(whole, without, readings, noEcho).standardErrors());
    }
    return least;
  }

  /** The whole case; nothing when the other sheets happen to lie where nothing is heard. */
  private Optional<WaveCase> findComplete(
      Ground ground, Changes changes, double[] readings, double z) {
    Recording sealedRows = ground.design.record(ground.scene(), SEALED_ROWS, random.split());
    Repeats same = ground.world(List.of()).at(sealedRows);
    Recording otherRows = ground.design.record(ground.scene(), rows(), random.split());
    WaveWorld.Parts otherDay = ground.room.onSomeDay(random).with(ground.calibration.counter());
    Repeats trusted = new WaveWorld(otherDay, List.of()).at(otherRows);
    Case.Sheet reference = sheet(otherRows, trusted.read(random.nextLong()));
    double share = sheet(sealedRows, same.read(random.nextLong())).echoShare();
    if (Math.min(share, reference.echoShare()) < LEAST_ECHO_SHARE) {
      return Optional.empty();
    }
    Repeats altered = ground.world(changes.effects).at(sealedRows);
    Case.Sheet sealed = sheet(sealedRows, altered.read(random.nextLong()));
    Forecast oracle = forecast(ground, altered);
    Case.Gaps gaps =
        new Case.Gaps(
            gapCm(ground, forecast(ground, nominal(ground, sealedRows)), sealed),
            gapCm(ground, changes.effects.isEmpty() ? oracle : forecast(ground, same), sealed),
            gapCm(ground, oracle, sealed));
    WaveCase.Figures figures =
        new WaveCase.Figures(
            gaps,
            gapCm(ground, forecast(ground, nominal(ground, otherRows)), reference),
            gapCm(ground, forecast(ground, trusted), reference),
            z,
            changes.sizes,
            draws);
    return Optional.of(
        new WaveCase(
            assignment,
            ground.design.kind(),
            ground.room,
            ground.calibration,
            ground.day,
            changes.effects,
            new WaveCase.Sheets(sheet(ground.recording, readings), reference, sealed),
            oracle,
            figures));
  }

  private static Repeats nominal(Ground ground, Recording rows) {
    Scene scene = ground.scene();
    return new World(scene, Setup.nominal(scene.sensor()), List.of()).at(rows);
  }

  private Forecast forecast(Ground ground, Repeats listening) {
    return Forecast.of(listening, ground.scene().noEchoM(), order.repeats(), random.nextLong());
  }

  private static double gapCm(Ground ground, Forecast forecast, Case.Sheet sheet) {
    double[] ranges = sheet.rangesM().stream().mapToDouble(Double::doubleValue).toArray();
    return forecast.gapCm(ranges, ground.scene().noEchoM());
  }

  private static Case.Sheet sheet(Recording recording, double[] readings) {
    return new Case.Sheet(recording, Arrays.stream(readings).boxed().toList());
  }
}
