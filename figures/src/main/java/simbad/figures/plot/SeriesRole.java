package simbad.figures.plot;

/**
 * What a curve stands for. The role alone fixes colour, width and dash, so that a sensor looks the
 * same in every picture, in colour, to colour-blind eyes and in grey.
 */
public enum SeriesRole {
  /** How far a threshold table is uncertain. */
  BAND,
  /** A threshold table. */
  TABLE,
  /** The sensor that hears every obstacle whatever its orientation. */
  ORIGINAL,
  /** The sensor that must stand inside the shadow. */
  SHADOW,
  /** The sensor whose cone has to overlap the shadow. */
  OVERLAP,
  /** Simbad's thin rays. */
  RAY,
  /** The noisy sensor. */
  NOISY,
  /** The sensor whose echoes have strength. */
  LEVEL,
  /** Anything else. */
  OTHER
}
