package simbad.experiments.run;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import simbad.sonar.sensing.ReadingRow;

/**
 * Where a robot's sensor was after each step, in the obstacle's own frame. Grows while the robot
 * drives, then is only read.
 */
public final class Trace {
  private static final int FIRST_CAPACITY = 1 << 16;

  private final double stepS;
  private double[] xM = new double[FIRST_CAPACITY];
  private double[] zM = new double[FIRST_CAPACITY];
  private double[] headingRad = new double[FIRST_CAPACITY];
  private boolean[] heard = new boolean[FIRST_CAPACITY];
  private final List<ReadingRow> readings = new ArrayList<>();
  private int size;
  private int firstOnEdge = Integer.MAX_VALUE;
  private boolean closed;

  Trace(double stepS) {
    this.stepS = stepS;
  }

  void add(double newXM, double newZM, double newHeadingRad, boolean newHeard) {
    if (size == xM.length) {
      xM = Arrays.copyOf(xM, 2 * size);
      zM = Arrays.copyOf(zM, 2 * size);
      headingRad = Arrays.copyOf(headingRad, 2 * size);
      heard = Arrays.copyOf(heard, 2 * size);
    }
    xM[size] = newXM;
    zM[size] = newZM;
    headingRad[size] = newHeadingRad;
    heard[size] = newHeard;
    size++;
  }

  void read(ReadingRow row) {
    readings.add(row);
  }

  void edgeFound() {
    firstOnEdge = size - 1;
  }

  void close() {
    closed = true;
  }

  /** Returns what the belt read, in the order of time; nothing where that was not kept. */
  public List<ReadingRow> readings() {
    return Collections.unmodifiableList(readings);
  }

  /** Returns the number of places; place 0 is after the first step. */
  public int size() {
    return size;
  }

  /** Returns the first place at which the robot has found the edge; size() if it never has. */
  public int firstOnEdge() {
    return Math.min(firstOnEdge, size);
  }

  /** Tells whether the robot has gone once round the obstacle since it found the edge. */
  public boolean isClosed() {
    return closed;
  }

  /** Returns the length of the way from the first place to the last in metres. */
  public double wayM() {
    double wayM = 0;
    for (int i = 1; i < size; i++) {
      wayM += Math.hypot(xM[i] - xM[i - 1], zM[i] - zM[i - 1]);
    }
    return wayM;
  }

  /** Returns the simulated time after a place's step in seconds. */
  public double timeS(int place) {
    return (place + 1) * stepS;
  }

  /** Returns a place's x in metres. */
  public double xM(int place) {
    return xM[place];
  }

  /** Returns a place's z in metres. */
  public double zM(int place) {
    return zM[place];
  }

  /** Returns the heading at a place in radians. */
  public double headingRad(int place) {
    return headingRad[place];
  }

  /** Tells whether the belt heard anything in the step that led to a place. */
  public boolean heard(int place) {
    return heard[place];
  }
}
