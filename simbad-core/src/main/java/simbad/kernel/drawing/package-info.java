/**
 * What the world looks like, as plain values: coloured triangles in each object's own frame, the
 * lights, the background. Everything that draws - cameras without a display, cameras with Java 3D,
 * the window - draws a {@link simbad.kernel.drawing.Stage}, so that all of them show the same.
 *
 * <p>Frame and units are those of {@link simbad.kernel.geometry}. Triangles run counter-clockwise
 * as seen from outside; their back is not drawn. Everything is opaque.
 *
 * <p>May not know: who draws and how, sensors, Java 3D or any toolkit.
 */
@NullMarked
package simbad.kernel.drawing;

import org.jspecify.annotations.NullMarked;
