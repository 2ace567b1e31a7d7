package simbad.kernel.drawing;

import java.util.List;

/**
 * The light in a world. A lit surface of colour C shows, per vertex and per share of red, green and
 * blue,
 *
 * <pre>
 * min(1, R A + C sum over the lamps of L max(0, n.d) / {@value #ATTENUATION})
 * </pre>
 *
 * <p>with R the surface's ambient reflectance, A the ambient light, L a lamp's colour, n the
 * vertex' normal and d the direction to the lamp; between vertices it is interpolated. This is the
 * fixed pipeline of OpenGL 1.x, which Java 3D uses, with a material of ambient reflectance R,
 * diffuse reflectance C, no specular reflectance, and lamps of constant attenuation {@value
 * #ATTENUATION}. Nothing casts a shadow.
 *
 * @param ambient light from everywhere
 * @param lamps the lamps that are on; copied
 */
public record Lighting(Rgb ambient, List<PointLight> lamps) {
  /** What light is divided by at any distance: lamps shine twice as bright as their colour. */
  public static final double ATTENUATION = 0.5;

  /** Copies the lamps. */
  public Lighting {
    lamps = List.copyOf(lamps);
  }
}
