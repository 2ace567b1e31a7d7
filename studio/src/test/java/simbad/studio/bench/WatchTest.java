package simbad.studio.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import simbad.bench.capture.Approach;
import simbad.bench.capture.Entry;
import simbad.bench.capture.Ranging;
import simbad.bench.capture.SweepPlan;
import simbad.bench.capture.SweepState;
import simbad.bench.capture.TriedDistance;
import simbad.bench.protocol.FirmwareMode;
import simbad.bench.protocol.FrameLine;
import simbad.bench.protocol.PingStatus;
import simbad.studio.Studio;

class WatchTest {
  private static final InetSocketAddress LOCAL =
      new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);

  private static LiveState state() {
    return new LiveState("post", SweepPlan.ofBearings(4), new Ranging(20, FirmwareMode.FRAME));
  }

  private static URI watch(Studio studio) {
    URI page = URI.create(studio.url());
    return URI.create("http://localhost:" + page.getPort() + "/watch?" + page.getQuery());
  }

  private static InputStream stream(Studio studio) throws Exception {
    HttpResponse<InputStream> answer =
        HttpClient.newHttpClient()
            .send(
                HttpRequest.newBuilder(watch(studio)).build(),
                HttpResponse.BodyHandlers.ofInputStream());
    assertEquals(200, answer.statusCode());
    String type = answer.headers().firstValue("Content-Type").orElse("");
    assertTrue(type.startsWith("text/event-stream"), type);
    return answer.body();
  }

  /** The data of the next event. */
  private static String next(BufferedReader lines) throws Exception {
    String line = lines.readLine();
    while (line != null && !line.startsWith("data: ")) {
      line = lines.readLine();
    }
    return String.valueOf(line).substring("data: ".length());
  }

  @Test
  void stream_tellsReadingAndThresholds_asTheyCome() throws Exception {
    LiveState live = state();
    SweepState sweep = new SweepState();
    for (int i = 0; i < 20; i++) {
      Entry.Taken taken =
          new Entry.Taken(
              i,
              0,
              new TriedDistance(i < 10 ? 1.0 : 1.02, Approach.OUT),
              i,
              i < 10 ? PingStatus.ECHO : PingStatus.NO_ECHO,
              OptionalInt.of(5800),
              OptionalDouble.empty());
      sweep.take(taken);
      live.take(taken, sweep);
    }
    sweep.take(new Entry.Done(0));
    live.take(new Entry.Done(0), sweep);
    live.read(new FrameLine.Ping(21, PingStatus.ECHO, OptionalInt.of(5828), 70));
    try (Studio studio = Studio.ofCapture(LOCAL, Path.of("none"), live);
        BufferedReader lines =
            new BufferedReader(new InputStreamReader(stream(studio), StandardCharsets.UTF_8))) {
      assertTrue(studio.url().matches("http://localhost:\\d+/\\?token=[0-9a-f]{32}#capture"));
      String json = next(lines);
      assertTrue(json.contains("\"reading_cm\":\"100.0\""), json);
      assertTrue(json.contains("\"points\":[[0.0,1.0"), json);
      assertTrue(json.contains("\"done\":1,\"pings\":20,\"bearing_deg\":90.0"), json);
      live.read(new FrameLine.Ping(22, PingStatus.ECHO, OptionalInt.of(11656), 70));
      assertTrue(next(lines).contains("\"reading_cm\":\"200.0\""));
    }
  }
}
