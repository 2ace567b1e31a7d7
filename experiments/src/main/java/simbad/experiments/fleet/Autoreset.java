package simbad.experiments.fleet;

/** When a robot whose episode has ended begins the next one; the names are Gymnasium's. */
public enum Autoreset {
  /** In the next step, whose command is not looked at. */
  NEXT_STEP,
  /** In the same step; what was read last goes into the buffer of last readings. */
  SAME_STEP,
  /** When it is asked to. Until then it stands still. */
  DISABLED
}
