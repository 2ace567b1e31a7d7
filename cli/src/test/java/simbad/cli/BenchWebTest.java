package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import simbad.bench.board.BoardKit;

/** {@code --web}: the board's program in gpsim, its capture followed live in the studio. */
@Timeout(600)
class BenchWebTest {
  private static final ObjectMapper MAPPER = new ObjectMapper();
  private static final int BEARINGS = 3;

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  private static URI page(SimbadProcess capture) throws Exception {
    while (capture.process().isAlive()) {
      String out = Files.readString(capture.out());
      if (out.startsWith("page: ") && out.contains("\n")) {
        return URI.create(out.lines().findFirst().orElseThrow().substring("page: ".length()));
      }
      Thread.sleep(20);
    }
    throw new AssertionError(Files.readString(capture.err()));
  }

  /** What is told until the capture ends. */
  private static List<JsonNode> told(URI page) throws Exception {
    URI watch = URI.create("http://localhost:" + page.getPort() + "/watch?" + page.getQuery());
    HttpRequest request = HttpRequest.newBuilder(watch).build();
    List<JsonNode> states = new ArrayList<>();
    try (BufferedReader lines =
        new BufferedReader(
            new InputStreamReader(
                HttpClient.newHttpClient().send(request, BodyHandlers.ofInputStream()).body(),
                StandardCharsets.UTF_8))) {
      for (String line = lines.readLine(); line != null; line = lines.readLine()) {
        if (line.startsWith("data: {")) {
          states.add(MAPPER.readTree(line.substring("data: ".length())));
        }
      }
    }
    return states;
  }

  @Test
  void captureOfTheBoard_isFollowedLive() throws Exception {
    BoardKit kit = BoardKit.ofProject(Path.of(".."));
    assumeTrue(
        kit.missingPackages().isEmpty(),
        () -> "no simulated board here: missing " + kit.missingPackages());
    String words =
        "bench capture --auto --obstacle angle --bearings "
            + BEARINGS
            + " --pings 3 --web 0 --out ";
    SimbadProcess capture =
        SimbadProcess.start(folder, "", (words + folder.resolve("sweep")).split(" ", -1));
    List<JsonNode> states = told(page(capture));
    assertEquals(0, capture.process().waitFor(), () -> "complaints in " + capture.err());
    List<Integer> pings = states.stream().map(state -> state.path("pings").asInt()).toList();
    assertEquals(pings.stream().sorted().toList(), pings);
    assertTrue(pings.stream().distinct().count() > 2, pings.toString());
    assertTrue(
        states.stream().anyMatch(state -> state.path("reading_cm").asText().matches("[0-9.]+")));
    assertTrue(states.stream().anyMatch(state -> state.path("points").size() > 0));
  }
}
