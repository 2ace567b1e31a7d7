package simbad.scene3d;

import javax.media.j3d.BranchGroup;
import javax.media.j3d.Node;

/** A node that belongs to an object and goes with it from one scene to the next. */
public final class Attachment {
  private final BranchGroup holder = new BranchGroup();

  /** Takes a node that has no parent. */
  public Attachment(Node node) {
    holder.setCapability(BranchGroup.ALLOW_DETACH);
    holder.addChild(node);
  }

  BranchGroup takenOut() {
    holder.detach();
    return holder;
  }
}
