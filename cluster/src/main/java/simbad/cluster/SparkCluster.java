package simbad.cluster;

import java.io.IOException;
import org.apache.spark.SparkConf;
import org.apache.spark.api.java.JavaSparkContext;
import simbad.experiments.workers.Cluster;
import simbad.experiments.workers.Workers;

/**
 * The workers of a Spark master, a standalone cluster's ({@code spark://HOST:PORT}) or threads of
 * this process ({@code local[N]}).
 *
 * <p>The program's jars are sent to the workers, which need nothing but Spark and the same Java.
 * System properties {@code spark.*} go to Spark as they are.
 */
public final class SparkCluster implements Cluster {
  @Override
  public Workers connect(String master) throws IOException {
    MasterAddress.requireAnswer(master);
    ShippedCode code = ShippedCode.ofThisProgram();
    SparkConf conf =
        new SparkConf()
            .setMaster(master)
            .setAppName("simbad")
            .setJars(code.jars().toArray(String[]::new))
            .setIfMissing("spark.executor.extraClassPath", code.onThisMachine())
            // What is under way is limited by the waves.
            .setIfMissing("spark.driver.maxResultSize", "0")
            .setIfMissing("spark.ui.enabled", "false");
    try {
      return new SparkWorkers(new JavaSparkContext(conf));
    } catch (Exception e) { // Scala throws checked ones without saying so.
      throw new IOException("--spark " + master + ": " + e.getMessage(), e);
    }
  }
}
