package simbad.sonar.model;

import java.util.Arrays;
import simbad.sonar.level.Decibels;
import simbad.sonar.level.LevelLaw;
import simbad.sonar.shape.NearestPoints;

/**
 * What of a scene may be heard at one place by the level law: computed once for all transducers
 * that sit there. First by bounds that cost little, then exactly for what these leave. A buffer
 * that is filled anew; not safe for use by several threads.
 */
final class LevelPlace {
  /**
   * Obstacles whose echoes are nowhere so strong, whatever the bearing and the heading, are left
   * out: one adds at most 0.04 dB to a sum that is heard.
   */
  private static final double FAINT_DB = 20;

  private static final double CELL_M = 0.05;

  private final LevelModel model;
  private final LevelLaw law;
  private final Earshot<LevelTarget> earshot;

  /** The least energy of a sum that may be heard. */
  private final double leastEnergy;

  /** No further apart are the centres of any two parts of a sum. */
  private final double roundM;

  /** What is left of an echo's energy at most, by the distance in cells. */
  private final double[] greatestLeft;

  private LevelTarget[] target = {};
  private NearestPoints[] nearest = {};
  private double[] centreM = {};
  private double[] energy = {};
  private int[] leader = {};
  private int[] kept = {};
  private int size;
  private boolean placed;
  private double atXM;
  private double atZM;

  /**
   * Prepares for places in a scene.
   *
   * @param model scene and law
   * @param leastDb excess of a sum that may be heard
   */
  LevelPlace(LevelModel model, double leastDb) {
    this.model = model;
    law = model.law();
    leastEnergy = Decibels.energy(leastDb) * (1 - 1e-6);
    double widestM =
        Arrays.stream(model.targets()).mapToDouble(PlacedObstacle::reachM).max().orElse(0);
    roundM = law.pulseLengthM() + 2 * widestM;
    double maxRangeM = model.sensor().maxRangeM();
    double[] reachM =
        Arrays.stream(model.targets())
            .mapToDouble(
                one ->
                    law.reachM(
                        one.strength().greatestDb(), leastDb - FAINT_DB, maxRangeM + one.reachM()))
            .toArray();
    earshot = new Earshot<>(model.targets(), reachM);
    double furthestM = Arrays.stream(reachM).max().orElse(0);
    greatestLeft = law.greatestLeft(CELL_M, (int) (1.25 * furthestM / CELL_M) + 2);
  }

  int size() {
    return size;
  }

  /** The distance of the nearest point of a target, metres. */
  double nearestM(int index) {
    return nearest[index].distanceM();
  }

  /** The energy of a target's echo over the threshold's. */
  double energy(int index, TransducerPose from) {
    return energy[index] * LevelModel.beamEnergy(law, nearest[index], from);
  }

  /** Moves to a place; afterwards what may be heard there is here, in no order. */
  void moveTo(double xM, double zM) {
    if (placed && xM == atXM && zM == atZM) {
      return;
    }
    earshot.moveTo(xM, zM);
    size = 0;
    for (int i = 0; i < earshot.size(); i++) {
      guess(earshot.get(i), xM, zM);
    }
    dropFaint();
    double greatestBeam = law.beam().greatestEnergy();
    for (int i = 0; i < size; i++) {
      energy[i] = target[i].axisEnergy(law, xM, zM, centreM[i]) * greatestBeam;
    }
    dropFaint();
    locate(xM, zM);
    atXM = xM;
    atZM = zM;
    placed = true;
  }

  private void guess(LevelTarget one, double xM, double zM) {
    if (size == target.length) {
      grow();
    }
    double centre = one.centreDistanceM(xM, zM);
    int cell = Math.min((int) (centre / CELL_M), greatestLeft.length - 1);
    target[size] = one;
    centreM[size] = centre;
    energy[size] = one.greatestEnergy() * greatestLeft[cell];
    size++;
  }

  private void grow() {
    int room = Math.max(4, 2 * size);
    LevelTarget[] more = Arrays.copyOf(model.targets(), room);
    System.arraycopy(target, 0, more, 0, size);
    target = more;
    centreM = Arrays.copyOf(centreM, room);
    energy = Arrays.copyOf(energy, room);
    leader = new int[room];
    kept = new int[room];
    nearest = Arrays.copyOf(nearest, room);
    for (int i = size; i < room; i++) {
      nearest[i] = new NearestPoints();
    }
  }

  /**
   * Keeps what may have a part in a sum that is loud enough. Every such sum has a part that is at
   * least its mean, and all its parts lie round that one: only there sums are formed.
   */
  private void dropFaint() {
    double leastPart = leastEnergy / size;
    int leaders = 0;
    for (int i = 0; i < size; i++) {
      if (energy[i] >= leastPart && (energy[i] >= leastEnergy || sumRound(i) >= leastEnergy)) {
        leader[leaders++] = i;
      }
    }
    int count = 0;
    for (int i = 0; i < size; i++) {
      if (isNearAny(centreM[i], leaders)) {
        kept[count++] = i;
      }
    }
    for (int i = 0; i < count; i++) {
      target[i] = target[kept[i]];
      centreM[i] = centreM[kept[i]];
      energy[i] = energy[kept[i]];
    }
    size = count;
  }

  private double sumRound(int index) {
    double sum = 0;
    for (int i = 0; i < size; i++) {
      sum += Math.abs(centreM[i] - centreM[index]) <= roundM ? energy[i] : 0;
    }
    return sum;
  }

  private boolean isNearAny(double atM, int leaders) {
    for (int i = 0; i < leaders; i++) {
      if (Math.abs(centreM[leader[i]] - atM) <= roundM) {
        return true;
      }
    }
    return false;
  }

  /** Finds the nearest points, and drops what is out of the sensor's range. */
  private void locate(double xM, double zM) {
    double greatestBeam = law.beam().greatestEnergy();
    int count = 0;
    for (int i = 0; i < size; i++) {
      NearestPoints points = nearest[count];
      target[i].findNearest(xM, zM, points);
      if (points.distanceM() >= model.sensor().minRangeM()
          && points.distanceM() <= model.sensor().maxRangeM()) {
        energy[count] = energy[i] / greatestBeam;
        count++;
      }
    }
    size = count;
  }
}
