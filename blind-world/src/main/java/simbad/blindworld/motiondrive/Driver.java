package simbad.blindworld.motiondrive;

import java.util.List;
import java.util.random.RandomGenerator;
import simbad.blindworld.motion.Commands.Speeds;

/** Says what a robot is told next. */
interface Driver {

  /** What is told at a time of a run; called with rising times. */
  Speeds next(double timeS);

  /** The greatest speeds that a driver asks for. */
  record Limits(double vMPerS, double wRadPerS) {
    Speeds of(double v, double w) {
      return new Speeds(
          Math.max(-1, Math.min(1, v)) * vMPerS, Math.max(-1, Math.min(1, w)) * wRadPerS);
    }
  }

  /** The kinds of drive. */
  enum Kind {
    WANDER,
    ARCS,
    STOP_AND_GO,
    SQUARES,
    JOYSTICK,
    EDGE,
    SLALOM,
    SHUTTLE,
    CREEP;

    /** As truths spell it. */
    String word() {
      return name().toLowerCase(java.util.Locale.ROOT).replace('_', '-');
    }
  }

  /** A driver of a kind, with ways of its own. */
  static Driver draw(Kind kind, Limits limits, RandomGenerator random) {
    return switch (kind) {
      case WANDER -> wander(limits, random);
      case ARCS -> new Pieces(limits, random, Driver::arc);
      case STOP_AND_GO -> new Pieces(limits, random, new StopAndGo());
      case SQUARES -> new Pieces(limits, random, new Squares(limits, random));
      case JOYSTICK -> joystick(limits, random);
      case EDGE -> edge(limits, random);
      case SLALOM -> slalom(limits, random);
      case SHUTTLE -> new Pieces(limits, random, new Shuttle());
      case CREEP -> new Pieces(limits, random, Driver::creeping);
    };
  }

  /** Shares of the limits that are told for a while. */
  record Piece(double v, double w, double whileS) {}

  /** Makes one piece after the other. */
  interface Maker {
    Piece make(RandomGenerator random);
  }

  /** Constant speeds, a piece at a time. */
  final class Pieces implements Driver {
    private final Limits limits;
    private final RandomGenerator random;
    private final Maker maker;
    private Piece now = new Piece(0, 0, 0);
    private double endS = Double.NEGATIVE_INFINITY;

    Pieces(Limits limits, RandomGenerator random, Maker maker) {
      this.limits = limits;
      this.random = random;
      this.maker = maker;
    }

    @Override
    public Speeds next(double timeS) {
      if (timeS >= endS) {
        now = maker.make(random);
        endS = Math.max(endS, timeS - 1) + now.whileS;
        endS = Math.max(endS, timeS + 0.05);
      }
      return limits.of(now.v, now.w);
    }
  }

  private static Piece arc(RandomGenerator random) {
    double w = random.nextInt(4) == 0 ? 0 : random.nextDouble(-1, 1);
    double v = random.nextInt(8) == 0 ? random.nextDouble(-0.6, -0.2) : random.nextDouble(0.15, 1);
    return new Piece(v, w, random.nextDouble(0.8, 4));
  }

  /** Slow and quick by turns, over a range of a factor of twenty. */
  private static Piece creeping(RandomGenerator random) {
    double v = StrictMath.pow(20, -random.nextDouble());
    double w = StrictMath.pow(20, -random.nextDouble()) * (random.nextBoolean() ? 1 : -1);
    boolean straight = random.nextInt(4) == 0;
    return new Piece(
        random.nextInt(6) == 0 ? -v : v, straight ? 0 : w, random.nextDouble(0.6, 2.5));
  }

  /** Goes, stops, and now and then turns on the spot. */
  final class StopAndGo implements Maker {
    private boolean going;

    @Override
    public Piece make(RandomGenerator random) {
      going = !going;
      if (!going) {
        return random.nextInt(3) == 0
            ? new Piece(0, random.nextDouble(-1, 1), random.nextDouble(0.4, 1.5))
            : new Piece(0, 0, random.nextDouble(0.4, 1.8));
      }
      double w = random.nextDouble(-0.3, 0.3);
      double v = random.nextInt(7) == 0 ? -0.5 : random.nextDouble(0.3, 1);
      return new Piece(v, w, random.nextDouble(0.8, 3));
    }
  }

  /** Sides and corners of squares, now one way round, now the other, and now and then back. */
  final class Squares implements Maker {
    private final double sideS;
    private final double cornerS;
    private final double v;
    private final double w;
    private int made;
    private int hand = 1;

