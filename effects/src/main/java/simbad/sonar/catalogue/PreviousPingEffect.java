package simbad.sonar.catalogue;

import static simbad.sonar.effect.FittedValues.text;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.definition.Trait;
import simbad.sonar.change.GhostReading;
import simbad.sonar.change.NearerByPrevious;
import simbad.sonar.change.PreviousPing;
import simbad.sonar.change.SecondBounce;
import simbad.sonar.effect.Clues;
import simbad.sonar.effect.Definition;
import simbad.sonar.effect.FittedValues;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.effect.LogDesign;
import simbad.sonar.effect.Modes;
import simbad.sonar.effect.Probe;
import simbad.sonar.effect.Tries;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;

/** An echo of the ping before is taken for one of this ping. */
public final class PreviousPingEffect implements Definition {
  /** Fewer ghosts than these are no effect: a form as free as this one finds some in any log. */
  private static final Parameter GHOSTS = Parameter.of("share", 0, 0.03, 1, 0.1, 0.4);

  private static final Parameter SPREAD = Parameter.of("spread_m", 0, 0, 0.1, 0.002);
  private static final Parameter SHIFT = Parameter.of("shift_m", 0, -0.3, 5, -0.05, 0.05);
  private static final double AUDIBLE_RANGES = 4;
  private static final double WIDTH = 0.03;
  private static final int MODES = 4;
  private static final String BOUNCE = "bounce";

  /** Readings of a board are off by a little for any reason, and by a twentieth of their range. */
  private static final double NEARER = 0.95;

  private static final double LEAST_M = 0.02;

  /**
   * How far sound goes and comes back while a program and a sensor do what no log tells: 1.2 ms.
   */
  private static final double MOST_BEFORE_M = 0.2;

  @Override
  public Effect effect() {
    return Effect.PREVIOUS_PING;
  }

  @Override
  public String happens() {
    return "an echo of the previous ping is taken for one of this ping";
  }

  @Override
  public String briefly() {
    return "an echo of the ping before is taken for one of this";
  }

  @Override
  public String cause() {
    return "pings that follow each other faster than the echoes die away";
  }

  @Override
  public List<Form> forms(SensingSetup setup, List<String> sensors) {
    return List.of(
        Form.of(
            effect(),
            "shift",
            v -> new PreviousPing(v[0], 1, v[1], v[2]),
            GHOSTS,
            Parameter.of("shift_m", 0, 0.02, 5, 0.2, 0.5, 1),
            SPREAD),
        Form.of(
            effect(),
            "factor",
            v -> new PreviousPing(v[0], v[1], 0, v[2]),
            GHOSTS,
            Parameter.of("factor", 1, 0.05, 0.96, 0.3, 0.5, 0.8),
            SPREAD),
        Form.of(
            effect(),
            "line",
            v -> new PreviousPing(v[0], v[1], v[2], v[3]),
            GHOSTS,
            Parameter.of("factor", 1, 0.05, 2.2, 0.3, 0.5, 0.8, 2),
            SHIFT,
            SPREAD),
        Form.of(
            effect(),
            "nearer",
            v -> new NearerByPrevious(v[0], v[1], v[2], v[3], v[4]),
            GHOSTS,
            Parameter.of("own_factor", 1, 0.5, 2.2, 1, 2),
            Parameter.of("before_factor", 0, -1.5, 1, -0.3, -1),
            Parameter.of("shift_m", 0, -1, 3, 0, 0.2),
            SPREAD),
        read("read-nearer", true),
        read("read", false),
        bounce());
  }

  private Form bounce() {
    return Form.of(
        effect(),
        BOUNCE,
        v -> new SecondBounce(v[0], v[1], v[2], v[3]),
        GHOSTS,
        Parameter.of("shift_m", 0, 0, 3, 0.2),
        Parameter.of("spread_m", 0, 0, 0.1, 0.01),
        Parameter.of("least_m", LEAST_M, LEAST_M, 1, LEAST_M));
  }

  private Form read(String name, boolean onlyNearer) {
    return Form.of(
        effect(),
        name,
        v -> new GhostReading(v[0], v[1], v[2], v[3], onlyNearer),
        GHOSTS,
        Parameter.of("factor", 1, 0.05, 2.2, 0.5, 1, 2),
        SHIFT,
        SPREAD);
  }

  @Override
  public List<double[]> starts(Form form, Clues clues) {
    PingLog log = clues.log();
    List<List<Double>> tries = Tries.of(form);
    return switch (form.name()) {
      case "line" -> lines(form, clues, early(clues).toArray());
      case "read-nearer", "read" ->
          lines(form, clues, clues.strangeEchoes().filter(clues::hasEchoBefore).toArray());
      case "nearer" -> nearer(form, clues);
      case BOUNCE -> bounces(form, clues);
      case "shift" -> {
        DoubleStream by = early(clues).mapToDouble(i -> log.rangeM(i - 1) - log.rangeM(i));
        tries.set(1, Modes.of(by, WIDTH, MODES));
        yield Tries.combined(form, tries);
      }
      default -> {
        DoubleStream times = early(clues).mapToDouble(i -> log.rangeM(i) / log.rangeM(i - 1));
        tries.set(1, Modes.of(times, WIDTH, MODES));
        yield Tries.combined(form, tries);
      }
    };
  }

