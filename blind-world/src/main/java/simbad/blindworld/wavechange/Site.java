package simbad.blindworld.wavechange;

import java.util.Arrays;
import java.util.List;
import java.util.random.RandomGenerator;
import simbad.blindworld.check.Checks;
import simbad.blindworld.effect.Circumstances;
import simbad.blindworld.wave.Alteration;
import simbad.blindworld.wave.Target;
import simbad.blindworld.wave.WaveWorld;
import simbad.blindworld.wavesetup.Room;
import simbad.blindworld.world.Point;
import simbad.blindworld.world.Recording;
import simbad.blindworld.world.Scene;

/**
 * Where a change is to be put in, and chance.
 *
 * @param room what is there
 * @param parts the same on the day of the readings, with the counter as its user set it
 * @param scene what its user believes
 * @param recording the rows that will be read
 * @param driven true when a robot drives, false on a bench
 * @param heardM what is read on them without a change, echoes only, rising
 * @param random chance
 * @param size 1 for a practical one
 */
public record Site(
    Room room,
    WaveWorld.Parts parts,
    Scene scene,
    Recording recording,
    boolean driven,
    List<Double> heardM,
    RandomGenerator random,
    double size) {

  /** Copies the list. */
  public Site {
    Checks.notNegative("size", size);
    heardM = Checks.numbers("readings", heardM);
  }

  /** Echoes of a set of readings, rising. */
  public static List<Double> heard(double[] readingsM) {
    return Arrays.stream(readingsM).filter(Double::isFinite).sorted().boxed().toList();
  }

  /** The practical size times the size asked for. */
  double sized(double practical) {
    return practical * size;
  }

  /** The practical size times the size asked for, up or down by chance. */
  double eitherWay(double practical) {
    return random.nextBoolean() ? sized(practical) : -sized(practical);
  }

  double between(double low, double high) {
    return random.nextDouble(low, high);
  }

  /** A quantile of the readings, in metres. */
  double heardM(double quantile) {
    double place = Math.max(0, Math.min(1, quantile)) * heardM.size();
    return heardM.isEmpty() ? 1 : heardM.get((int) Math.min(heardM.size() - 1.0, place));
  }

  /** The time at which an echo from a distance comes, in seconds. */
  double timeS(double distanceM) {
    return 2 * distanceM / parts.air().soundSpeedMPerS();
  }

  int someObstacle() {
    return random.nextInt(room.targets().size());
  }

  /** The obstacle as it stands. */
  Target target(int index) {
    return room.targets().get(index);
  }

  /** A point so far from an obstacle, in any direction. */
  Point beside(int index, double distanceM) {
    double direction = between(0, 2 * Math.PI);
    Point place = target(index).place();
    return new Point(
        place.xM() + distanceM * StrictMath.cos(direction),
        place.zM() + distanceM * StrictMath.sin(direction));
  }

  /** How far each row's sonar is from the obstacle that is nearest to it. */
  double[] distancesM() {
    return recording.rows().stream()
        .mapToDouble(
            row ->
                room.targets().stream()
                    .map(Target::place)
                    .mapToDouble(
                        p -> StrictMath.hypot(row.pose().xM() - p.xM(), row.pose().zM() - p.zM()))
                    .min()
                    .orElseThrow())
        .toArray();
  }

  /** The world with an alteration, before the rows. */
  WaveWorld.Listening listening(List<Alteration> alterations) {
    return new WaveWorld(parts, alterations).at(recording);
  }

  /** The same for changes that act on believed poses, whatever the physics. */
  Circumstances circumstances() {
    return new Circumstances(scene, recording, driven, random, size);
  }
}
