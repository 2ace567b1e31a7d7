package simbad.cli;

/** The project cannot be published as it is; the message says what is missing. */
final class UnpublishableException extends Exception {
  private static final long serialVersionUID = 1;

  UnpublishableException(String message) {
    super(message);
  }
}