    Squares(Limits limits, RandomGenerator random) {
      v = random.nextDouble(0.4, 1);
      w = random.nextDouble(0.4, 1);
      sideS = random.nextDouble(2, 6);
      cornerS = Math.PI / 2 / (w * limits.wRadPerS());
    }

    @Override
    public Piece make(RandomGenerator random) {
      boolean side = made++ % 2 == 0;
      if (made % 16 == 0) {
        hand = -hand;
      }
      if (!side) {
        return new Piece(0, hand * w, cornerS);
      }
      return random.nextInt(9) == 0 ? new Piece(-v / 2, 0, sideS) : new Piece(v, 0, sideS);
    }
  }

  /** Forth and back with a little steering. */
  final class Shuttle implements Maker {
    private int way = 1;

    @Override
    public Piece make(RandomGenerator random) {
      way = -way;
      return new Piece(
          way * random.nextDouble(0.3, 1), random.nextDouble(-0.4, 0.4), random.nextDouble(1, 4));
    }
  }

  /** Speeds that wander about a mean. */
  private static Driver wander(Limits limits, RandomGenerator random) {
    double constantS = random.nextDouble(0.8, 3);
    return new Driver() {
      private double last = Double.NaN;
      private double v;
      private double w;

      @Override
      public Speeds next(double timeS) {
        double dt = Double.isNaN(last) ? 10 * constantS : timeS - last;
        last = timeS;
        double keep = StrictMath.exp(-dt / constantS);
        double fresh = Math.sqrt(1 - keep * keep);
        v = keep * v + fresh * random.nextGaussian();
        w = keep * w + fresh * random.nextGaussian();
        return limits.of(0.5 + 0.25 * v, 0.45 * w);
      }
    };
  }

  /** Sticks that are pushed to the stop or a part of the way, by a hand that takes a while. */
  private static Driver joystick(Limits limits, RandomGenerator random) {
    double handS = random.nextDouble(0.1, 0.35);
    Maker hand =
        r ->
            new Piece(
                r.nextInt(3) == 0 ? 1.1 : r.nextDouble(-0.5, 1),
                r.nextInt(3) == 0 ? 0 : r.nextDouble(-1.1, 1.1),
                r.nextDouble(0.5, 2.5));
    Driver wanted = new Pieces(new Limits(1, 1), random, hand);
    return new Driver() {
      private double last = Double.NaN;
      private double v;
      private double w;

      @Override
      public Speeds next(double timeS) {
        double keep = Double.isNaN(last) ? 0 : StrictMath.exp(-(timeS - last) / handS);
        last = timeS;
        Speeds to = wanted.next(timeS);
        v = to.vMPerS() + keep * (v - to.vMPerS());
        w = to.wRadPerS() + keep * (w - to.wRadPerS());
        return limits.of(played(v), played(w));
      }

      private static double played(double stick) {
        return Math.abs(stick) < 0.06 ? 0 : stick;
      }
    };
  }

  /** Hunts along an edge at an even speed, with a corner now and then. */
  private static Driver edge(Limits limits, RandomGenerator random) {
    double speed = random.nextDouble(0.4, 0.9);
    double swing = random.nextDouble(0.25, 0.8);
    boolean hard = random.nextBoolean();
    Maker hunting =
        r ->
            r.nextInt(9) == 0
                ? new Piece(0.5 * speed, 0.9, r.nextDouble(0.6, 1.6))
                : new Piece(speed, r.nextDouble(0.5, 1) * swing, r.nextDouble(0.25, 0.9));
    Driver pieces = new Pieces(new Limits(1, 1), random, hunting);
    double periodS = random.nextDouble(1.2, 2.4);
    return timeS -> {
      Speeds piece = pieces.next(timeS);
      double phase = StrictMath.sin(2 * Math.PI * timeS / periodS);
      double side = hard ? Math.signum(phase) : phase;
      boolean corner = piece.wRadPerS() > 0.85;
      return limits.of(piece.vMPerS(), corner ? piece.wRadPerS() : piece.wRadPerS() * side);
    };
  }

  /** Swings from side to side at speeds that change now and then. */
  private static Driver slalom(Limits limits, RandomGenerator random) {
    double periodS = random.nextDouble(1.5, 6);
    Maker speeds = r -> new Piece(r.nextDouble(0.3, 1), r.nextDouble(0.3, 1), r.nextDouble(2, 6));
    Driver pieces = new Pieces(new Limits(1, 1), random, speeds);
    return timeS -> {
      Speeds piece = pieces.next(timeS);
      double swing = StrictMath.sin(2 * Math.PI * timeS / periodS);
      return limits.of(piece.vMPerS(), piece.wRadPerS() * swing);
    };
  }

  /** All kinds. */
  static List<Kind> kinds() {
    return List.of(Kind.values());
  }
}
