package simbad.scene3d;

/**
 * Held while a universe of Java 3D or a canvas is made, and while one is closed. With its last
 * universe Java 3D ends its threads; what is asked of them in that moment, as every new canvas
 * does, is never answered, and who asked waits for ever.
 */
final class UniverseLock {
  /** The one lock. */
  static final Object LOCK = new Object();

  private UniverseLock() {}
}
