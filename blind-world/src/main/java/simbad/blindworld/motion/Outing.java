package simbad.blindworld.motion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import simbad.blindworld.check.Checks;
import simbad.blindworld.world.Pose;

/** A log to be made: what is told in each run, and when the tracker looks. */
public record Outing(List<Run> runs) {

  /** Windows begin at multiples of this. */
  static final double BEAT_S = 0.5;

  /** How far a frame may be from the moment that it stands for. */
  static final double NEAR_S = 0.02 + 1e-9;

  /** Copies the list. */
  public Outing {
    runs = List.copyOf(runs);
  }

  /** One run, in which clock and robot begin anew. */
  public static final class Run {
    private final String name;
    private final Commands commands;
    private final double[] framesS;
    private final double endS;
    private final Pose start;

    /**
     * A run.
     *
     * @param name of it
     * @param commands told
     * @param framesS when the tracker sees it, rising; copied
     * @param endS when it ends
     * @param start where it begins, at rest
     */
    public Run(String name, Commands commands, double[] framesS, double endS, Pose start) {
      this.name = name;
      this.commands = commands;
      this.framesS = Checks.numbers("frames", framesS).clone();
      this.endS = Checks.finite("end", endS);
      this.start = start;
    }

    /** Its name. */
    public String name() {
      return name;
    }

    /** What is told in it. */
    public Commands commands() {
      return commands;
    }

    /** When it ends. */
    public double endS() {
      return endS;
    }

    /** Where it begins, at rest. */
    public Pose start() {
      return start;
    }

    /** How often the tracker sees it. */
    public int frames() {
      return framesS.length;
    }

    /** When the tracker sees it. */
    public double frameS(int index) {
      return framesS[index];
    }

    /** When its clock begins: with the first command or the first frame. */
    double beginS() {
      double command = commands.size() == 0 ? Double.POSITIVE_INFINITY : commands.timeS(0);
      return Math.min(command, framesS.length == 0 ? 0 : framesS[0]);
    }
  }

  /** How long all runs are together. */
  public double durationS() {
    return runs.stream().mapToDouble(run -> run.endS() - run.beginS()).sum();
  }

  /** The same with only those frames at which a window may begin or end. */
  public Outing atBeats() {
    List<Run> thin = new ArrayList<>();
    for (Run run : runs) {
      double[] near =
          Arrays.stream(run.framesS).filter(t -> Math.abs(t - beat(t)) <= NEAR_S).toArray();
      thin.add(new Run(run.name, run.commands, near, run.endS, run.start));
    }
    return new Outing(thin);
  }

  private static double beat(double timeS) {
    return Math.rint(timeS / BEAT_S) * BEAT_S;
  }
}
