package simbad.studio.web;

import jakarta.servlet.http.HttpServletRequest;
import java.net.InetSocketAddress;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.eclipse.jetty.ee10.servlet.ServletContextRequest;
import org.eclipse.jetty.io.Connection;
import org.eclipse.jetty.server.Connector;
import org.eclipse.jetty.server.HttpConfiguration;
import org.eclipse.jetty.server.HttpConnectionFactory;
import org.eclipse.jetty.server.Server;
import org.eclipse.jetty.server.ServerConnector;
import org.eclipse.jetty.util.thread.ScheduledExecutorScheduler;
import org.eclipse.jetty.util.thread.Scheduler;

/**
 * The open connections of a server: a number of them at most, each for one request and a short
 * time. Requests that never end, or whose answers are never read, cannot keep others out: a
 * newcomer takes the place of the eldest that has not shown that it may ask, and there is a thread
 * for each.
 */
final class Connections implements Connection.Listener {
  // More than anybody opens in the moment that a question takes to arrive: the newcomers push out
  // who waits.
  private static final int MOST = 512;
  // What accepts, selects and waits in reserve.
  private static final int THREADS_OF_THE_SERVER = 8;

  /** As many threads as the server needs when each connection keeps one busy. */
  static final int MOST_THREADS = MOST + THREADS_OF_THE_SERVER;

  private static final long LIFE_S = 10;

  /** Who may ask waits as long as the longest answer takes: a folder of many rows. */
  private static final long LIFE_OF_A_GUEST_S = 120;

  // A browser sends less than a thousand; long addresses are nobody's.
  private static final int MOST_HEADER_BYTES = 4096;

  private final Map<Connection, Scheduler.Task> ends = new LinkedHashMap<>();
  private final Scheduler scheduler = new ScheduledExecutorScheduler("page", true);

  /** Returns what listens at an address for a server. */
  Connector at(InetSocketAddress address, Server server) {
    HttpConfiguration http = new HttpConfiguration();
    http.setSendServerVersion(false);
    http.setPersistentConnectionsEnabled(false);
    http.setRequestHeaderSize(MOST_HEADER_BYTES);
    HttpConnectionFactory factory = new HttpConnectionFactory(http);
    ServerConnector connector = new ServerConnector(server, null, scheduler, null, 1, 1, factory);
    connector.setHost(address.getAddress().getHostAddress());
    connector.setPort(address.getPort());
    connector.setIdleTimeout(TimeUnit.SECONDS.toMillis(LIFE_OF_A_GUEST_S));
    connector.addBean(this);
    return connector;
  }

  @Override
  public synchronized void onOpened(Connection connection) {
    if (ends.size() >= MOST) {
      end(ends.keySet().iterator().next());
    }
    ends.put(connection, scheduler.schedule(() -> end(connection), LIFE_S, TimeUnit.SECONDS));
  }

  /** A request showed that it may ask: no newcomer takes its place, and it has more time. */
  void welcome(HttpServletRequest request) {
    Connection connection = of(request);
    forget(connection);
    Scheduler.Task end =
        scheduler.schedule(
            () -> connection.getEndPoint().close(), LIFE_OF_A_GUEST_S, TimeUnit.SECONDS);
    // Closed meanwhile or soon: then there is nothing to end.
    connection.addEventListener(
        new Connection.Listener() {
          @Override
          public void onClosed(Connection closed) {
            end.cancel();
          }
        });
  }

  /** Returns the connection by which a request came. */
  static Connection of(HttpServletRequest request) {
    return ServletContextRequest.getServletContextRequest(request)
        .getConnectionMetaData()
        .getConnection();
  }

  @Override
  public void onClosed(Connection connection) {
    forget(connection);
  }

  private void end(Connection connection) {
    forget(connection);
    connection.getEndPoint().close();
  }

  private synchronized void forget(Connection connection) {
    Scheduler.Task end = ends.remove(connection);
    if (end != null) {
      end.cancel();
    }
  }
}
