package simbad.blindworld.effect;

import static simbad.blindworld.effect.Changes.echo;
import static simbad.blindworld.effect.Changes.isEcho;
import static simbad.blindworld.effect.Changes.range;
import static simbad.blindworld.effect.Changes.reports;
import static simbad.blindworld.effect.Changes.threshold;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.random.RandomGenerator;
import simbad.blindworld.effect.Form.Drawn;
import simbad.blindworld.world.Body;
import simbad.blindworld.world.Change;
import simbad.blindworld.world.Pose;
import simbad.blindworld.world.Recording;

/** What no name of the vocabulary covers: time, map, energy, poses, wiring and range. */
final class OutsideForms {

  private static final double NEVER = Double.POSITIVE_INFINITY;

  private OutsideForms() {}

  static List<Form> all() {
    List<Form> forms = new ArrayList<>();
    forms.addAll(ofTime());
    forms.addAll(ofPlace());
    forms.addAll(ofOneTransducer());
    forms.addAll(ofRange());
    return forms;
  }

  private static List<Form> ofTime() {
    return List.of(
        Form.anywhere("gain-swing", "sine", OutsideForms::gainSwing),
        Form.anywhere("gain-swing", "fading", OutsideForms::gainFading),
        Form.anywhere("temperature-ramp", "linear", OutsideForms::temperatureRamp),
        Form.anywhere("warm-up", "exponential", OutsideForms::warmUp),
        Form.anywhere("obstacle-leaves", "half time", OutsideForms::leaves),
        Form.anywhere("obstacle-moves", "half time", OutsideForms::moves),
        Form.driven("clock-stretch", "linear", OutsideForms::clockStretch),
        Form.driven("speed-loss", "linear", OutsideForms::speedLoss),
        Form.driven("turning-loss", "linear", OutsideForms::turningLoss));
  }

  private static List<Form> ofPlace() {
    return List.of(
        Form.anywhere("sector-thresholds", "one sector", OutsideForms::sector),
        Form.anywhere("noise-side", "one side", OutsideForms::noiseSide),
        Form.anywhere("wind-shear", "cosine", OutsideForms::windShear),
        Form.anywhere("edge-blur", "wide", OutsideForms::edgeBlur),
        Form.anywhere("pose-jitter", "gaussian", OutsideForms::poseJitter));
  }

  private static List<Form> ofOneTransducer() {
    return List.of(
        several("one-gain", "factor", OutsideForms::oneGain),
        several("one-offset", "constant", OutsideForms::oneOffset),
        several("crossed-wires", "two", OutsideForms::crossedWires),
        several("swapped-readings", "now and then", OutsideForms::swappedReadings));
  }

  private static List<Form> ofRange() {
    return List.of(
        Form.anywhere("quadratic-range", "square", OutsideForms::quadratic),
        Form.anywhere("range-knee", "compressed", OutsideForms::knee),
        Form.anywhere("range-bump", "bell", OutsideForms::bump),
        Form.anywhere("range-band-loss", "band", OutsideForms::bandLoss),
        Form.anywhere("range-wave", "sine", OutsideForms::wave),
        Form.anywhere("sticky-reading", "deadband", OutsideForms::sticky),
        new Form(
            "second-echo",
            "two arrivals",
            c -> c.scene().obstacles().size() > 1,
            OutsideForms::secondEcho));
  }

  private static Form several(String name, String label, Function<Circumstances, Drawn> draw) {
    return new Form(name, label, Circumstances::severalSensors, draw);
  }

  private static double halfTimeS(Circumstances c) {
    return c.recording().longestS() * c.between(0.35, 0.6);
  }

  private static Drawn gainSwing(Circumstances c) {
    double swing = Math.min(0.8, c.sized(0.35));
    double periodS = c.recording().longestS() * c.between(0.25, 1.2);
    double phase = c.between(0, 2 * Math.PI);
    return new Drawn(
        Map.of("swing", swing, "period_s", periodS),
        threshold(
            (t, s, p) -> t * (1 + swing * StrictMath.sin(2 * Math.PI * p.tS() / periodS + phase))));
  }

  private static Drawn gainFading(Circumstances c) {
    double loss = Math.min(0.9, c.sized(0.45));
    double longS = c.recording().longestS();
    return new Drawn(
        Map.of("loss", loss), threshold((t, s, p) -> t * (1 - loss * Math.min(1, p.tS() / longS))));
  }

  private static Drawn temperatureRamp(Circumstances c) {
    double rise = c.eitherWay(0.1);
    double longS = c.recording().longestS();
    return new Drawn(
        Map.of("rise", rise), range((r, p) -> r * (1 + rise * Math.min(1.2, p.tS() / longS))));
  }

