package simbad.scene3d;

import javax.media.j3d.Node;
import javax.media.j3d.Switch;

/** Shows nodes or hides them. */
final class Curtain {
  private final Switch nodes = new Switch(Switch.CHILD_ALL);
  private boolean open = true;

  Curtain(Node node) {
    nodes.setCapability(Switch.ALLOW_SWITCH_WRITE);
    nodes.addChild(node);
  }

  Node node() {
    return nodes;
  }

  void set(boolean wanted) {
    if (open != wanted) {
      open = wanted;
      nodes.setWhichChild(open ? Switch.CHILD_ALL : Switch.CHILD_NONE);
    }
  }
}
