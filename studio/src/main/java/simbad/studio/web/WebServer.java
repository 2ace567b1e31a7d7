package simbad.studio.web;

import io.javalin.Javalin;
import io.javalin.compression.CompressionStrategy;
import io.javalin.config.JavalinConfig;
import io.javalin.http.BadRequestResponse;
import io.javalin.http.ContentTooLargeResponse;
import io.javalin.http.Context;
import io.javalin.http.ForbiddenResponse;
import io.javalin.http.HandlerType;
import io.javalin.http.Header;
import io.javalin.http.MethodNotAllowedResponse;
import io.javalin.util.JavalinException;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.function.Function;
import java.util.function.Supplier;
import org.eclipse.jetty.util.thread.QueuedThreadPool;

/**
 * A web server that only shows: it answers GET and HEAD and, where it is opened with them,
 * questions of some length, and tells what goes on; nothing that is sent to it changes anything.
 * Who asks needs the token. Requests that never end do not keep others from an answer. It says
 * nothing on the terminal.
 */
public final class WebServer implements AutoCloseable {
  /**
   * The browser runs the scripts and uses the style sheets of this server and no others, asks
   * nobody but it, and shows its pages in no frame.
   */
  private static final String POLICY =
      "default-src 'none'; base-uri 'none'; form-action 'none'; frame-ancestors 'none';"
          + " connect-src 'self'; style-src 'self'; script-src 'self'";

  private static final Set<HandlerType> SHOWING = Set.of(HandlerType.GET, HandlerType.HEAD);
  private static final long MOST_QUESTION_BYTES = 65_536;
  private static final int MOST_TAKEN_IN_BYTES = 1 << 20;
  private static final int FEWEST_THREADS = 2;
  private static final int THREAD_IDLE_MS = 10_000;

  private final Javalin app;
  private final InetAddress address;
  private final Guard guard;
  private final Streams streams;

  private WebServer(Javalin app, InetAddress address, Guard guard, Streams streams) {
    this.app = app;
    this.address = address;
    this.guard = guard;
    this.streams = streams;
  }

  /**
   * What is answered where.
   *
   * @param answers by path, asked for at each request, from any thread
   * @param questions by path: what is sent there by POST, {@value #MOST_QUESTION_BYTES} bytes at
   *     most, is answered, from any thread
   * @param streams by path: what is told there as it goes on, of what the address' {@code path}
   *     names or of nothing in particular; asked for several times a second, from any thread
   */
  public record Answers(
      Map<String, Supplier<Content>> answers,
      Map<String, Function<String, Content>> questions,
      Map<String, Function<String, String>> streams) {
    /** Copies all. */
    public Answers {
      answers = Map.copyOf(answers);
      questions = Map.copyOf(questions);
      streams = Map.copyOf(streams);
    }
  }

  /**
   * Starts to answer.
   *
   * @param address where; port 0 for any that is free
   * @param guard who is answered
   * @param answers what is answered
   * @throws IOException if the address is taken or none of this computer's
   */
  public static WebServer open(InetSocketAddress address, Guard guard, Answers answers)
      throws IOException {
    Connections connections = new Connections();
    Streams streams = new Streams();
    Javalin app =
        Javalin.create(
            config -> {
              listen(config, address, connections);
              config.routes.before(
                  context -> {
                    admit(context, guard, answers.questions().keySet());
                    connections.welcome(context.req());
                  });
              answers.answers().forEach((path, content) -> serve(config, path, content));
              answers.questions().forEach((path, answer) -> ask(config, path, answer));
              answers.streams().forEach((path, news) -> tell(config, path, news, streams));
            });
    try {
      app.start();
    } catch (JavalinException e) {
      app.stop();
      throw new IOException("page at " + address + ": " + reason(e), e);
    }
    return new WebServer(app, address.getAddress(), guard, streams);
  }

