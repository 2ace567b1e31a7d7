package simbad.sim;

import simbad.scene3d.Figure;

/** Makes what a display scene shows of the objects of a world. */
final class Figures {
  private Figures() {}

  /** Makes the figure of an object and of its parts; needs a display. */
  static Figure of(BaseObject object) {
    Figure figure = new Figure(object.visual());
    object.nodes().forEach(figure::add);
    object.decorate(figure);
    object.children().forEach(child -> figure.add(of(child)));
    return figure;
  }
}
