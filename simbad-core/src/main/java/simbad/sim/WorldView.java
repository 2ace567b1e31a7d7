package simbad.sim;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import javax.media.j3d.Canvas3D;
import org.jspecify.annotations.Nullable;
import simbad.kernel.drawing.Stage;
import simbad.kernel.drawing.Visual;
import simbad.scene3d.Backdrop;
import simbad.scene3d.DisplayScene;
import simbad.scene3d.Figure;
import simbad.scene3d.Look;
import simbad.scene3d.Lookout;
import simbad.scene3d.NameTag;
import simbad.scene3d.Sign;
import simbad.scene3d.StepHold;
import simbad.scene3d.Trail;

/** Shows a world in a canvas. */
final class WorldView {
  private static final long PATIENCE_MS = 200;
  private static final double ANY_SIZE_M = 0.5;

  /** Points of a trail that would lie from one side of the world to the other. */
  private static final double SPACINGS_IN_WORLD = 300;

  private final DisplayScene scene;
  private final double sideM;
  private final IdentityHashMap<BaseObject, Figure> figures = new IdentityHashMap<>();
  private final List<Agent> robots = new ArrayList<>();

  /**
   * Opens a view of a world without objects.
   *
   * @throws simbad.scene3d.DisplayException if there can be none here
   */
  WorldView(Stage stage, double sideM, Backdrop backdrop, Lock stepLock) {
    this.sideM = sideM;
    scene = new DisplayScene(stage, sideM, backdrop, holdBy(stepLock));
    // It listens to the canvas, which keeps it.
    new MouseOrbiter(scene.canvas(), scene.eye(), scene.viewpoint()).listen();
  }

  private static StepHold holdBy(Lock lock) {
    return new StepHold() {
      @Override
      public boolean take() {
        return lock.lockWithin(PATIENCE_MS);
      }

      @Override
      public void release() {
        lock.unlock();
      }
    };
  }

  Canvas3D canvas() {
    return scene.canvas();
  }

  /** Adds what belongs to no object: the axes, the lamps. The floor is the scene's own. */
  void add(Visual surroundings) {
    scene.add(Figure.whole(surroundings));
  }

  synchronized void add(BaseObject object) {
    Figure figure = figure(object);
    figures.put(object, figure);
    scene.add(figure);
    if (object instanceof SimpleAgent agent) {
      addTrail(figure, agent);
    }
    if (object instanceof Agent robot) {
      robots.add(robot);
      addName(figure, robot);
    }
  }

  private void addTrail(Figure figure, SimpleAgent agent) {
    double spacingM = sideM / SPACINGS_IN_WORLD;
    scene.add(new Trail(figure, agent::getCounter, agent.getHeight() / 2, spacingM));
  }

  private void addName(Figure figure, Agent robot) {
    double reachM = Math.max(robot.getRadius(), robot.getHeight() / 2);
    scene.add(new NameTag(String.valueOf(robot.getName()), figure, reachM));
  }

  /** Says how the world is shown. */
  void show(Look look) {
    scene.show(look);
  }

  /** Returns what a legend of this view explains. */
  Set<Sign> signs() {
    Set<Sign> signs = scene.signs();
    if (!robots.isEmpty()) {
      signs.add(Sign.ROBOT);
    }
    return signs;
  }

  BufferedImage photograph() {
    return scene.photograph();
  }

  /** Looks from a place, a VIEW constant of {@link World}; an unknown one changes nothing. */
  synchronized void look(int viewPoint, @Nullable SimpleAgent agent) {
    SimpleAgent whom = viewPoint == World.VIEW_INWARDS && agent == null ? findRobot() : agent;
    find(viewPoint).ifPresent(lookout -> scene.look(lookout, sizes(whom), figure(lookout, whom)));
  }

  private @Nullable SimpleAgent findRobot() {
    return robots.isEmpty() ? null : robots.get(0);
  }

  private static Optional<Lookout> find(int viewPoint) {
    return switch (viewPoint) {
      case World.VIEW_FROM_TOP -> Optional.of(Lookout.TOP);
      case World.VIEW_FROM_EAST -> Optional.of(Lookout.EAST);
      case World.VIEW_BEHIND_AGENT -> Optional.of(Lookout.BEHIND);
      case World.VIEW_ABOVE_AGENT -> Optional.of(Lookout.ABOVE);
      case World.VIEW_ABOVE_AGENT_NEAR -> Optional.of(Lookout.ABOVE_NEAR);
      case World.VIEW_AGENT_SIDE -> Optional.of(Lookout.SIDE);
      case World.VIEW_INWARDS -> Optional.of(Lookout.INWARDS);
      default -> Optional.empty();
    };
  }

  private Lookout.Sizes sizes(@Nullable SimpleAgent agent) {
    return agent == null
        ? new Lookout.Sizes(sideM, ANY_SIZE_M, ANY_SIZE_M)
        : new Lookout.Sizes(sideM, agent.getHeight(), agent.getRadius());
  }

  private @Nullable Figure figure(Lookout lookout, @Nullable SimpleAgent agent) {
    return agent != null && lookout.follows() ? figures.get(agent) : null;
  }

  void whenFailed(Consumer<String> listener) {
    scene.whenFailed(listener);
  }

  void start() {
    scene.start();
  }

  void stop() {
    scene.stop();
  }

  void drawOnce() {
    scene.drawOnce();
  }

  void dispose() {
    scene.dispose();
  }

  /** What a display shows of an object and of its parts; needs a display. */
  private static Figure figure(BaseObject object) {
    Figure figure = new Figure(object.visual());
    object.nodes().forEach(figure::add);
    object.decorate(figure);
    object.children().forEach(child -> figure.add(figure(child)));
    return figure;
  }
}
