package simbad.kernel.render;

import java.util.Arrays;
import simbad.kernel.drawing.Rgb;

/**
 * Fills triangles into a picture, the nearest surface on top. A pixel belongs to the triangle that
 * holds its centre; between triangles that share an edge there is neither gap nor overlap, since
 * corners are rounded to {@value #SUBPIXELS} steps per pixel and the rest is counted in integers.
 */
final class Raster {
  private static final int SUBPIXELS = 256;
  private static final int CHANNELS = 3;

  private final Corner[] corners = {new Corner(), new Corner(), new Corner()};
  private final Plane inverseDepth = new Plane();
  private final Plane[] colours = {new Plane(), new Plane(), new Plane()};
  private float[] inverseDepths = {};
  private int[] argb = {};
  private int width;
  private int height;
  private double focalPx;
  private boolean oneColour;
  private int flatColour;
  private int from;
  private int to;

  /** A triangle's corner: place in subpixels, and 1/depth. */
  private static final class Corner {
    private long x;
    private long y;
    private double inverseDepth;
    private int vertex;
  }

  /** Starts a picture. */
  void begin(Picture picture, double newFocalPx, Rgb background) {
    width = picture.width();
    height = picture.height();
    argb = picture.argb();
    focalPx = newFocalPx;
    if (inverseDepths.length < argb.length) {
      inverseDepths = new float[argb.length];
    }
    Arrays.fill(inverseDepths, 0);
    Arrays.fill(argb, pack(background.red(), background.green(), background.blue()));
  }

  /** Fills a triangle of vertices that are before the eye, if its front is seen. */
  void fill(Vertices vertices, int a, int b, int c) {
    project(corners[0], vertices, a);
    project(corners[1], vertices, c);
    project(corners[2], vertices, b);
    long area = side(corners[0], corners[1], corners[2].x, corners[2].y);
    if (area > 0) {
      fitPlanes(vertices, area);
      fillRows();
    }
  }

  private void project(Corner corner, Vertices vertices, int vertex) {
    double inverse = 1 / vertices.depthM(vertex);
    double scale = focalPx * inverse * SUBPIXELS;
    corner.x = Math.round(width * (SUBPIXELS / 2.0) + vertices.rightM(vertex) * scale);
    corner.y = Math.round(height * (SUBPIXELS / 2.0) - vertices.upM(vertex) * scale);
    corner.inverseDepth = inverse;
    corner.vertex = vertex;
  }

  /** Positive if a point is inside the edge between two corners; twice the area they span. */
  private static long side(Corner a, Corner b, long x, long y) {
    return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
  }

  /** 1/depth, and colour/depth, are linear in the picture. */
  private void fitPlanes(Vertices vertices, long area) {
    Corner a = corners[0];
    Corner b = corners[1];
    Corner c = corners[2];
    inverseDepth.fit(corners, area, a.inverseDepth, b.inverseDepth, c.inverseDepth);
    oneColour = true;
    for (int channel = 0; channel < CHANNELS; channel++) {
      double atA = vertices.colour(a.vertex, channel);
      double atB = vertices.colour(b.vertex, channel);
      double atC = vertices.colour(c.vertex, channel);
      oneColour &= atA == atB && atB == atC;
      colours[channel].fit(
          corners, area, atA * a.inverseDepth, atB * b.inverseDepth, atC * c.inverseDepth);
    }
    flatColour =
        pack(
            vertices.colour(a.vertex, 0),
            vertices.colour(a.vertex, 1),
            vertices.colour(a.vertex, 2));
  }

  private void fillRows() {
    long top = Math.min(corners[0].y, Math.min(corners[1].y, corners[2].y));
    long bottom = Math.max(corners[0].y, Math.max(corners[1].y, corners[2].y));
    int last = (int) Math.min(height - 1, bottom / SUBPIXELS);
    for (int row = (int) Math.max(0, Math.floorDiv(top, SUBPIXELS)); row <= last; row++) {
      from = 0;
      to = width - 1;
      narrow(row, corners[0], corners[1]);
      narrow(row, corners[1], corners[2]);
      narrow(row, corners[2], corners[0]);
      fillRow(row);
    }
  }

  /** Narrows the span to the pixels of a row whose centres are inside an edge. */
  private void narrow(int row, Corner a, Corner b) {
    long half = SUBPIXELS / 2;
    long atFirst = side(a, b, half, (long) row * SUBPIXELS + half);
    boolean keepsItsPixels = b.y < a.y || (b.y == a.y && b.x > a.x);
    long inside = keepsItsPixels ? atFirst : atFirst - 1;
    long step = (a.y - b.y) * SUBPIXELS;
    if (step > 0) {
      from = (int) Math.max(from, Math.min(width, -Math.floorDiv(inside, step)));
    } else if (step < 0) {
      to = (int) Math.min(to, Math.max(-1, Math.floorDiv(inside, -step)));
    } else if (inside < 0) {
      to = -1;
    }
  }

  private void fillRow(int row) {
    for (int column = from; column <= to; column++) {
      int pixel = row * width + column;
      double inverse = inverseDepth.at(column, row);
      if ((float) inverse > inverseDepths[pixel]) {
        inverseDepths[pixel] = (float) inverse;
        argb[pixel] = oneColour ? flatColour : colourAt(column, row, inverse);
      }
    }
  }

  private int colourAt(int column, int row, double inverse) {
    return pack(
        colours[0].at(column, row) / inverse,
        colours[1].at(column, row) / inverse,
        colours[2].at(column, row) / inverse);
  }

  private static int pack(double red, double green, double blue) {
    return 0xff000000 | level(red) << 16 | level(green) << 8 | level(blue);
  }

  private static int level(double share) {
    return (int) (Math.max(0, Math.min(1, share)) * 255 + 0.5);
  }

  /** A quantity that is linear in the picture, known at a triangle's corners. */
  private static final class Plane {
    private double atOrigin;
    private double perColumn;
    private double perRow;

    void fit(Corner[] corners, long area, double atA, double atB, double atC) {
      double abX = corners[1].x - corners[0].x;
      double abY = corners[1].y - corners[0].y;
      double acX = corners[2].x - corners[0].x;
      double acY = corners[2].y - corners[0].y;
      double perX = ((atB - atA) * acY - (atC - atA) * abY) / area;
      double perY = ((atC - atA) * abX - (atB - atA) * acX) / area;
      double half = SUBPIXELS / 2.0;
      atOrigin = atA + (half - corners[0].x) * perX + (half - corners[0].y) * perY;
      perColumn = perX * SUBPIXELS;
      perRow = perY * SUBPIXELS;
    }

    /** Returns the quantity at a pixel's centre. */
    double at(int column, int row) {
      return atOrigin + column * perColumn + row * perRow;
    }
  }
}
