/**
 * Pictures of a stage as an eye in the world sees it, and the renderer that takes them without a
 * display: perspective, hidden surfaces by a depth buffer, light per vertex. Equal stages and
 * places give equal bytes on every machine.
 *
 * <p>Frame of an eye: it looks along its x axis, y is up in the picture, z to the right.
 *
 * <p>May not know: who looks, and why; Java 3D or any toolkit.
 */
@NullMarked
package simbad.kernel.render;

import org.jspecify.annotations.NullMarked;
