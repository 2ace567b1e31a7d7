package simbad.figures.plot;

/**
 * What stands over a picture. The provenance cannot be left out: a picture of a reconstructed table
 * must never pass for a measured one.
 *
 * @param title what the picture shows; not blank
 * @param provenance where its data come from, as "table: reconstructed"; not blank
 */
public record Caption(String title, String provenance) {
  /** Checks that both lines say something. */
  public Caption {
    Labels.notBlank("title", title);
    Labels.notBlank("provenance", provenance);
  }
}
