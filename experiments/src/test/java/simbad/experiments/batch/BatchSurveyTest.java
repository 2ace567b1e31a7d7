package simbad.experiments.batch;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simbad.sonar.format.DataFormatException;

class BatchSurveyTest {
  private static final String HEAD =
      "run,obstacle,sensor,controller,controller.angle,speed_m_per_s,seed,status,error,closed,"
          + "mean_abs_cm,max_abs_cm,edge_kept\n";

  @TempDir private Path folder = Path.of("target");

  private BatchSurvey survey(String... rows) throws IOException, DataFormatException {
    Files.writeString(folder.resolve("results.csv"), HEAD + String.join("\n", rows) + "\n");
    return BatchSurvey.read(folder);
  }

  @Test
  void rows_areCountedByObstacleAndSensor() throws Exception {
    BatchSurvey survey =
        survey(
            "0,post,original,e,5,0.1,1,done,,true,100,200,0.1",
            "1,post,shadow,e,5,0.1,1,done,,true,1,4,0.99",
            "2,post,shadow,e,5,0.1,2,done,,true,3,9,0.94",
            "3,post,shadow,e,5,0.1,3,done,,false,,,",
            "4,post,shadow,e,5,0.1,4,failed,no <b>,,,,");
    assertEquals(5, survey.runs());
    assertEquals(3, survey.wrongRuns());
    assertEquals(
        new BatchSurvey.Group(
            "post", "shadow", 4, 1, 1, 1, OptionalDouble.of(2), OptionalDouble.of(9)),
        survey.groups().get(1));
    assertEquals(0, survey.groups().get(0).lost(), "the original sensor follows no edge");
    assertEquals(
        List.of("edge kept: 0.94", "did not complete the round", "failed: no <b>"),
        survey.wrong().stream().map(BatchSurvey.Wrong::what).toList());
    assertEquals("e, angle 5, 0.1 m/s, seed 2", survey.wrong().get(0).settings());
  }

  @Test
  void ofManyWrongRuns_theFirstAreNamedAndAllAreCounted() throws Exception {
    String[] rows = new String[300];
    for (int i = 0; i < rows.length; i++) {
      rows[i] = i + ",post,shadow,e,5,0.1,1,failed,why,,,,";
    }
    BatchSurvey survey = survey(rows);
    assertEquals(300, survey.wrongRuns());
    assertEquals(200, survey.wrong().size());
    assertTrue(survey.groups().get(0).meanCm().isEmpty());
  }

  @Test
  void whatNoBatchWrote_isRefused() {
    assertThrows(
        DataFormatException.class, () -> survey("0,post,shadow,e,5,0.1,1,done,,true,far,200,0.1"));
  }
}
