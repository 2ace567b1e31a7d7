/**
 * The world as Java 3D draws it: a scene that copies what objects look like and where they are, a
 * canvas that shows it, and where the eye is.
 *
 * <p>Java 3D only shows; nothing here is asked by a step or a sensor. The classes that hold nodes
 * need a display, {@link simbad.scene3d.Viewpoint} and {@link simbad.scene3d.Lookout} do not.
 *
 * <p>May not know: what a step does, Simbad's public names.
 */
@NullMarked
package simbad.scene3d;

import org.jspecify.annotations.NullMarked;
