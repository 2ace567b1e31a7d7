package simbad.blindworld.motion;

/**
 * One short step of a robot: the speeds that it is told and those that it has. Changes alter the
 * latter one after the other. Speeds in metres and radians per second, left and counter-clockwise
 * positive.
 */
public final class Step {

  private final double totalS;
  private double timeS;
  private double durationS;
  private double elapsedS;
  private double wantedV;
  private double wantedW;
  private double v;
  private double w;
  private double left;
  private double driftX;
  private double driftZ;
  private double lastV;
  private double lastW;
  private double x;
  private double z;
  private double cos;
  private double sin;
  private double wayM;

  Step(double totalS) {
    this.totalS = totalS;
  }

  void begin(double atS, double forS, double sinceLogS, Commands.Speeds wanted) {
    timeS = atS;
    durationS = forS;
    elapsedS = sinceLogS;
    wantedV = wanted.vMPerS();
    wantedW = wanted.wRadPerS();
    v = wantedV;
    w = wantedW;
    left = 0;
    driftX = 0;
    driftZ = 0;
  }

  void place(double xM, double zM, double cosine, double sine) {
    x = xM;
    z = zM;
    cos = cosine;
    sin = sine;
  }

  void end() {
    lastV = v;
    lastW = w;
    wayM += Math.abs(v) * durationS;
  }

  /** When it begins, on the run's clock. */
  public double timeS() {
    return timeS;
  }

  /** How long it is. */
  public double durationS() {
    return durationS;
  }

  /** Which share of the whole log lies before it, in [0, 1]. */
  public double logShare() {
    return elapsedS / totalS;
  }

  /** How long the whole log is. */
  public double logS() {
    return totalS;
  }

  /** The speed that it is told. */
  public double wantedV() {
    return wantedV;
  }

  /** The turn rate that it is told. */
  public double wantedW() {
    return wantedW;
  }

  /** The speed as it is by now. */
  public double v() {
    return v;
  }

  /** The turn rate as it is by now. */
  public double w() {
    return w;
  }

  /** The speed of the step before, after all changes. */
  public double lastV() {
    return lastV;
  }

  /** The turn rate of the step before, after all changes. */
  public double lastW() {
    return lastW;
  }

  /** Where it begins. */
  public double xM() {
    return x;
  }

  /** Where it begins. */
  public double zM() {
    return z;
  }

  /** The heading's direction in x. */
  public double directionX() {
    return cos;
  }

  /** The heading's direction in z; z is down the page. */
  public double directionZ() {
    return -sin;
  }

  /** The way made so far, forth and back. */
  public double wayM() {
    return wayM;
  }

  /** Other speeds. */
  public void set(double vMPerS, double wRadPerS) {
    v = vMPerS;
    w = wRadPerS;
  }

  /** Both speeds by factors. */
  public void scale(double ofV, double ofW) {
    v *= ofV;
    w *= ofW;
  }

  /** Both wheels by factors of their own. */
  public void scaleWheels(double ofLeft, double ofRight, double baseM) {
    double l = (v - w * baseM / 2) * ofLeft;
    double r = (v + w * baseM / 2) * ofRight;
    v = (l + r) / 2;
    w = (r - l) / baseM;
  }

  /** Turns besides. */
  public void addTurn(double radPerS) {
    w += radPerS;
  }

  /** Slides to the left besides. */
  public void slideLeft(double mPerS) {
    left += mPerS;
  }

  /** Is moved over the floor besides, whatever its heading. */
  public void drift(double xPerS, double zPerS) {
    driftX += xPerS;
    driftZ += zPerS;
  }

  double left() {
    return left;
  }

  double driftX() {
    return driftX;
  }

  double driftZ() {
    return driftZ;
  }
}
