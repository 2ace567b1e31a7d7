package simbad.sim;

import java.awt.event.KeyListener;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.JComponent;
import org.jspecify.annotations.Nullable;
import simbad.kernel.run.Pacer;

/**
 * Steps the agents of an environment.
 *
 * <p>A step lets all agents sense and their actuators act, then all behaviours run, then all
 * displacements are computed, then collisions are found, and only then everything moves: what an
 * agent senses does not depend on its place in the list.
 */
public class Simulator {
  private static final int DEFAULT_FRAMES_PER_SECOND = 20;

  private static volatile @Nullable StepListener listener;

  private final ArrayList<SimpleAgent> agents;
  private final List<Runnable> changes = new ArrayList<>();
  private final World world;
  private final PhysicalEngine engine = new PhysicalEngine();
  private final ArrayList<Object> noObjects = new ArrayList<>();
  private final Lock lock;
  private final Pacer pacer = new Pacer("simulation");
  private boolean usePhysics;
  private volatile boolean stepping;
  private volatile boolean flatOut;
  private int framesPerSecond = DEFAULT_FRAMES_PER_SECOND;
  private float virtualTimeFactor = 1;
  private @Nullable JComponent applicationComponent;

  /**
   * Creates a simulator, creates and resets the environment's agents and puts them into the world.
   *
   * @param application component that shows the application, null without a window
   * @param world made from the same environment
   * @param environment gives the agents
   */
  public Simulator(
      @Nullable JComponent application, World world, EnvironmentDescription environment) {
    this.world = world;
    applicationComponent = application;
    lock = world.stepLock();
    usePhysics = environment.usePhysics;
    agents = new ArrayList<>(environment.list(SimpleAgent.class));
    agents.forEach(agent -> admit(agent, world));
    keyListeners().forEach(added -> withComponent(c -> c.addKeyListener(added)));
    StepListener told = listener;
    if (told != null) {
      told.made(this, world);
    }
  }

  /** Says who is told of all simulators that are made from now on; null for nobody. */
  public static void setListener(@Nullable StepListener newListener) {
    listener = newListener;
  }

  /** Returns what is simulated. */
  public World getWorld() {
    return world;
  }

  /**
   * Puts an agent into the running simulation, at its start and with its behaviour prepared. Within
   * a step, it comes before the next one.
   */
  public void addAgent(SimpleAgent agent) {
    change(
        () -> {
          admit(agent, world);
          agents.add(agent);
          agent.initPreBehavior();
          agent.initBehavior();
        });
  }

  /** Takes an agent out of the simulation and the world; within a step, before the next one. */
  public void removeAgent(SimpleAgent agent) {
    change(
        () -> {
          if (agents.remove(agent)) {
            agent.detach();
            agent.dispose();
          }
        });
  }

  private void change(Runnable change) {
    synchronized (changes) {
      changes.add(change);
    }
    if (!stepping) {
      applyChanges();
    }
  }

  private synchronized void applyChanges() {
    List<Runnable> due;
    synchronized (changes) {
      due = List.copyOf(changes);
      changes.clear();
    }
    due.forEach(Runnable::run);
  }

  private void admit(SimpleAgent agent, World world) {
    agent.setSimulator(this);
    agent.create();
    agent.reset();
    world.addObjectToPickableSceneBranch(agent);
  }

  /** Stops and frees what the agents hold. */
  public void dispose() {
    pacer.stop();
    keyListeners().forEach(removed -> withComponent(c -> c.removeKeyListener(removed)));
    synchronized (this) {
      agents.forEach(SimpleAgent::dispose);
    }
  }

  /** Returns the sensors that listen to the keys of the application. */
  private List<KeyListener> keyListeners() {
    return agents.stream()
        .flatMap(agent -> agent.getSensorList().stream())
        .filter(KeyListener.class::isInstance)
        .map(KeyListener.class::cast)
        .toList();
  }

  private void withComponent(Consumer<JComponent> action) {
    if (applicationComponent != null) {
      action.accept(applicationComponent);
    }
  }

  /** Does one step. */
  public synchronized void simulateOneStep() {
    StepListener told = listener;
    if (told != null) {
      told.stepping(this);
    }
    if (!changes.isEmpty()) {
      applyChanges();
    }
    lock();
    stepping = true;
    try {
      step(1.0 / framesPerSecond);
    } finally {
      stepping = false;
      unlock();
    }
    if (told != null) {
      told.stepped(this);
    }
  }

  /** Returns true if a habit of the original keeps the agent that was near in this step, too. */
  private static boolean staysNear(SimpleAgent agent, boolean isLast) {
    return isLast
        && agent.anOtherAgentIsVeryNear()
        && !agent.positionChanged
        && !agent.detachedFromSceneGraph
        && agent.meets(Compatibility.NEARNESS_IS_ONE_SIDED);
  }

