package simbad.blindworld.motionchange;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import simbad.blindworld.motion.Commands;
import simbad.blindworld.motion.MotionWorld;
import simbad.blindworld.motion.Outing;
import simbad.blindworld.motion.Robot;
import simbad.blindworld.motion.Track;
import simbad.blindworld.motion.Windows;
import simbad.blindworld.world.Chance;
import simbad.blindworld.world.Pose;

/** Every form of every effect: of size 0 it changes nothing, of a practical one it shows. */
class EveryMotionFormTest {

  private static final Robot ROBOT =
      new Robot(0.03, 0.15, true, Robot.Beliefs.NONE, Robot.Scatter.NONE, false);
  private static final Outing OUTING = outing();

  /** Two minutes of pieces, forth and back, of speeds from a twentieth of the greatest on. */
  private static Outing outing() {
    Chance random = new Chance(4);
    int count = 600;
    double[] times = new double[count];
    double[] v = new double[count];
    double[] w = new double[count];
    for (int i = 0; i < count; i++) {
      times[i] = i / 5.0;
      boolean kept = i % 5 > 0;
      v[i] = kept ? v[i - 1] : random.nextDouble(-0.1, 0.3);
      w[i] = kept ? w[i - 1] : random.nextDouble(-1, 1);
    }
    double[] frames =
        java.util.stream.IntStream.range(0, 1200).mapToDouble(i -> i / 10.0).toArray();
    Commands commands = new Commands(times, v, w);
    return new Outing(List.of(new Outing.Run("r", commands, frames, 120, new Pose(0.2, 0.1, 0.5))));
  }

  private static double[][] moved(List<MotionEffect> effects, long seed) {
    MotionWorld world =
        new MotionWorld(
            ROBOT,
            new MotionWorld.Seeing(Robot.Scatter.NONE, 0),
            effects.stream().map(MotionEffect::change).toList());
    Track track = world.drive(OUTING, seed);
    return Windows.of(OUTING).displacements(track);
  }

  static Stream<String> forms() {
    return Stream.concat(MotionVocabulary.names().stream(), MotionVocabulary.outside().stream())
        .flatMap(name -> MotionVocabulary.forms(name).stream().map(form -> name + "/" + form));
  }

  private static double number(MotionEffect effect, String name) {
    return (Double) Objects.requireNonNull(effect.parameters().get(name), name);
  }

  private static MotionEffect effect(String form, double size) {
    String[] words = form.split("/", 2);
    MotionSite site = new MotionSite(ROBOT, OUTING, new Chance(9), size);
    return MotionVocabulary.draw(words[0], words[1], site);
  }

  @ParameterizedTest
  @MethodSource("forms")
  void sizeZero_changesNothing_andOneShows(String form) {
    double[][] plain = moved(List.of(), 1);
    double apart = apart(plain, moved(List.of(effect(form, 1)), 1));
    assertTrue(apart > 0.003, form + " changes " + apart);
    if (!form.startsWith("ringing")) {
      // A swing has no size at which it is none.
      assertEquals(0, apart(plain, moved(List.of(effect(form, 0)), 1)), 1e-9, form);
    }
    assertTrue(
        Arrays.deepEquals(moved(List.of(effect(form, 1)), 2), moved(List.of(effect(form, 1)), 2)));
  }

  /** The root of the mean square in metres, a degree counting as a centimetre. */
  private static double apart(double[][] one, double[][] other) {
    double sum = 0;
    for (int i = 0; i < one.length; i++) {
      for (int c = 0; c < one[i].length; c++) {
        double difference = (one[i][c] - other[i][c]) / (c == 2 ? 100 : 1);
        sum += difference * difference;
      }
    }
    return Math.sqrt(sum / one.length);
  }

  @Test
  void vocabulary_isThatOfTheFormat() {
    assertEquals(
        List.of(
            "actuation-lag",
            "actuation-latency",
            "capture-offset",
            "command-quantization",
            "dead-band",
            "motion-noise",
            "saturation",
            "slip",
            "speed-scale",
            "time-offset",
            "turn-bias",
            "turn-scale",
            "wheel-asymmetry",
            "wheel-scale"),
        MotionVocabulary.names());
    assertTrue(MotionVocabulary.outside().size() >= 18);
    assertTrue(MotionVocabulary.isFairPair("slip", "turn-bias"));
    assertFalse(MotionVocabulary.isFairPair("speed-scale", "turn-scale"));
    assertTrue(MotionVocabulary.isSameStage("speed-scale", "turn-scale"));
    assertEquals(List.of("actuation-lag"), MotionVocabulary.rivals("time-offset"));
    assertEquals(2, MotionVocabulary.accept("wheel-scale").size());
  }

  /** A factor of the wheels is that factor of both speeds, in closed form. */
  @Test
  void wheelScale_isSpeedAndTurn() {
    double factor = number(effect("wheel-scale/factor", 1), "factor");
    double[][] plain = moved(List.of(), 1);
    double[][] scaled = moved(List.of(effect("wheel-scale/factor", 1)), 1);
    for (int i = 0; i < plain.length; i++) {
      assertEquals(factor * plain[i][2], scaled[i][2], 1e-6);
    }
  }

  /** A tracker that is turned by a sees the way (cos a, -sin a) times as long along and across. */
  @Test
  void captureHeading_turnsTheWay() {
    double deg = number(effect("capture-offset/heading", 1), "deg");
    double a = Math.toRadians(deg);
    double[] plain = moved(List.of(), 1)[10];
    double[] turned = moved(List.of(effect("capture-offset/heading", 1)), 1)[10];
    assertEquals(plain[0] * Math.cos(a) + plain[1] * Math.sin(a), turned[0], 1e-9);
    assertEquals(-plain[0] * Math.sin(a) + plain[1] * Math.cos(a), turned[1], 1e-9);
    assertEquals(plain[2], turned[2], 1e-9);
  }
}
