package simbad.sim;

import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import simbad.kernel.drawing.PointLight;
import simbad.kernel.drawing.Stage;
import simbad.kernel.render.PictureSource;
import simbad.kernel.scene.Scene;

/** The static objects and agents of an environment, and the scene in which sensors see them. */
public class World {
  /** The window looks down from above. */
  public static final int VIEW_FROM_TOP = 1;

  /** The window looks from the east. */
  public static final int VIEW_FROM_EAST = 2;

  /** The window follows an agent from behind. */
  public static final int VIEW_BEHIND_AGENT = 3;

  /** The window follows an agent from far above. */
  public static final int VIEW_ABOVE_AGENT = 4;

  /** The window follows an agent from near above. */
  public static final int VIEW_ABOVE_AGENT_NEAR = 5;

  /** The window follows an agent from its side. */
  public static final int VIEW_AGENT_SIDE = 6;

  /** Side of the drawn floor, metres. */
  protected float worldSize;

  private final Set<Compatibility> habits = EnumSet.noneOf(Compatibility.class);
  private final Scene scene = new Scene();
  private final Stage stage;
  private final Optional<PointLight> light1;
  private final Optional<PointLight> light2;
  private final List<StaticObject> standing = new ArrayList<>();
  private long staticRevision;
  private @Nullable PictureSource pictures;

  /** Creates a world with the environment's static objects; the simulator adds the agents. */
  public World(EnvironmentDescription environment) {
    worldSize = environment.worldSize;
    habits.addAll(environment.compatibility);
    stage = Surroundings.stage(environment);
    light1 = Surroundings.light1(environment);
    light2 = Surroundings.light2(environment);
    environment.list(StaticObject.class).forEach(this::enter);
  }

  private void enter(BaseObject object) {
    object.setWorld(this);
    stage.add(object.visual());
    if (object instanceof StaticObject fixed) {
      scene.addFixed(fixed.getSolid());
      standing.add(fixed);
      staticRevision++;
    } else {
      scene.addMoving(object.getSolid());
    }
  }

  /** Puts an object into the world, where sensors see it. */
  public void addObjectToPickableSceneBranch(BaseObject object) {
    enter(object);
  }

  /** Takes an object out of the world: it is neither seen nor touched any more. */
  public void detach(BaseObject object) {
    object.detach();
  }

  /** Puts a detached object back. */
  public void attach(BaseObject object) {
    object.attach();
  }

  /**
   * Returns the static objects of this world in the order in which they were added. Detached ones
   * are included; {@code getSolid().isPresent()} tells.
   *
   * @return an unmodifiable view
   */
  public List<StaticObject> getStaticObjects() {
    return Collections.unmodifiableList(standing);
  }

  /**
   * Returns a number that grows whenever a static object enters the world, moves, or is attached or
   * detached. Who keeps something computed from the static objects compares it.
   */
  public long getStaticRevision() {
    return staticRevision;
  }

  /** Returns true if a habit of the original is wanted here. */
  boolean restores(Compatibility habit) {
    return habits.contains(habit);
  }

  void noteChange(BaseObject object) {
    if (object instanceof StaticObject) {
      staticRevision++;
    }
  }

  /** Returns the bodies that rays and collisions meet; for sensors of one's own. */
  public Scene getScene() {
    return scene;
  }

  /** Returns what there is to see: this world's objects, floor, axes and lamps. */
  public Stage getStage() {
    return stage;
  }

  /** Returns who takes the pictures of this world's cameras. */
  PictureSource pictures() {
    if (pictures == null) {
      pictures = CameraKind.choose(false).open(stage);
    }
    return pictures;
  }

  /** Returns the first lamp, if it was lit when the world was made. */
  public Optional<PointLight> getLight1() {
    return light1;
  }

  /** Returns the second lamp, if it was lit when the world was made. */
  public Optional<PointLight> getLight2() {
    return light2;
  }

  /**
   * Moves the window's view; without a window, nothing.
   *
   * @param viewPoint a VIEW constant
   * @param agent whom to follow, for the views that follow
   */
  public void changeViewPoint(int viewPoint, @Nullable SimpleAgent agent) {
    // Only the window has a view.
  }

  /** Stops drawing; without a window, nothing. */
  public void stopRendering() {
    // Only the window draws.
  }

  /** Goes on drawing; without a window, nothing. */
  public void startRendering() {
    // Only the window draws.
  }

  /** Draws once; without a window, nothing. */
  public void renderOnce() {
    // Only the window draws.
  }

  /** Frees what cameras and the window hold. */
  public void dispose() {
    if (pictures != null) {
      pictures.dispose();
      pictures = null;
    }
  }
}