  private void step(double elapsedSecond) {
    for (int i = 0; i < agents.size(); i++) {
      SimpleAgent agent = agents.get(i);
      agent.updateSensors(elapsedSecond, null);
      agent.updateActuators(elapsedSecond);
    }
    for (int i = 0; i < agents.size(); i++) {
      SimpleAgent agent = agents.get(i);
      agent.performPreBehavior();
      agent.performBehavior();
    }
    for (int i = 0; i < agents.size(); i++) {
      SimpleAgent agent = agents.get(i);
      if (!staysNear(agent, i == agents.size() - 1)) {
        agent.clearVeryNear();
      }
      agent.setMotorsAcceleration(elapsedSecond);
      if (usePhysics) {
        engine.computeForces(elapsedSecond, agent);
      }
      agent.integratesVelocities(elapsedSecond);
      agent.integratesPositionChange(elapsedSecond);
    }
    if (usePhysics) {
      engine.checkAgentAgentPairs(elapsedSecond, agents, true, false);
      engine.checkAgentObjectPairs(agents, noObjects, true, false);
    }
    engine.checkAgentAgentPairs(elapsedSecond, agents, usePhysics, true);
    engine.land(agents);
    engine.checkAgentObjectPairs(agents, noObjects, false, false);
    if (usePhysics) {
      engine.settle(agents, elapsedSecond);
    }
    for (int i = 0; i < agents.size(); i++) {
      SimpleAgent agent = agents.get(i);
      agent.updatePosition();
      agent.updateCounters(elapsedSecond);
    }
  }

  /** Lets every agent prepare its behaviour. */
  public synchronized void initBehaviors() {
    for (SimpleAgent agent : agents) {
      agent.initPreBehavior();
      agent.initBehavior();
    }
  }

  /** Prepares the behaviours and steps on a thread of its own, in time with the wall clock. */
  public void startSimulation() {
    pacer.stop();
    synchronized (this) {
      initBehaviors();
      startPacing();
    }
  }

  private void startPacing() {
    flatOut = false;
    pacer.start(1 / ((double) framesPerSecond * virtualTimeFactor), this::pacedStep);
  }

  /** Does a step, unless stepping was stopped while this one waited for its turn. */
  private synchronized void pacedStep() {
    if (isRunning()) {
      simulateOneStep();
    }
  }

  /** Returns true while the simulation steps on a thread of its own. */
  public boolean isRunning() {
    return pacer.isStarted();
  }

  /** Stops stepping; a step that is under way is waited for. */
  public void stopSimulation() {
    pacer.stop();
    awaitStep();
  }

  /** Returns when no step is under way; a step itself may ask, too. */
  private synchronized void awaitStep() {
    // Steps hold the monitor that this method needs.
  }

  /** Resets and starts. */
  public void restartSimulation() {
    resetSimulation();
    startSimulation();
  }

  /** Stops and puts every agent back to its start. */
  public void resetSimulation() {
    pacer.stop();
    synchronized (this) {
      agents.forEach(SimpleAgent::reset);
    }
  }

  /** Stops and does one step. */
  public void performSimulationStep() {
    pacer.stop();
    simulateOneStep();
  }

  /** Returns the agents, in the order of the environment. */
  @SuppressWarnings("NonApiType") // The type is Simbad's.
  public ArrayList<SimpleAgent> getAgentList() {
    return agents;
  }

  /** Switches physics on or off. */
  protected void setUsePhysics(boolean newUsePhysics) {
    usePhysics = newUsePhysics;
  }

  /** Returns whether physics is on. */
  protected boolean getUsePhysics() {
    return usePhysics;
  }

  /** Sets the steps per simulated second; at least 1. */
  protected void setFramesPerSecond(int fps) {
    if (fps < 1) {
      throw new IllegalArgumentException("fps = " + fps + " is not in [1, infinity)");
    }
    framesPerSecond = fps;
  }

  /** Returns the steps per simulated second. */
  protected int getFramesPerSecond() {
    return framesPerSecond;
  }

  /** Sets how much faster than the wall clock to step, also while running; above 0. */
  public void setVirtualTimeFactor(float factor) {
    if (!(factor > 0)) {
      throw new IllegalArgumentException("factor = " + factor + " is not in (0, infinity)");
    }
    virtualTimeFactor = factor;
    if (isRunning() && !flatOut) {
      startPacing();
    }
  }

  /** Returns how much faster than the wall clock the simulation steps. */
  public float getVirtualTimeFactor() {
    return virtualTimeFactor;
  }

  /** Says which component shows the application. */
  public void setApplicationComponent(@Nullable JComponent component) {
    applicationComponent = component;
  }

  /** Returns the component that shows the application, null without a window. */
  @Nullable JComponent applicationComponent() {
    return applicationComponent;
  }

  /** Waits until no step is under way and holds further ones. */
  public void lock() {
    lock.lock();
  }

  /** Lets steps go on. */
  public void unlock() {
    lock.unlock();
  }

  /** Prepares the behaviours and steps on a thread of its own, as fast as it can. */
  public void startBackgroundMode() {
    pacer.stop();
    synchronized (this) {
      initBehaviors();
      flatOut = true;
      pacer.start(0, this::pacedStep);
    }
  }

  /** Stops stepping; a step that is under way is waited for. */
  public void stopBackgroundMode() {
    stopSimulation();
  }
}
