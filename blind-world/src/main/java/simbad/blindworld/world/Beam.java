package simbad.blindworld.world;

/**
 * Where a transducer really listens.
 *
 * @param axisRad its axis beside the heading, counter-clockwise
 * @param halfAngleRad half the opening of the cone
 */
public record Beam(double axisRad, double halfAngleRad) {}
