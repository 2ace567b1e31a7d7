package simbad.scene3d;

import simbad.kernel.drawing.Rgb;

/**
 * What lies under and behind a world, and what of it the program has chosen itself: that stays as
 * it is in a dark window.
 *
 * @param background what is seen where nothing is
 * @param ownBackground whether the program has chosen it
 * @param floor colour of the floor
 * @param ownFloor whether the program has chosen it
 */
public record Backdrop(Rgb background, boolean ownBackground, Rgb floor, boolean ownFloor) {
  Rgb background(Look look) {
    return ownBackground || !look.dark() ? background : Palette.DARK.background();
  }

  Rgb floor(Look look) {
    return ownFloor || !look.dark() ? floor : Palette.DARK.floor();
  }

  /** Returns the look for what stands on the floor: what the floor is like decides. */
  Look onFloor(Look look) {
    return look.withDark(Palette.isDark(floor(look)));
  }
}