  /** What the system said: the libraries wrap it in words of their own. */
  private static String reason(Throwable thrown) {
    Throwable first = thrown;
    while (first.getCause() != null) {
      first = first.getCause();
    }
    return String.valueOf(first.getMessage());
  }

  private static void listen(
      JavalinConfig config, InetSocketAddress address, Connections connections) {
    config.startup.showJavalinBanner = false;
    config.startup.showOldJavalinVersionWarning = false;
    config.startup.startupWatcherEnabled = false;
    config.http.maxRequestSize = MOST_QUESTION_BYTES;
    config.http.compressionStrategy = CompressionStrategy.NONE;
    config.jetty.threadPool = threads();
    config.jetty.addConnector((server, defaults) -> connections.at(address, server));
  }

  /** None keeps the program alive, and none waits for a connection to another one. */
  private static QueuedThreadPool threads() {
    QueuedThreadPool threads =
        new QueuedThreadPool(Connections.MOST_THREADS, FEWEST_THREADS, THREAD_IDLE_MS);
    threads.setName("page");
    threads.setDaemon(true);
    return threads;
  }

  private static void admit(Context context, Guard guard, Set<String> questions) {
    context
        .header(Header.CACHE_CONTROL, "no-store")
        .header(Header.X_CONTENT_TYPE_OPTIONS, "nosniff")
        .header(Header.REFERRER_POLICY, "no-referrer")
        .header(Header.CROSS_ORIGIN_RESOURCE_POLICY, "same-origin")
        .header(Header.CONTENT_SECURITY_POLICY, POLICY);
    boolean tooLong = context.contentLength() > MOST_QUESTION_BYTES;
    if (tooLong) {
      takeIn(context);
    }
    String origin = context.header(Header.ORIGIN);
    if (!guard.admits(context.queryString(), context.header(Header.HOST), origin)) {
      throw new ForbiddenResponse("forbidden");
    }
    boolean asks = context.method().equals(HandlerType.POST) && questions.contains(context.path());
    if (!asks && !SHOWING.contains(context.method())) {
      context.header(Header.ALLOW, "GET, HEAD");
      throw new MethodNotAllowedResponse("only GET");
    }
    if (tooLong) {
      throw new ContentTooLargeResponse();
    }
  }

  /**
   * Reads what is too long to be answered: while it lies unread the connection is reset at its end,
   * and who sent it may never see the answer. What is longer still is cut off.
   */
  private static void takeIn(Context context) {
    context.header("Connection", "close");
    try {
      context.req().getInputStream().readNBytes(MOST_TAKEN_IN_BYTES);
    } catch (IOException e) {
      throw new BadRequestResponse("broken off");
    }
  }

  private static void serve(JavalinConfig config, String path, Supplier<Content> content) {
    config.routes.get(path, context -> answer(context, content.get()));
    config.routes.head(path, context -> answer(context, content.get()));
  }

  private static void ask(JavalinConfig config, String path, Function<String, Content> questioned) {
    config.routes.post(path, context -> answer(context, questioned.apply(context.body())));
  }

  private static void tell(
      JavalinConfig config, String path, Function<String, String> news, Streams streams) {
    config.routes.get(
        path,
        context -> {
          String of = Objects.requireNonNullElse(context.queryParam("path"), "");
          streams.tell(context, () -> news.apply(of));
        });
  }

  private static void answer(Context context, Content content) {
    context.contentType(content.type()).result(content.bytes());
  }

  /** Returns the address, with the token that it asks for. */
  public String url() {
    return "http://" + host() + ":" + app.port() + "/" + guard.query();
  }

  /** Where every address of this computer will do, the nearest one is named. */
  private String host() {
    if (address.isLoopbackAddress() || address.isAnyLocalAddress()) {
      return "localhost";
    }
    String text = address.getHostAddress();
    return text.indexOf(':') < 0 ? text : "[" + text + "]";
  }

  @Override
  public void close() {
    streams.end();
    app.stop();
  }
}
