package simbad.blindworld.generate;

import simbad.blindworld.world.Recording;
import simbad.blindworld.world.Repeats;

/** A case as it was drawn, whose world can be read again elsewhere. */
interface DrawnWorld {

  /** What is written of it. */
  CaseFiles.Content content();

  /** The same world, effects and all, before other rows; what has a memory begins anew there. */
  Repeats at(Recording rows);
}
