package simbad.gap.fit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.DoubleStream;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Modes;
import simbad.sonar.frame.Angles;

/** Looks for a flat face that strange echoes agree on, by a vote of all over normals and places. */
final class FaceSearch {
  private static final double NORMAL_STEP_DEG = 5;
  private static final double FINE_STEP_DEG = 1;
  private static final double WINDOW_M = 0.05;
  private static final double SPARE_RAD = Math.toRadians(6);
  private static final int BEST = 3;
  private static final double WIDE_M = 8;
  private static final double[] SQUARE_DEG = {8, 12, 16, 20, 25, 32, 45};

  private final LogClues clues;
  private final int[] strange;

  FaceSearch(LogClues clues) {
    this.clues = clues;
    strange = clues.strangeEchoes().toArray();
  }

  private record Face(
      double xM, double zM, double normalDeg, double halfWidthM, double reachM, int votes) {}

  List<double[]> starts(Form form) {
    List<Face> faces = new ArrayList<>();
    for (double normal = -180; normal < 180; normal += NORMAL_STEP_DEG) {
      vote(normal, faces);
    }
    List<double[]> starts = new ArrayList<>();
    for (Face face : best(faces)) {
      starts.addAll(values(form, refined(face)));
    }
    return starts.isEmpty() ? values(form, new Face(0, 0, 0, 0.3, 1, 0)) : starts;
  }

  private static List<Face> best(List<Face> faces) {
    return faces.stream().sorted(Comparator.comparingInt(face -> -face.votes)).limit(BEST).toList();
  }

  /** A wide face is found by a narrow step of its normal only. */
  private Face refined(Face rough) {
    List<Face> near = new ArrayList<>(List.of(rough));
    for (double turn = FINE_STEP_DEG; turn < NORMAL_STEP_DEG; turn += FINE_STEP_DEG) {
      vote(rough.normalDeg - turn, near);
      vote(rough.normalDeg + turn, near);
    }
    return best(near).get(0);
  }

  /** A face may end where the log never looked: as wide as was seen, and as wide as a room. */
  private static List<double[]> values(Form form, Face face) {
    List<double[]> starts = new ArrayList<>();
    for (double width : new double[] {face.halfWidthM, WIDE_M}) {
      double[] mirror = {face.xM, face.zM, face.normalDeg, width, 0.95};
      if (form.parameters().size() == mirror.length) {
        starts.add(mirror);
      } else {
        for (double square : SQUARE_DEG) {
          starts.add(
              new double[] {
                face.xM, face.zM, face.normalDeg, width, 0.95, square, face.reachM + WINDOW_M
              });
        }
      }
    }
    return starts;
  }

  /** Strange echoes that face a normal name the place of the face on it; the fullest place wins. */
  private void vote(double normalDeg, List<Face> faces) {
    double normalX = Math.cos(Math.toRadians(normalDeg));
    double normalZ = -Math.sin(Math.toRadians(normalDeg));
    double cone = clues.geometry.coneHalfAngleRad() + SPARE_RAD;
    int[] facing = Arrays.stream(strange).filter(i -> Math.abs(off(i, normalDeg)) < cone).toArray();
    DoubleStream places = Arrays.stream(facing).mapToDouble(i -> place(i, normalX, normalZ));
    for (double at : Modes.of(places, WINDOW_M, 1)) {
      double[] along =
          Arrays.stream(facing)
              .filter(i -> Math.abs(place(i, normalX, normalZ) - at) < WINDOW_M)
              .mapToDouble(i -> clues.geometry.zM(i) * normalX - clues.geometry.xM(i) * normalZ)
              .sorted()
              .toArray();
      double low = Modes.quantile(along, 0.02);
      double high = Modes.quantile(along, 0.98);
      double middle = (low + high) / 2;
      faces.add(
          new Face(
              at * normalX - middle * normalZ,
              at * normalZ + middle * normalX,
              normalDeg,
              Math.max(0.05, (high - low) / 2),
              farthest(facing, normalX, normalZ, at),
              along.length));
    }
  }

  private double farthest(int[] facing, double normalX, double normalZ, double at) {
    double[] ranges =
        Arrays.stream(facing)
            .filter(i -> Math.abs(place(i, normalX, normalZ) - at) < WINDOW_M)
            .mapToDouble(clues.log::rangeM)
            .sorted()
            .toArray();
    return Modes.quantile(ranges, 0.98);
  }

  private double off(int ping, double normalDeg) {
    return Angles.signed(clues.geometry.headingRad(ping) - Math.toRadians(normalDeg) + Math.PI);
  }

  private double place(int ping, double normalX, double normalZ) {
    return clues.geometry.xM(ping) * normalX
        + clues.geometry.zM(ping) * normalZ
        - clues.log.rangeM(ping);
  }
}