  /** On lines that many of some echoes lie on. */
  private static List<double[]> lines(Form form, Clues clues, int... echoes) {
    List<List<Double>> tries = Tries.of(form);
    List<double[]> starts = new ArrayList<>();
    for (Clues.Line line : clues.lines(echoes)) {
      starts.addAll(
          Tries.product(
              form, tries.get(0), List.of(line.slope()), List.of(line.shiftM()), tries.get(3)));
    }
    return starts.isEmpty() ? Tries.combined(form, tries) : starts;
  }

  /** Echoes too near by an amount: for pairs of factors the shift that most agree on. */
  private static List<double[]> nearer(Form form, Clues clues) {
    PingLog log = clues.log();
    List<List<Double>> tries = Tries.of(form);
    int[] near = tooNear(clues, 1, 0.02);
    List<double[]> starts = new ArrayList<>();
    for (int pair = 0; pair < tries.get(1).size(); pair++) {
      double own = tries.get(1).get(pair);
      double before = tries.get(2).get(pair);
      DoubleStream shifts =
          Arrays.stream(near)
              .mapToDouble(
                  i -> own * clues.nearestM(i) + before * log.rangeM(i - 1) - log.rangeM(i));
      List<Double> shift = Modes.of(shifts, WIDTH, 1);
      starts.addAll(
          Tries.product(form, tries.get(0), List.of(own), List.of(before), shift, tries.get(4)));
    }
    return starts;
  }

  /**
   * Echoes that are far too near, whatever else is taken for them (crosstalk takes up any): the
   * pauses that most agree on, and from where on the sensor listens.
   */
  private static List<double[]> bounces(Form form, Clues clues) {
    PingLog log = clues.log();
    List<List<Double>> tries = Tries.of(form);
    int[] near = tooNear(clues, NEARER, WIDTH);
    DoubleStream pauses =
        Arrays.stream(near)
            .mapToDouble(i -> 2 * clues.nearestM(i) - log.rangeM(i - 1) - log.rangeM(i));
    List<Double> shifts = new ArrayList<>();
    for (double shift : Modes.of(pauses, WIDTH, 2)) {
      // What the base does to ranges is not counted in it.
      for (double off = -WIDTH; off <= WIDTH; off += WIDTH / 2) {
        shifts.add(Math.max(0, shift + off));
      }
    }
    double[] read = Arrays.stream(near).mapToDouble(log::rangeM).sorted().toArray();
    double leastM = read.length == 0 ? LEAST_M : Modes.quantile(read, 0.05);
    return Tries.product(
        form, tries.get(0), shifts, tries.get(2), List.of(LEAST_M, Math.max(LEAST_M, leastM)));
  }

  /** Echoes after an echo that are nearer than so many times what is believed, and by a margin. */
  private static int[] tooNear(Clues clues, double times, double marginM) {
    return clues
        .echoesInCone()
        .filter(clues::hasEchoBefore)
        .filter(i -> clues.log().rangeM(i) < times * clues.nearestM(i) - marginM)
        .toArray();
  }

  /** Strange echoes that are nearer than the reading before. */
  private static IntStream early(Clues clues) {
    return clues
        .strangeEchoes()
        .filter(clues::hasEchoBefore)
        .filter(i -> clues.log().rangeM(i) < clues.log().rangeM(i - 1));
  }

  /** A twentieth of the readings. */
  @Override
  public List<Probe> probes(SensingSetup setup, PingLog log) {
    return List.of(
        Probe.tried(Forms.find(effect(), "shift", setup, log.sensors()).orElseThrow(), 0, 0.05));
  }

  /**
   * Beyond four times the range at which the best target is just heard no echo of the ping before
   * is left: at four times that range spreading takes 12 dB or more of a wall's echo and air of 1.3
   * dB/m, over the way there and back from 4 m on, another 31 dB. Readings of one place resemble
   * each other for any reason, and the free forms take that up: where pings follow each other fast
   * there, the second bounce alone is looked for.
   */
  @Override
  public boolean canShow(Form form, LogDesign log) {
    boolean isOpen = BOUNCE.equals(form.name()) ? isFast(log) : !(isFast(log) && log.isRepeated());
    return isOpen && !(log.wayM() > AUDIBLE_RANGES * log.setup().sensor().maxRangeM());
  }

  /** Whether pings go out before the one before can have come back from the greatest range. */
  private static boolean isFast(LogDesign log) {
    return log.wayM() > 0 && log.wayM() < log.setup().sensor().maxRangeM();
  }

  /**
   * Where pings follow each other so fast, second bounces come by themselves, after a pause that
   * the log tells. The other forms take up too much else.
   */
  @Override
  public boolean isInvited(Form form, LogDesign log, double... values) {
    return BOUNCE.equals(form.name())
        && isFast(log)
        && Math.abs(values[1] - log.pauseM()) < MOST_BEFORE_M;
  }

  @Override
  public String remedy(FittedValues values) {
    return text(
        "wait longer between pings, until the echoes of the one before have died:"
            + " %.0f %% of the pings hear them",
        100 * values.value("share"));
  }

  @Override
  public Set<Trait> traits() {
    return Set.of(Trait.KNOWS_THE_PING_BEFORE, Trait.SOAKS_UP);
  }
}