  private static Drawn warmUp(Circumstances c) {
    double first = c.eitherWay(0.2);
    double timeS = c.recording().longestS() * c.between(0.15, 0.4);
    return new Drawn(
        Map.of("first_m", first, "time_s", timeS),
        range((r, p) -> r + first * StrictMath.exp(-p.tS() / timeS)));
  }

  private static Drawn leaves(Circumstances c) {
    double at = halfTimeS(c);
    int which = c.obstacle();
    double until = c.strength() > 0 ? at : NEVER;
    return new Drawn(
        Map.of("at_s", at, "obstacle", c.scene().obstacles().get(which).name()),
        MapForms.bodies(which, b -> b.during(Double.NEGATIVE_INFINITY, until)));
  }

  /** Two bodies, each there for its part of every run. */
  private static Drawn moves(Circumstances c) {
    double at = halfTimeS(c);
    double by = c.sized(0.3);
    double direction = c.between(0, 2 * Math.PI);
    int which = c.obstacle();
    Change change =
        new Change() {
          @Override
          public List<Body> bodies(List<Body> bodies) {
            List<Body> changed = new ArrayList<>(bodies);
            Body body = bodies.get(which);
            changed.set(which, body.during(Double.NEGATIVE_INFINITY, at));
            changed.add(
                body.moved(by * StrictMath.cos(direction), by * StrictMath.sin(direction))
                    .during(at, NEVER));
            return c.strength() > 0 ? changed : bodies;
          }
        };
    return new Drawn(Map.of("at_s", at, "by_m", by), change);
  }

  private static Drawn clockStretch(Circumstances c) {
    double stretch = c.sized(0.12);
    return new Drawn(
        Map.of("stretch", stretch),
        PoseForms.course(
            false,
            (path, random) ->
                PoseForms.each(
                    path,
                    k -> {
                      double begun = path.timesS().get(0);
                      double since = path.timesS().get(k) - begun;
                      return path.at(begun + since * (1 - stretch));
                    })));
  }

  private static Drawn speedLoss(Circumstances c) {
    double perSpeed = c.sized(1.2);
    return new Drawn(
        Map.of("s_per_m", perSpeed),
        threshold((t, s, p) -> t * Math.max(0.1, 1 - perSpeed * p.motion().speedMPerS())));
  }

  private static Drawn turningLoss(Circumstances c) {
    double perRate = c.sized(0.6);
    return new Drawn(
        Map.of("s_per_rad", perRate),
        threshold((t, s, p) -> t / (1 + perRate * Math.abs(p.motion().turnRadPerS()))));
  }

  private static Drawn sector(Circumstances c) {
    double factor = StrictMath.exp(c.eitherWay(0.5));
    double centre = c.between(0, 2 * Math.PI);
    double half = c.between(0.35, 0.8);
    return new Drawn(
        Map.of("factor", factor, "centre_rad", centre, "half_rad", half),
        threshold(
            (t, s, p) -> {
              double beside = Math.abs(Math.IEEEremainder(s.bearingRad() - centre, 2 * Math.PI));
              return beside < half ? t * factor : t;
            }));
  }

  /** A loud machine on one side of the room: what looks there hears less. */
  private static Drawn noiseSide(Circumstances c) {
    double loss = Math.min(0.9, c.sized(0.5));
    double side = c.between(0, 2 * Math.PI);
    return new Drawn(
        Map.of("loss", loss, "side_rad", side),
        threshold(
            (t, s, p) -> {
              double facing = Math.max(0, StrictMath.cos(p.pose().headingRad() - side));
              return t * (1 - loss * facing * facing);
            }));
  }

  /** Wind carries sound faster one way: ranges depend on the direction of looking. */
  private static Drawn windShear(Circumstances c) {
    double share = c.sized(0.07);
    double side = c.between(0, 2 * Math.PI);
    return new Drawn(
        Map.of("share", share, "side_rad", side),
        range((r, p) -> r * (1 + share * StrictMath.cos(p.pose().headingRad() - side))));
  }

  /** Thresholds that differ a good deal from ping to ping: the chance falls off slowly. */
  private static Drawn edgeBlur(Circumstances c) {
    double share = c.sized(0.25);
    return new Drawn(
        Map.of("share", share),
        threshold((t, s, p) -> t * Math.max(0, 1 + share * p.random().nextGaussian())));
  }

