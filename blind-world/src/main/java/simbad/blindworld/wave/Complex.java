package simbad.blindworld.wave;

/** A complex number. */
record Complex(double re, double im) {

  static Complex polar(double size, double angleRad) {
    return new Complex(size * StrictMath.cos(angleRad), size * StrictMath.sin(angleRad));
  }

  Complex plus(Complex other) {
    return new Complex(re + other.re, im + other.im);
  }

  Complex minus(Complex other) {
    return new Complex(re - other.re, im - other.im);
  }

  Complex times(Complex other) {
    return new Complex(re * other.re - im * other.im, re * other.im + im * other.re);
  }

  Complex times(double factor) {
    return new Complex(re * factor, im * factor);
  }

  Complex over(Complex other) {
    double square = other.re * other.re + other.im * other.im;
    return new Complex(
        (re * other.re + im * other.im) / square, (im * other.re - re * other.im) / square);
  }

  /** e to the power of this number. */
  Complex exp() {
    return polar(StrictMath.exp(re), im);
  }

  double size() {
    return StrictMath.hypot(re, im);
  }
}
