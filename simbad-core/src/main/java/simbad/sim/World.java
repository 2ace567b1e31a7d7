package simbad.sim;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumSet;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.function.Consumer;
import javax.media.j3d.Canvas3D;
import javax.media.j3d.Light;
import javax.media.j3d.PointLight;
import javax.vecmath.Point3d;
import org.jspecify.annotations.Nullable;
import simbad.kernel.drawing.Stage;
import simbad.kernel.geometry.Placement;
import simbad.kernel.render.Picture;
import simbad.kernel.scene.BodyScene;
import simbad.scene3d.Backdrop;
import simbad.scene3d.DisplayException;
import simbad.scene3d.Look;
import simbad.scene3d.Sign;

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

  /** The window follows an agent from outside and looks over it to the middle of the world. */
  public static final int VIEW_INWARDS = 7;

  /** Side of the drawn floor, metres. */
  protected float worldSize;

  private final Set<Compatibility> habits = EnumSet.noneOf(Compatibility.class);
  private final Set<Compatibility> touched;
  private final BodyScene scene = new BodyScene();
  private final Stage stage;
  private final Backdrop backdrop;
  private final WorldCameras cameras;
  private final List<PointLight> lights;
  private final List<StaticObject> standing = new ArrayList<>();
  private final List<BaseObject> objects = new ArrayList<>();
  private final Lock stepLock = new Lock();
  private long staticRevision;
  private final int surroundings;
  private final boolean hasAxes;
  private volatile int viewPoint;
  private @Nullable SimpleAgent viewedAgent;
  private volatile @Nullable WorldView view;
  private @Nullable DisplayException noView;
  private volatile Look look = Look.LIGHT;

  /** Creates a world with the environment's static objects; the simulator adds the agents. */
  public World(EnvironmentDescription environment) {
    worldSize = environment.worldSize;
    hasAxes = environment.hasAxis;
    viewPoint = environment.worldViewPoint;
    habits.addAll(environment.compatibility);
    touched = environment.touched();
    stage = Surroundings.stage(environment);
    backdrop = Surroundings.backdrop(environment);
    cameras = new WorldCameras(stage);
    lights =
        List.of(
            Surroundings.light(
                environment.light1Position, environment.light1Color, environment.light1IsOn),
            Surroundings.light(
                environment.light2Position, environment.light2Color, environment.light2IsOn));
    surroundings = stage.visuals().size();
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
    show(object);
  }

  private synchronized void show(BaseObject object) {
    objects.add(object);
    if (view != null) {
      view.add(object);
    }
  }

  /** Returns the lock that is held during a step. */
  Lock stepLock() {
    return stepLock;
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

  /** Returns true if a habit is wanted here, and notes that something depends on it. */
  boolean meets(Compatibility habit) {
    touched.add(habit);
    return habits.contains(habit);
  }

  /** Returns the habits on which anything depended so far; see {@link EnvironmentDescription}. */
  public Set<Compatibility> touched() {
    return Collections.unmodifiableSet(touched);
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

  /** Returns the side of the drawn floor, metres. */
  public float getWorldSize() {
    return worldSize;
  }

  /** Returns the bodies that rays and collisions meet; for sensors of one's own. */
  public BodyScene getScene() {
    return scene;
  }

  /** Returns what there is to see: this world's objects, floor, axes and lamps. */
  public Stage getStage() {
    return stage;
  }

  /** Takes a picture of this world as it is now; see {@link CameraKind} by whom. */
  void takePicture(Placement worldFromEye, Picture picture) {
    cameras.take(view != null, worldFromEye, picture);
  }

  /**
   * Returns the first lamp. Switching it off or on with {@code setEnable} counts for {@link
   * LightSensor#getLux()}, not for pictures.
   */
  public Light getLight1() {
    return lights.get(0);
  }

  /** Returns the second lamp; see {@link #getLight1()}. */
  public Light getLight2() {
    return lights.get(1);
  }

  /** See {@link LightSensor#getLux()}. */
  double lux(Point3d at) {
    return Surroundings.lux(lights, at);
  }

  /**
   * Returns the canvas that shows this world, the same one every time. It belongs into one window.
   *
   * @throws simbad.scene3d.DisplayException if there is no display or Java 3D cannot draw on it
   */
  public synchronized Canvas3D getCanvas3D() {
    if (noView != null) {
      throw noView;
    }
    if (view == null) {
      view = openView();
    }
    return view.canvas();
  }

  private WorldView openView() {
    try {
      WorldView opened = new WorldView(stage, worldSize, backdrop, stepLock);
      stage.visuals().subList(1, surroundings).forEach(opened::add);
      objects.forEach(opened::add);
      opened.show(look);
      opened.look(viewPoint, viewedAgent);
      return opened;
    } catch (DisplayException e) {
      // What is missing will not come: whoever asks again gets the same answer, without the wait.
      noView = e;
      throw e;
    }
  }

  /**
   * Moves the view of this world; before there is a canvas, the view that it will have first.
   *
   * @param newViewPoint a VIEW constant
   * @param agent whom to follow, for the views that follow
   */
  public synchronized void changeViewPoint(int newViewPoint, @Nullable SimpleAgent agent) {
    viewPoint = newViewPoint;
    viewedAgent = agent;
    ifShown(shown -> shown.look(newViewPoint, agent));
  }

  /** Returns from where the world is viewed, a VIEW constant. */
  public int getViewPoint() {
    return viewPoint;
  }

  /** Says how the canvas shows this world; before there is one, how it will. */
  public synchronized void setLook(Look newLook) {
    look = newLook;
    ifShown(shown -> shown.show(newLook));
  }

  /** Returns how the canvas shows this world. */
  public Look getLook() {
    return look;
  }

  /** Returns what a legend of the canvas explains; without a canvas, nothing. */
  public synchronized Set<Sign> signs() {
    if (view == null) {
      return Set.of();
    }
    Set<Sign> signs = view.signs();
    if (hasAxes && !signs.isEmpty()) {
      signs.add(Sign.AXES);
    }
    return signs;
  }

  /**
   * Takes a picture of what the canvas shows, whatever lies before it. It waits for a frame to be
   * drawn.
   *
   * @throws simbad.scene3d.DisplayException if there is no canvas, or it is hidden
   */
  public BufferedImage photograph() {
    return shownView().photograph();
  }

  private synchronized WorldView shownView() {
    getCanvas3D();
    return Objects.requireNonNull(view);
  }

  /** Stops drawing; without a canvas, nothing. */
  public void stopRendering() {
    ifShown(WorldView::stop);
  }

  /** Goes on drawing; without a canvas, nothing. */
  public void startRendering() {
    ifShown(WorldView::start);
  }

  /** Draws once while drawing is stopped; without a canvas, nothing. */
  public void renderOnce() {
    ifShown(WorldView::drawOnce);
  }

  /** Says who is told, on any thread, why the canvas cannot be drawn any more. */
  public void whenDrawingFails(Consumer<String> listener) {
    ifShown(shown -> shown.whenFailed(listener));
  }

  private synchronized void ifShown(Consumer<WorldView> action) {
    if (view != null) {
      action.accept(view);
    }
  }

  /** Frees what cameras and the canvas hold. */
  public synchronized void dispose() {
    ifShown(WorldView::dispose);
    view = null;
    cameras.dispose();
  }
}
