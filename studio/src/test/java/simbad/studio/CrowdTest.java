package simbad.studio;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse.BodyHandlers;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import simbad.experiments.run.SensorKind;

/**
 * 200 clients that hang, send half a request, garbage, or message after message: the page goes on
 * serving, and the world that is looked at is the one that it is without them. {@code
 * -Dcrowd.messages=1000000} sends a million.
 */
class CrowdTest {
  private static final int CLIENTS = 200;
  private static final long MESSAGES = Long.getLong("crowd.messages", 20_000);
  private static final int STEPS_EACH = 50;

  private static final String SCENE =
      """
      {"format": "simbad-studio/1", "obstacle": "angle", "sensor": "noisy", "robots": 3,
        "speed_m_per_s": 0.1, "seed": 7, "moves": []}""";

  private final HttpClient client = HttpClient.newHttpClient();
  private final Choices choices = new Choices(List.of(SensorKind.NOISY), List.of());

  private static String question(int from, int count) {
    return "{\"scene\": %s, \"from\": %d, \"count\": %d}".formatted(SCENE, from, count);
  }

  private String ask(Studio studio, String path, Optional<String> body) throws Exception {
    URI page = URI.create(studio.url());
    URI address = URI.create("http://localhost:" + page.getPort() + path + "?" + page.getQuery());
    HttpRequest.Builder request = HttpRequest.newBuilder(address);
    body.ifPresent(text -> request.POST(BodyPublishers.ofString(text)));
    var answer = client.send(request.build(), BodyHandlers.ofString());
    assertEquals(200, answer.statusCode(), path);
    return answer.body();
  }

  @Test
  @Timeout(600)
  void itServesAndStepsOn_amongAHostileCrowd() throws Exception {
    InetSocketAddress address = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);
    try (Studio studio = Studio.open(address, choices, Optional.empty())) {
      List<Long> waitedNs = new ArrayList<>();
      StringBuilder seen = new StringBuilder();
      int step = 0;
      try (Crowd crowd = new Crowd(URI.create(studio.url()).getPort(), CLIENTS, MESSAGES)) {
        while ((crowd.talks() && step < LiveWorld.MOST_STEPS) || step < 10 * STEPS_EACH) {
          long begin = System.nanoTime();
          assertTrue(ask(studio, "/", Optional.empty()).contains("<canvas"));
          waitedNs.add(System.nanoTime() - begin);
          seen.append(ask(studio, "/frames", Optional.of(question(step, STEPS_EACH))));
          step += STEPS_EACH;
        }
        assertTrue(crowd.sent() >= MESSAGES, "sent " + crowd.sent());
      }
      Worlds alone = new Worlds(choices);
      StringBuilder expected = new StringBuilder();
      for (int from = 0; from < step; from += STEPS_EACH) {
        expected.append(alone.frames(question(from, STEPS_EACH)));
      }
      assertEquals(expected.toString(), seen.toString());
      Collections.sort(waitedNs);
      System.out.printf(
          "reach: %d clients, %d messages; the page came %d times, in %.0f ms (median), %.0f ms at most%n",
          CLIENTS,
          MESSAGES,
          waitedNs.size(),
          waitedNs.get(waitedNs.size() / 2) / 1e6,
          waitedNs.get(waitedNs.size() - 1) / 1e6);
    }
  }
}
