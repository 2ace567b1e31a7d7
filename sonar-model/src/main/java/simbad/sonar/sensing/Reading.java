package simbad.sonar.sensing;

/** What a transducer reports of one ping: an {@link Echo} with its range, or {@link NoEcho}. */
public sealed interface Reading permits Echo, NoEcho {}
