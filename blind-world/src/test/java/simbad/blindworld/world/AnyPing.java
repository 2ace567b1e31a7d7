package simbad.blindworld.world;

import java.util.List;
import java.util.SplittableRandom;

/** A ping for changes that do not look at it. */
public final class AnyPing {

  /** The first of an empty recording. */
  public static final Ping FIRST = new Ping(new Recording(List.of()), new SplittableRandom(1), 1);

  private AnyPing() {}
}
