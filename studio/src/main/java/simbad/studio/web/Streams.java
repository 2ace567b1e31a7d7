package simbad.studio.web;

import io.javalin.http.Context;
import io.javalin.http.sse.SseClient;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashSet;
import java.util.Set;
import java.util.function.Supplier;

/**
 * What pages follow while it goes on, as server-sent events. Each follower has a thread that looks
 * for news now and then and tells what is new; what is followed never waits for a follower. There
 * are so many of them at most: a newcomer takes the eldest's place. Each ends with the time of its
 * connection, and the browser asks again by itself.
 */
final class Streams {
  /** Browsers open one for each page that follows something. */
  static final int MOST = 32;

  /** Nobody reads faster; what changes oftener is told as it is then. */
  private static final long BETWEEN_MS = 200;

  /** Only who writes learns that nobody reads any more. */
  private static final long SIGN_OF_LIFE_MS = 5_000;

  /** How long a browser waits before it asks again. */
  private static final byte[] AGAIN = "retry: 300\n\n".getBytes(StandardCharsets.US_ASCII);

  private final Set<Context> followers = new LinkedHashSet<>();
  private volatile boolean ended;

  /**
   * Tells a follower what is new until it goes or must go.
   *
   * @param context its question, which this answers
   * @param state what it follows, asked for several times a second
   */
  void tell(Context context, Supplier<String> state) {
    enter(context);
    try {
      begin(context);
      goOn(new SseClient(context), state);
    } catch (IOException e) {
      // It has gone.
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      leave(context);
    }
  }

  private static void begin(Context context) throws IOException {
    context.res().setContentType("text/event-stream");
    context.res().setCharacterEncoding("UTF-8");
    context.res().getOutputStream().write(AGAIN);
    context.res().flushBuffer();
  }

  private void goOn(SseClient follower, Supplier<String> state) throws InterruptedException {
    String told = "";
    long quietMs = 0;
    while (!ended && !follower.terminated()) {
      String now = state.get();
      if (!now.equals(told)) {
        follower.sendEvent(now);
        told = now;
        quietMs = 0;
      } else if (quietMs >= SIGN_OF_LIFE_MS) {
        follower.sendComment("here");
        quietMs = 0;
      }
      Thread.sleep(BETWEEN_MS);
      quietMs += BETWEEN_MS;
    }
  }

  private synchronized void enter(Context context) {
    if (followers.size() >= MOST) {
      Context eldest = followers.iterator().next();
      followers.remove(eldest);
      // It may hang in a write that nobody reads.
      Connections.of(eldest.req()).getEndPoint().close();
    }
    followers.add(context);
  }

  private synchronized void leave(Context context) {
    followers.remove(context);
  }

  /** Nobody is told anything any more. */
  void end() {
    ended = true;
  }
}
