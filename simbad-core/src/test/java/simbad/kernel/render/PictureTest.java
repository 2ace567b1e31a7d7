package simbad.kernel.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;

/** A picture as a buffer, and its means. */
class PictureTest {
  @Test
  void picture_isBlackAtFirst_andAfterClear() {
    Picture picture = new Picture(3, 2);
    assertEquals(0xff000000, picture.argb()[5]);
    picture.argb()[5] = 0xff123456;
    assertEquals(0x123456, picture.rgb(2, 1));
    picture.clear();
    assertEquals(0, picture.rgb(2, 1));
    assertEquals(0, picture.luminance());
  }

  @Test
  void means_weighTheColoursAsTheyShould() {
    Picture picture = new Picture(2, 1);
    picture.argb()[0] = 0xffff0000;
    assertEquals(1 / 3f, picture.gray(0, 0), 1e-6);
    assertEquals(0.299f / 2, picture.luminance(), 1e-6);
    picture.argb()[1] = 0xff00ff00;
    assertEquals((0.299f + 0.587f) / 2, picture.luminance(), 1e-6);
    picture.argb()[0] = 0xff0000ff;
    picture.argb()[1] = 0xffffffff;
    assertEquals((0.114f + 1) / 2, picture.luminance(), 1e-6);
    assertEquals(1f, picture.gray(1, 0), 1e-6);
  }

  @Test
  void size_belowOne_isRefused() {
    assertEquals(
        "size = 0 x 5 is not at least 1",
        assertThrows(IllegalArgumentException.class, () -> new Picture(0, 5)).getMessage());
    assertThrows(IllegalArgumentException.class, () -> new Picture(5, 0));
  }

  @Test
  void copy_isTheSamePictureOfItsOwn_ofItsSizeOnly() {
    Picture original = new Picture(2, 1);
    original.argb()[1] = 0xff123456;
    Picture copy = new Picture(2, 1);
    copy.copyFrom(original);
    original.clear();
    assertEquals(0x123456, copy.rgb(1, 0));
    assertEquals(
        "size = 1 x 2 is not 2 x 1",
        assertThrows(IllegalArgumentException.class, () -> copy.copyFrom(new Picture(1, 2)))
            .getMessage());
  }
}
