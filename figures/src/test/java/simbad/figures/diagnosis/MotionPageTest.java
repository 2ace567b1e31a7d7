package simbad.figures.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.gap.audit.AuditCheck;
import simbad.gap.audit.AuditFinding;
import simbad.gap.audit.Severity;
import simbad.gap.diagnosis.DiagnosisProvenance;
import simbad.gap.diagnosis.Interval;
import simbad.gap.diagnosis.Verdict;
import simbad.gap.motion.MotionDiagnosis;
import simbad.gap.motion.MotionFinding;
import simbad.gap.motion.MotionPlace;
import simbad.motion.Command;
import simbad.motion.MotionChain;
import simbad.motion.MotionRun;
import simbad.motion.Robot;
import simbad.motion.TrackPose;
import simbad.motion.effect.MotionForms;
import simbad.motion.forecast.MotionForecast;
import simbad.motion.format.MotionData;

class MotionPageTest {
  private static final DiagnosisProvenance ORIGIN =
      new DiagnosisProvenance(Map.of(), "1.2 <dirty>", 1);

  private static final AuditFinding AUDITED =
      new AuditFinding(
          AuditCheck.TRACK_HOLES,
          AuditFinding.File.TRACK,
          "two holes",
          List.of(7),
          "",
          "",
          Severity.NOTE);

  /** Half a minute at 0.1 m/s, half as fast as told in its last ten seconds. */
  private static final MotionData DRIVE =
      new MotionData("a<b>", Robot.EXACT_UNICYCLE, List.of(drive()), List.of());

  private static MotionRun drive() {
    return drive(300);
  }

  private static MotionRun drive(int poses) {
    List<TrackPose> track = new ArrayList<>();
    for (int i = 0; i <= poses; i++) {
      double t = i / 10.0;
      track.add(new TrackPose(t, 0.1 * Math.min(t, 20) + 0.05 * Math.max(0, t - 20), 0, 0));
    }
    return new MotionRun("first", List.of(new Command(0, 0.1, 0)), track);
  }

  private static String page(Verdict verdict, List<MotionFinding> findings) {
    double[][] before = {{0.004, 0.001, 0.02}, {0.01, 0.002, 0.03}, {0.02, 0.01, 0.05}};
    double[][] after = {{0.002, 0.001, 0.01}, {0.005, 0.002, 0.02}, {0.01, 0.01, 0.04}};
    double[][] within = {{0.9, 0.91, 0.88}, {0.9, 0.91, 0.88}, {0.9, 0.91, 0.88}};
    MotionDiagnosis diagnosis =
        new MotionDiagnosis(
            verdict,
            "the gap shrinks by 40 %",
            findings,
            List.of(new MotionFinding("dead-band", "", 0.12, List.of(), List.of(), "")),
            0.2,
            Map.of("named", 1.0),
            new MotionDiagnosis.Gap(
                100,
                before,
                after,
                within,
                0.6,
                new Interval(0.55, 0.65),
                new Interval(0.4, 0.9),
                0.3),
            List.of(
                new MotionDiagnosis.Part("speed-scale", 0.4, new Interval(0.35, 0.45)),
                new MotionDiagnosis.Part("rest", 0.3, new Interval(0.2, 0.4))),
            List.of(new MotionPlace("speed_m_s", "", 0, 0.1, 50, 0.3, 1.2, 0.7, "along", 0.002)),
            List.of(new MotionDiagnosis.Hidden("turn-bias", "bias_rad_s", 0.005)),
            Optional.of(
                new MotionDiagnosis.NextDrive(
                    List.of("speed-scale", "wheel-scale"), List.of(new Command(0, 0.1, 0)), 12)),
            List.of(),
            MotionForecast.believed(Robot.EXACT_UNICYCLE));
    return MotionPage.of(DRIVE, List.of(AUDITED), diagnosis, ORIGIN);
  }

  @Test
  void theShrinkage_isOfThisLogAndOfAnotherDrive() {
    String page = page(Verdict.EXPLAINED, List.of());
    assertTrue(page.contains("shrinks by 40"), page);
    assertTrue(page.contains("35&nbsp;% to 45&nbsp;%"), page);
    assertTrue(page.contains("On another drive of this robot it would shrink by 10&nbsp;%"), page);
    assertTrue(page.contains("The verdict is right:"), page);
    assertFalse(page(Verdict.UNDECIDED, List.of()).contains("The verdict is right:"));
  }

  /** Of twelve seconds two forecasts, of three none. */
  @ParameterizedTest
  @CsvSource({"120, 2", "30, 0", "0, 0"})
  void aShortTrack_isDrawnAsFarAsItGoes(int poses, int forecasts) {
    MotionChain told = Robot.EXACT_UNICYCLE.motion();
    MotionChain slow = told.with(MotionForms.find("speed-scale").orElseThrow().change(0.5));
    String drawn =
        TrackPlan.of(List.of(drive(poses)), slow, told)
            .map(picture -> picture.drawing().toString())
            .orElse("");
    assertEquals(forecasts, drawn.split("class=\"told\"", -1).length - 1);
  }

  /** Two of six forecasts are off, by 25 cm each: 8.3 cm on average. */
  @Test
  void theTrack_isDrawnWithItsForecasts() {
    String page = page(Verdict.NONE, List.of());
    assertTrue(page.contains("track, from 0.0 to 30.0 s of run first"), page);
    assertTrue(page.contains("they are off by 8.3&nbsp;cm and 8.3&nbsp;cm on average"), page);
    assertEquals(6, page.split("class=\"told\"", -1).length - 1);
  }

  @Test
  void namesValuesTiesAndGap_areSaid() {
    String page =
        page(
            Verdict.EXPLAINED,
            List.of(
                new MotionFinding(
                    "speed-scale",
                    "speed-scale",
                    0.97,
                    List.of(
                        new MotionFinding.Parameter(
                            "speed_factor",
                            0.95,
                            new Interval(0.94, 0.96),
                            new Interval(0.2, 5),
                            false)),
                    List.of("wheel-scale"),
                    "multiply commanded speeds by 0.95")));

    assertTrue(page.contains("<strong>explained</strong>: the gap shrinks by 40 %."));
    assertTrue(page.contains("speed-scale (97&nbsp;%)"));
    assertTrue(page.contains("0.94 to 0.96"));
    assertTrue(page.contains("cannot tell it from wheel-scale."));
    assertTrue(page.contains("<td class=\"n\">4.00&nbsp;mm</td><td class=\"n\">2.00&nbsp;mm</td>"));
    assertTrue(page.contains("<td>speed 0 to 0.1&nbsp;m/s</td><td>along</td>"));
    assertTrue(page.contains("<td>not explained</td>"));
    assertTrue(page.contains("would tell speed-scale from wheel-scale"));
    assertTrue(page.contains("Perhaps dead-band: 12&nbsp;%"));
    assertTrue(page.contains("track.csv from row 8 on: two holes."));
    assertTrue(page.contains("<td>turn-bias</td>"));
    assertTrue(page.contains("Parts of the gap"));
  }

  @Test
  void whatIsNotOurs_staysText() {
    String page = page(Verdict.NONE, List.of());

    assertTrue(page.contains("a&lt;b&gt;") && page.contains("1.2 &lt;dirty&gt;"));
    assertFalse(page.contains("a<b>"));
    assertTrue(page.contains("No effect is named."));
  }
}