  private static Drawn poseJitter(Circumstances c) {
    double metres = c.sized(0.04);
    double rad = Math.toRadians(c.sized(5));
    return new Drawn(
        Map.of("sd_m", metres, "sd_rad", rad),
        PoseForms.course(true, (path, random) -> jittered(path, random, metres, rad)));
  }

  private static List<Pose> jittered(
      PoseForms.Path path, RandomGenerator random, double metres, double rad) {
    return PoseForms.each(
        path,
        k -> {
          Pose pose = path.poses().get(k);
          double x = pose.xM() + metres * random.nextGaussian();
          double z = pose.zM() + metres * random.nextGaussian();
          return pose.at(x, z).turned(rad * random.nextGaussian());
        });
  }

  private static Drawn oneGain(Circumstances c) {
    String sensor = c.transducer();
    double k = StrictMath.exp(c.eitherWay(0.4));
    return new Drawn(
        Map.of("k", k, "sensor", sensor),
        OneTransducer.only(sensor, threshold((t, s, p) -> t * k)));
  }

  private static Drawn oneOffset(Circumstances c) {
    String sensor = c.transducer();
    double offset = c.eitherWay(0.12);
    return new Drawn(
        Map.of("m", offset, "sensor", sensor),
        OneTransducer.only(sensor, range((r, p) -> r + offset)));
  }

  private static Drawn crossedWires(Circumstances c) {
    return crossed(c, (k, size) -> c.strength() > 0);
  }

  private static Drawn swappedReadings(Circumstances c) {
    int every = c.whole(2, 4);
    int length = c.whole(1, 6);
    return crossed(c, (k, size) -> c.strength() > 0 && k / length % every == 0);
  }

  private static Drawn crossed(Circumstances c, OneTransducer.When when) {
    List<String> sensors = c.recording().sensors();
    int first = c.whole(0, sensors.size() - 2);
    String a = sensors.get(first);
    String b = sensors.get(c.whole(first + 1, sensors.size() - 1));
    Change change =
        new Change() {
          @Override
          public List<Pose> poses(Recording recording, List<Pose> poses, RandomGenerator random) {
            return OneTransducer.swapped(recording, poses, List.of(a, b), when);
          }
        };
    return new Drawn(Map.of("first", a, "second", b), change);
  }

  private static Drawn quadratic(Circumstances c) {
    double perM = c.eitherWay(0.05);
    return new Drawn(Map.of("per_m", perM), range((r, p) -> r + perM * r * r));
  }

  private static Drawn knee(Circumstances c) {
    double at = c.distanceM(c.between(0.3, 0.55));
    double slope = Math.max(0.2, 1 - c.sized(0.35));
    return new Drawn(
        Map.of("m", at, "slope", slope), range((r, p) -> r > at ? at + slope * (r - at) : r));
  }

  private static Drawn bump(Circumstances c) {
    double at = c.distanceM(c.between(0.3, 0.7));
    double width = c.between(0.1, 0.25);
    double height = c.eitherWay(0.15);
    return new Drawn(
        Map.of("m", at, "width_m", width, "height_m", height),
        range((r, p) -> r + height * StrictMath.exp(-0.5 * StrictMath.pow((r - at) / width, 2))));
  }

  private static Drawn bandLoss(Circumstances c) {
    double low = c.distanceM(c.between(0.25, 0.45));
    double high = c.strength() > 0 ? c.distanceM(c.between(0.55, 0.75)) : low;
    return new Drawn(
        Map.of("from_m", low, "to_m", high), echo((d, p) -> d >= low && d < high ? NEVER : d));
  }

  private static Drawn wave(Circumstances c) {
    double height = c.sized(0.06);
    double length = c.between(0.25, 0.8);
    return new Drawn(
        Map.of("height_m", height, "length_m", length),
        range((r, p) -> Math.max(0, r + height * StrictMath.sin(2 * Math.PI * r / length))));
  }

  /** A reading changes only when it would change by more than a band. */
  private static Drawn sticky(Circumstances c) {
    double band = c.sized(0.15);
    return new Drawn(
        Map.of("band_m", band),
        reports(
            () -> {
              double[] shown = {NEVER};
              return (r, p) -> {
                boolean keeps = isEcho(r) && isEcho(shown[0]) && Math.abs(r - shown[0]) < band;
                shown[0] = keeps ? shown[0] : r;
                return shown[0];
              };
            }));
  }

  private static Drawn secondEcho(Circumstances c) {
    double p = Math.min(1, c.sized(0.7));
    return new Drawn(
        Map.of("p", p),
        echo(
            (d, ping) ->
                isEcho(ping.secondM()) && ping.random().nextDouble() < p ? ping.secondM() : d));
  }
}
