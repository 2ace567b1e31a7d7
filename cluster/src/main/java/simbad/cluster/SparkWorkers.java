package simbad.cluster;

import java.io.IOException;
import java.io.Serializable;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.stream.LongStream;
import org.apache.spark.api.java.JavaFutureAction;
import org.apache.spark.api.java.JavaSparkContext;
import org.apache.spark.broadcast.Broadcast;
import simbad.experiments.workers.Job;
import simbad.experiments.workers.PieceReceiver;
import simbad.experiments.workers.Workers;

/**
 * Sends pieces to Spark in waves, some of which are under way at the same time, so that nobody
 * waits for a wave's last piece. Spark does a piece again whose worker died, and hands over one
 * result of each.
 */
final class SparkWorkers implements Workers {
  private static final int PIECES_PER_CORE = 8;
  private static final int WAVES = 3;

  private final JavaSparkContext spark;

  SparkWorkers(JavaSparkContext spark) {
    this.spark = spark;
  }

  @Override
  public <R extends Serializable> void run(
      Job<R> job, long from, long to, PieceReceiver<? super R> receiver)
      throws IOException, InterruptedException {
    try {
      runInWaves(job, from, to, receiver);
    } catch (IllegalStateException e) {
      // Spark says so of all that is asked of it once it has given up its master.
      if (spark.sc().isStopped()) {
        throw new IOException("Spark: the connection to the master ended", e);
      }
      throw e;
    }
  }

  private <R extends Serializable> void runInWaves(
      Job<R> job, long from, long to, PieceReceiver<? super R> receiver)
      throws IOException, InterruptedException {
    Broadcast<Job<R>> sent = spark.broadcast(job);
    Deque<JavaFutureAction<List<R>>> waves = new ArrayDeque<>();
    try {
      for (long number = from; number < to || !waves.isEmpty(); ) {
        while (number < to && waves.size() < WAVES) {
          long end = Math.min(to, number + (long) PIECES_PER_CORE * spark.defaultParallelism());
          waves.add(begin(sent, number, end));
          number = end;
        }
        for (R result : results(waves.remove())) {
          receiver.take(result);
        }
      }
    } finally {
      waves.forEach(wave -> wave.cancel(true));
    }
  }

  private <R extends Serializable> JavaFutureAction<List<R>> begin(
      Broadcast<Job<R>> job, long from, long to) {
    List<Long> numbers = new ArrayList<>(LongStream.range(from, to).boxed().toList());
    return spark
        .parallelize(numbers, numbers.size())
        .map(number -> job.value().piece(number))
        .collectAsync();
  }

  private static <R> List<R> results(JavaFutureAction<List<R>> wave)
      throws IOException, InterruptedException {
    try {
      return wave.get();
    } catch (ExecutionException e) {
      throw new IOException("Spark: " + e.getMessage(), e);
    }
  }

  @Override
  public void close() {
    spark.close();
  }
}
