package simbad.studio.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
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

class LivePageTest {
  private static final InetSocketAddress LOCAL =
      new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);

  private static LiveState state() {
    return new LiveState("post", SweepPlan.ofBearings(4), new Ranging(20, FirmwareMode.FRAME));
  }

  private static HttpResponse<String> get(String method, String url) throws Exception {
    return HttpClient.newHttpClient()
        .send(
            HttpRequest.newBuilder(URI.create(url))
                .method(method, HttpRequest.BodyPublishers.noBody())
                .build(),
            HttpResponse.BodyHandlers.ofString());
  }

  @Test
  void page_showsReadingAndThresholds() throws Exception {
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
    try (LivePage page = LivePage.open(LOCAL, live)) {
      assertTrue(page.url().startsWith("http://localhost:"), page.url());
      HttpResponse<String> html = get("GET", page.url());
      assertEquals(200, html.statusCode());
      assertTrue(html.body().contains("<title>Simbad Sonar: sweep</title>"));
      assertTrue(
          html.headers()
              .firstValue("Content-Security-Policy")
              .orElse("")
              .contains("script-src 'self'"));
      String json = get("GET", page.url() + "state").body();
      assertTrue(json.contains("\"reading_cm\":\"100.0\""), json);
      assertTrue(json.contains("\"points\":[[0.0,1.0"), json);
      assertTrue(json.contains("\"done\":1,\"pings\":20,\"bearing_deg\":90.0"), json);
    }
  }
}
