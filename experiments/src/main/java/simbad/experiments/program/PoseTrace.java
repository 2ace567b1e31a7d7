package simbad.experiments.program;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import javax.vecmath.Point3d;
import simbad.sim.SimpleAgent;

/** Where all agents were after each step. */
public final class PoseTrace {
  private static final double SAME = 1e-6;

  /**
   * An agent after a step; step 0 is before the first.
   *
   * @param world number of the world, from 1, in the order in which the program made them
   * @param headingRad 0 along +x, pi/2 along -z
   */
  record Row(
      int world,
      long step,
      String agent,
      double xM,
      double yM,
      double zM,
      double headingRad,
      boolean collision) {
    double differenceTo(Row other) {
      double turn = Math.abs(Math.IEEEremainder(headingRad - other.headingRad, 2 * Math.PI));
      double way = Math.max(Math.abs(xM - other.xM), Math.abs(zM - other.zM));
      return Math.max(turn, Math.max(way, Math.abs(yM - other.yM)));
    }
  }

  private final List<Row> rows = new ArrayList<>();

  PoseTrace() {}

  void add(int world, long step, SimpleAgent agent) {
    Point3d at = new Point3d();
    agent.getCoords(at);
    rows.add(
        new Row(
            world,
            step,
            agent.getName(),
            at.x,
            at.y,
            at.z,
            agent.getHeadingRad(),
            agent.collisionDetected()));
  }

  /** Returns the rows, in the order of the steps. */
  List<Row> rows() {
    return rows;
  }

  /** Returns the trace as a table. */
  public String csv() {
    StringBuilder text = new StringBuilder("world,step,agent,x_m,y_m,z_m,heading_rad,collision\n");
    for (Row row : rows) {
      String agent = row.agent.replaceAll("[,\"\\r\\n]", " ");
      text.append(
          String.format(
              Locale.ROOT,
              "%d,%d,%s,%.9f,%.9f,%.9f,%.9f,%d%n",
              row.world,
              row.step,
              agent,
              row.xM,
              row.yM,
              row.zM,
              row.headingRad,
              row.collision ? 1 : 0));
    }
    return text.toString().replace("\r\n", "\n");
  }

  /** Says at which step two traces part, how far they come apart, and how far they end. */
  public String comparedTo(PoseTrace other) {
    int common = Math.min(rows.size(), other.rows.size());
    String parting = "";
    double widest = 0;
    Row widestAt = null;
    double last = 0;
    long lastStep = -1;
    for (int i = 0; i < common; i++) {
      Row one = rows.get(i);
      Row two = other.rows.get(i);
      if (one.step != two.step || !one.agent.equals(two.agent)) {
        return "they part at step " + one.step + ": other agents step there";
      }
      double difference = one.differenceTo(two);
      if (parting.isEmpty() && difference > SAME) {
        parting = parting(one, difference);
      }
      if (difference > widest) {
        widest = difference;
        widestAt = one;
      }
      last = one.step == lastStep ? Math.max(last, difference) : difference;
      lastStep = one.step;
    }
    if (widestAt == null || parting.isEmpty()) {
      boolean even = rows.size() == other.rows.size();
      return even ? "all poses agree to 1e-6" : "one ends after step " + lastStep;
    }
    String end = last > SAME ? String.format(Locale.ROOT, "by %.3g", last) : "not at all";
    return String.format(
        Locale.ROOT,
        "%s, furthest at step %d: %s by %.3g, after step %d %s (m or rad)",
        parting,
        widestAt.step,
        widestAt.agent,
        widest,
        lastStep,
        end);
  }

  private static String parting(Row row, double difference) {
    return String.format(
        Locale.ROOT, "they part at step %d: %s by %.3g", row.step, row.agent, difference);
  }
}
