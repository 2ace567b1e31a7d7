package simbad.sim;

import java.util.IdentityHashMap;
import java.util.Optional;
import java.util.function.Consumer;
import javax.media.j3d.Canvas3D;
import org.jspecify.annotations.Nullable;
import simbad.kernel.drawing.Stage;
import simbad.kernel.drawing.Visual;
import simbad.scene3d.DisplayScene;
import simbad.scene3d.Figure;
import simbad.scene3d.Lookout;
import simbad.scene3d.StepHold;

/** Shows a world in a canvas. */
final class WorldView {
  private static final long PATIENCE_MS = 200;
  private static final double ANY_SIZE_M = 0.5;

  private final DisplayScene scene;
  private final double sideM;
  private final IdentityHashMap<BaseObject, Figure> figures = new IdentityHashMap<>();

  /**
   * Opens a view of a world without objects.
   *
   * @throws simbad.scene3d.DisplayException if there can be none here
   */
  WorldView(Stage stage, double sideM, Lock stepLock) {
    this.sideM = sideM;
    scene = new DisplayScene(stage, sideM, holdBy(stepLock));
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

  /** Adds what belongs to no object: the floor, the lamps. */
  void add(Visual surroundings) {
    scene.add(Figure.whole(surroundings));
  }

  synchronized void add(BaseObject object) {
    Figure figure = Figures.of(object);
    figures.put(object, figure);
    scene.add(figure);
  }

  /** Looks from a place, a VIEW constant of {@link World}; an unknown one changes nothing. */
  synchronized void look(int viewPoint, @Nullable SimpleAgent agent) {
    find(viewPoint).ifPresent(lookout -> scene.look(lookout, sizes(agent), figure(lookout, agent)));
  }

  private static Optional<Lookout> find(int viewPoint) {
    return switch (viewPoint) {
      case World.VIEW_FROM_TOP -> Optional.of(Lookout.TOP);
      case World.VIEW_FROM_EAST -> Optional.of(Lookout.EAST);
      case World.VIEW_BEHIND_AGENT -> Optional.of(Lookout.BEHIND);
      case World.VIEW_ABOVE_AGENT -> Optional.of(Lookout.ABOVE);
      case World.VIEW_ABOVE_AGENT_NEAR -> Optional.of(Lookout.ABOVE_NEAR);
      case World.VIEW_AGENT_SIDE -> Optional.of(Lookout.SIDE);
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
}
