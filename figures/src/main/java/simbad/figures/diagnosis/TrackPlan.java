package simbad.figures.diagnosis;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import simbad.figures.page.Html;
import simbad.figures.page.Numbers;
import simbad.figures.page.PagePicture;
import simbad.motion.Displacement;
import simbad.motion.MotionChain;
import simbad.motion.MotionRun;
import simbad.motion.TrackPose;
import simbad.motion.Way;
import simbad.sonar.frame.Point;

/**
 * A stretch of the track from above, with what was forecast of it before and after: of all
 * stretches of half a minute, or of what a shorter run has, the one whose forecasts were farthest
 * off before.
 */
final class TrackPlan {
  private static final double AHEAD_S = 5;
  private static final int FORECASTS = 6;
  private static final double DRAWN_S = 0.25;

  /** A forecast begins and ends where the track is known. */
  private static final double NEAR_S = 0.1;

  private final MotionRun run;
  private final Way before;
  private final Way after;

  /** A pose of the track, and what was forecast from it. */
  private record Forecast(TrackPose from, TrackPose to) {
    double errorM(Way way) {
      Point end = forecast(way, to.timeS());
      return Math.hypot(end.xM() - to.xM(), end.zM() + to.yM());
    }

    /** In the frame of the page, whose z points down it. */
    Point forecast(Way way, double timeS) {
      Displacement moved = way.between(from.timeS(), timeS);
      double cos = Math.cos(from.headingRad());
      double sin = Math.sin(from.headingRad());
      double xM = from.xM() + moved.alongM() * cos - moved.acrossM() * sin;
      double yM = from.yM() + moved.alongM() * sin + moved.acrossM() * cos;
      return new Point(xM, -yM);
    }
  }

  private TrackPlan(MotionRun run, MotionChain before, MotionChain after) {
    this.run = run;
    this.before = Way.of(run, before);
    this.after = Way.of(run, after);
  }

  /**
   * Draws one.
   *
   * @param runs of a log
   * @param before how the robot was believed to move
   * @param after how it moves as diagnosed
   * @return empty where no track is known for so long
   */
  static Optional<PagePicture> of(List<MotionRun> runs, MotionChain before, MotionChain after) {
    TrackPlan chosen = null;
    List<Forecast> worst = List.of();
    double most = 0;
    for (MotionRun run : runs) {
      TrackPlan plan = new TrackPlan(run, before, after);
      List<Forecast> all = plan.forecasts();
      int size = Math.min(FORECASTS, all.size());
      for (int i = 0; size > 0 && i + size <= all.size(); i++) {
        List<Forecast> stretch = all.subList(i, i + size);
        double error = error(stretch, plan.before);
        if (isUnbroken(stretch) && error > most) {
          most = error;
          worst = stretch;
          chosen = plan;
        }
      }
    }
    return chosen == null ? Optional.empty() : Optional.of(chosen.picture(worst));
  }

  private static double error(List<Forecast> stretch, Way way) {
    return stretch.stream().mapToDouble(one -> one.errorM(way)).average().orElse(0);
  }

  private static boolean isUnbroken(List<Forecast> stretch) {
    return last(stretch).timeS() - stretch.get(0).from.timeS()
        < stretch.size() * (AHEAD_S + NEAR_S);
  }

  private static TrackPose last(List<Forecast> stretch) {
    return stretch.get(stretch.size() - 1).to;
  }

  /** One after the other, from where the track is known to where it is known again. */
  private List<Forecast> forecasts() {
    List<Forecast> all = new ArrayList<>();
    List<TrackPose> track = run.track();
    for (int i = 0, j = 0; i < track.size(); i = Math.max(i + 1, j)) {
      double endS = track.get(i).timeS() + AHEAD_S;
      for (j = Math.max(i, j); j < track.size() && track.get(j).timeS() < endS; j++) {}
      if (j < track.size() && track.get(j).timeS() < endS + NEAR_S) {
        all.add(new Forecast(track.get(i), track.get(j)));
      }
    }
    return all;
  }

  private PagePicture picture(List<Forecast> stretch) {
    double fromS = stretch.get(0).from.timeS();
    double toS = last(stretch).timeS();
    List<Point> seen =
        run.track().stream()
            .filter(pose -> pose.timeS() >= fromS && pose.timeS() <= toS)
            .map(pose -> new Point(pose.xM(), -pose.yM()))
            .toList();
    List<Point> all = new ArrayList<>(seen);
    stretch.forEach(one -> all.addAll(line(one, before)));
    stretch.forEach(one -> all.addAll(line(one, after)));
    GroundPlan plan = GroundPlan.around("A stretch of the track, and what was forecast of it", all);
    plan.svg().path(plan.path(seen), "seen", "the track");
    stretch.forEach(one -> plan.svg().path(plan.path(line(one, before)), "told", tip(one, before)));
    stretch.forEach(one -> plan.svg().path(plan.path(line(one, after)), "moves", tip(one, after)));
    stretch.forEach(
        one -> plan.svg().circle(plan.spot(one.forecast(after, one.from.timeS())), 3, "dot", ""));
    return new PagePicture(
        "where the forecasts were farthest off",
        plan.svg().html(),
        Html.of(
            Html.key("ink"),
            " track, from ",
            Numbers.fixed(fromS, 1),
            " to ",
            Numbers.fixed(toS, 1),
            " s of run ",
            run.name(),
            "; forecasts of 5 s from each dot: ",
            Html.key("before"),
            " as believed, ",
            Html.key("after"),
            " as diagnosed. After 5 s they are off by ",
            centimetres(error(stretch, before)),
            " and ",
            centimetres(error(stretch, after)),
            " on average."),
        Html.NONE);
  }

  private static String tip(Forecast one, Way way) {
    return "from "
        + Numbers.fixed(one.from.timeS(), 1)
        + " s: off by "
        + centimetres(one.errorM(way));
  }

  private static String centimetres(double metres) {
    return Numbers.fixed(100 * metres, 1) + "\u00a0cm";
  }

  private static List<Point> line(Forecast one, Way way) {
    List<Point> line = new ArrayList<>();
    for (double t = one.from.timeS(); t < one.to.timeS(); t += DRAWN_S) {
      line.add(one.forecast(way, t));
    }
    line.add(one.forecast(way, one.to.timeS()));
    return line;
  }
}
