package simbad.cli;

import java.io.IOException;
import java.io.Serializable;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Deque;
import java.util.List;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentLinkedDeque;
import org.jspecify.annotations.Nullable;
import simbad.experiments.workers.Job;

/**
 * The diagnosis of a withheld check's cases, a piece each. Every thread that does pieces has a
 * {@link Desk}, which the next piece finds again. Thread-safe.
 *
 * <p>Where it was sent to, the desks end with the process that does the pieces.
 */
final class DiagnosisJob implements Job<CaseAnswer>, AutoCloseable {
  private static final long serialVersionUID = 1;

  private final Source program;
  private final ArrayList<OpenCase> cases;
  private final ArrayList<String> withheld;
  private final Duration limit;

  private transient @Nullable Deque<Desk> idle;

  /** Tells, where a piece is done, which program to start there. */
  interface Source extends Serializable {
    JavaProgram program();
  }

  /**
   * The diagnosis of some cases.
   *
   * @param program that does commands as {@link StandingMain} does
   * @param cases the pieces
   * @param withheld effects that it is not told of
   * @param limit after which a case is given up
   */
  DiagnosisJob(
      Source program, Collection<OpenCase> cases, Collection<String> withheld, Duration limit) {
    this.program = program;
    this.cases = new ArrayList<>(cases);
    this.withheld = new ArrayList<>(withheld);
    this.limit = limit;
  }

  /** Not initialized above: what was sent is made without a constructor. */
  private synchronized Deque<Desk> idle() {
    Deque<Desk> now = idle == null ? new ConcurrentLinkedDeque<>() : idle;
    idle = now;
    return now;
  }

  @Override
  public CaseAnswer piece(long number) {
    OpenCase one = cases.get(Math.toIntExact(number));
    try {
      Desk desk = idle().poll();
      return answer(one, desk == null ? Desk.open(program.program()) : desk);
    } catch (IOException e) {
      List<String> complaints = List.of(one.id() + ": " + e);
      return new CaseAnswer(one.id(), new TreeMap<>(), new ArrayList<>(complaints));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException(e);
    }
  }

  private CaseAnswer answer(OpenCase one, Desk desk) throws IOException, InterruptedException {
    boolean whole = false;
    try {
      CaseAnswer answer = desk.answer(one, withheld, limit);
      whole = desk.stands();
      return answer;
    } finally {
      if (whole) {
        idle().add(desk);
      } else {
        desk.close();
      }
    }
  }

  /** Ends the desks of this process. */
  @Override
  public void close() {
    idle().forEach(Desk::close);
  }
}
