package simbad.kernel.drawing;

import java.util.List;

/**
 * The light in a world. A lit surface of colour C shows, per vertex and per share of red, green and
 * blue,
 *
 * <pre>
 * min(1, C ({@value #AMBIENT_REFLECTANCE} A + sum over the lamps of L max(0, n.d) / {@value #ATTENUATION}))
 * </pre>
 *
 * <p>with A the ambient light, L a lamp's colour, n the vertex' normal and d the direction to the
 * lamp; between vertices it is interpolated. This is the fixed pipeline of OpenGL 1.x, which Java
 * 3D uses, with a material of ambient reflectance {@value #AMBIENT_REFLECTANCE} C, diffuse
 * reflectance C, no specular reflectance, and lamps of constant attenuation {@value #ATTENUATION}.
 * Nothing casts a shadow.
 *
 * @param ambient light from everywhere
 * @param lamps the lamps that are on; copied
 */
public record Lighting(Rgb ambient, List<PointLight> lamps) {
  /** What light is divided by at any distance: lamps shine twice as bright as their colour. */
  public static final double ATTENUATION = 0.5;

  /**
   * Share of the ambient light that a surface reflects, besides its colour. Chosen so that a light
   * sensor before the shaded side of a green robot reads 0.04, the least that the original read.
   */
  public static final double AMBIENT_REFLECTANCE = 0.08;

  /** Copies the lamps. */
  public Lighting {
    lamps = List.copyOf(lamps);
  }
}
