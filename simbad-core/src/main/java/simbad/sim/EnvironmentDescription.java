package simbad.sim;

import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import javax.vecmath.Color3f;
import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;

/**
 * What a world shall contain and how it shall look. Programs subclass it, set the fields and add
 * objects in the constructor.
 */
public class EnvironmentDescription {
  /** Box normals of one direction per face. */
  public static final int NORMALS_SIMPLE = 1;

  /** Box normals that shade softly. */
  public static final int NORMALS_REALISTIC = 2;

  private static final float USUAL_GREY = 0.8f;

  /** White. */
  public Color3f white = new Color3f(1, 1, 1);

  /** Black. */
  public Color3f black = new Color3f(0, 0, 0);

  /** Red. */
  public Color3f red = new Color3f(1, 0, 0);

  /** Green. */
  public Color3f green = new Color3f(0, 1, 0);

  /** Blue. */
  public Color3f blue = new Color3f(0, 0, 1);

  /** Light gray; the spelling is Simbad's. */
  public Color3f ligthgray = new Color3f(0.8f, 0.8f, 0.8f);

  /** Gray, as light as {@link #ligthgray}. */
  public Color3f gray = new Color3f(0.8f, 0.8f, 0.8f);

  /** Dark gray. */
  public Color3f darkgray = new Color3f(0.2f, 0.2f, 0.2f);

  /** Colour of the light that comes from everywhere. */
  public Color3f ambientLightColor = white;

  /** Whether the first lamp is lit. */
  public boolean light1IsOn = true;

  /** Colour of the first lamp. */
  public Color3f light1Color = white;

  /** Position of the first lamp, metres. */
  public Vector3d light1Position;

  /** Colour of the second lamp. */
  public Color3f light2Color = white;

  /** Whether the second lamp is lit. */
  public boolean light2IsOn;

  /** Position of the second lamp, metres. */
  public Vector3d light2Position;

  /** Colour of walls made from now on. */
  public Color3f wallColor = blue;

  /** Colour of arches made from now on. */
  public Color3f archColor = green;

  /** Colour of boxes made from now on. */
  public Color3f boxColor = red;

  /** Colour of the floor. */
  public Color3f floorColor = ligthgray;

  /** Colour of the background. */
  public Color3f backgroundColor = ligthgray;

  /** Where the window looks from at first, a constant of {@link World}. */
  public int worldViewPoint = World.VIEW_FROM_EAST;

  /** Whether the axes are drawn. */
  public boolean hasAxis = true;

  /** How boxes are shaded. */
  public int normalsStyle = NORMALS_SIMPLE;

  /** Whether bodies shall fall, slide, push each other and bounce. */
  public boolean usePhysics;

  /** Side of the drawn floor, metres. Nothing stops at its edge. */
  public float worldSize = 20;

  /**
   * Habits of the original that this environment wants back; at first those of the system property.
   * To be set before objects are made.
   */
  public Set<Compatibility> compatibility = Compatibility.fromProperty();

  private final Color3f usualFloor = floorColor;
  private final Color3f usualBackground = backgroundColor;
  private final Set<Compatibility> touched = EnumSet.noneOf(Compatibility.class);
  private final Set<Object> arguments = Collections.newSetFromMap(new IdentityHashMap<>());
  private final List<Object> objects = new ArrayList<>();

  /** Creates an empty environment with Simbad's defaults. */
  public EnvironmentDescription() {
    light1Position = new Vector3d(0, worldSize / 4, worldSize);
    light2Position = new Vector3d(worldSize, worldSize / 4, 0);
  }

  /** Adds an object. Static objects and agents count, others are kept and ignored. */
  public void add(Object object) {
    objects.add(object);
  }

  /**
   * Returns the habits on which anything depended so far: what happened would have gone otherwise
   * with the other position of the switch. It grows while the environment is simulated.
   */
  public Set<Compatibility> touched() {
    return touched;
  }

  /** Returns true if a habit is wanted, and notes that something depends on it. */
  boolean meets(Compatibility habit) {
    touched.add(habit);
    return compatibility.contains(habit);
  }

  /** Returns true if an object that was made took the same vector or colour as this one does. */
  boolean isSecondUse(Object argument) {
    return !arguments.add(argument);
  }

  /** Returns true if the program has given the floor a colour. */
  boolean hasOwnFloor() {
    return isOwn(floorColor, usualFloor);
  }

  /** Returns true if the program has given the background a colour. */
  boolean hasOwnBackground() {
    return isOwn(backgroundColor, usualBackground);
  }

  /** Another object, though it may be as grey, or the same one repainted. */
  @SuppressWarnings("ReferenceEquality") // Who assigns a colour has chosen it.
  private static boolean isOwn(Color3f colour, Color3f usual) {
    return colour != usual || !colour.equals(new Color3f(USUAL_GREY, USUAL_GREY, USUAL_GREY));
  }

  /** Returns the static objects and agents, in the order in which they were added. */
  <T extends BaseObject> List<T> list(Class<T> kind) {
    return objects.stream().filter(kind::isInstance).map(kind::cast).toList();
  }

  /** Moves the first lamp, metres. */
  public void light1SetPosition(double x, double y, double z) {
    light1Position = new Vector3d(x, y, z);
  }

  /** Moves the second lamp, metres. */
  public void light2SetPosition(double x, double y, double z) {
    light2Position = new Vector3d(x, y, z);
  }

  /** Switches physics on or off. */
  public void setUsePhysics(boolean newUsePhysics) {
    usePhysics = newUsePhysics;
  }

  /** Shows or hides the axes. */
  public void showAxis(boolean show) {
    hasAxis = show;
  }

  /** Sets the side of the drawn floor in metres; the lamps stay where they are. */
  public void setWorldSize(float newWorldSize) {
    worldSize = newWorldSize;
  }

  /**
   * Adds a box of 1 m side for each '#' of a map. Columns run along x, rows along z, and the middle
   * of the map's first row, which says how wide the map is, is at x = 0.
   *
   * @param map the rows
   */
  public void addMap(String[] map) {
    for (int row = 0; row < map.length; row++) {
      for (int column = 0; column < map[row].length(); column++) {
        if (map[row].charAt(column) == '#') {
          addBlock(column - map[0].length() / 2, row - map.length / 2);
        }
      }
    }
  }

  private void addBlock(int x, int z) {
    add(new Box(new Vector3d(x, 0, z), new Vector3f(1, 1, 1), this));
  }
}
