package simbad.experiments.bag;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import org.sqlite.SQLiteConfig;

/** Reads a recording in SQLite, as rosbag2 made it at first: tables topics and messages. */
final class SqliteBag {
  static final byte[] MAGIC = "SQLite format 3".getBytes(StandardCharsets.US_ASCII);

  private static final String QUERY =
      "SELECT topics.name, topics.type, topics.serialization_format, messages.timestamp,"
          + " messages.data FROM messages JOIN topics ON messages.topic_id = topics.id"
          + " ORDER BY messages.timestamp, messages.id";

  private SqliteBag() {}

  /**
   * Reads all messages in CDR, in order of time.
   *
   * @param file which is not written to
   * @param sink takes them
   * @throws IOException if it is no such file, or broken
   */
  static void read(Path file, BagMessage.Sink sink) throws IOException {
    SQLiteConfig config = new SQLiteConfig();
    config.setReadOnly(true);
    try (Connection connection = config.createConnection("jdbc:sqlite:" + file.toAbsolutePath());
        Statement statement = connection.createStatement();
        ResultSet rows = statement.executeQuery(QUERY)) {
      while (rows.next()) {
        byte[] data = rows.getBytes(5);
        if (data != null && "cdr".equals(rows.getString(3))) {
          sink.take(
              new BagMessage(
                  String.valueOf(rows.getString(1)),
                  String.valueOf(rows.getString(2)),
                  rows.getLong(4),
                  ByteBuffer.wrap(data)));
        }
      }
    } catch (SQLException e) {
      throw new IOException("is not a recording in SQLite: " + e.getMessage(), e);
    }
  }
}
