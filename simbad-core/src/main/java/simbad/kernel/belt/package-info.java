/**
 * Mathematics of a belt of range sensors: where its rays start and point, means over sectors, and
 * the sensor that casts one thin ray per transducer through a scene.
 *
 * <p>May not know: who carries the belt, when it is updated, Java 3D or any toolkit.
 */
@NullMarked
package simbad.kernel.belt;

import org.jspecify.annotations.NullMarked;
