package simbad.gap.audit;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.DoubleUnaryOperator;
import java.util.function.UnaryOperator;
import simbad.sonar.frame.Pose;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.Reading;
import simbad.sonar.sensing.ReadingRow;

/**
 * A fault that people's logs have, put into one that is right.
 *
 * @param name of the fault
 * @param check that has to find it
 * @param spoil makes the rows wrong
 */
public record PostedFault(String name, AuditCheck check, Spoil spoil) {
  private static final double[] FACTORS = {
    1000, 100, 10, 0.1, 0.01, 39.37, 3.281, 0.3048, 2.54, 0.3937, 2, 0.5, 0.2, 0.7, 0.8, 1.25, 1.5,
    5
  };
  private static final double TIMER_BYTE_S = 256e-6;
  private static final int NOW_AND_THEN = 12;

  /** Makes rows wrong. */
  public interface Spoil {
    /**
     * Returns the rows with the fault.
     *
     * @param rows right ones, in the file's order
     * @param sensor as the scene has it
     * @param random of what comes now and then
     */
    List<ReadingRow> spoil(List<ReadingRow> rows, SonarSpec sensor, SplittableRandom random);
  }

  /** Returns all that is tried. */
  public static List<PostedFault> all() {
    List<PostedFault> all = new ArrayList<>();
    for (double factor : FACTORS) {
      all.add(range("ranges times " + factor, AuditCheck.UNIT, range -> factor * range));
    }
    addCodes(all);
    addMemory(all);
    addPoses(all);
    addTimes(all);
    return List.copyOf(all);
  }

  private static void addCodes(List<PostedFault> all) {
    all.add(code("0 for no echo", sensor -> 0));
    all.add(code("the most for no echo", SonarSpec::maxRangeM));
    all.add(code("7.65 for no echo", sensor -> 7.65));
    all.add(code("38 ms for no echo", sensor -> 0.019 * sensor.assumedSoundSpeedMPerS()));
    all.add(
        new PostedFault(
            "9999999 now and then",
            AuditCheck.RANGE_LIMIT,
            (rows, sensor, random) ->
                each(rows, row -> random.nextInt(NOW_AND_THEN) > 0 ? row : read(row, 9_999_999))));
    all.add(
        new PostedFault(
            "again from 0 beyond half the greatest",
            AuditCheck.WRAP,
            (rows, sensor, random) -> {
              double greatest =
                  rows.stream()
                      .mapToDouble(PostedFault::rangeM)
                      .filter(Double::isFinite)
                      .max()
                      .orElse(1);
              double end = greatest / 2;
              return each(rows, row -> read(row, rangeM(row) % end));
            }));
    all.add(
        new PostedFault(
            "256 us now and then",
            AuditCheck.JUMP,
            (rows, sensor, random) -> {
              double off = TIMER_BYTE_S * sensor.assumedSoundSpeedMPerS() / 2;
              return each(
                  rows,
                  row -> random.nextInt(NOW_AND_THEN) > 0 ? row : read(row, rangeM(row) + off));
            }));
  }

  private static void addMemory(List<PostedFault> all) {
    all.add(new PostedFault("last value for no echo", AuditCheck.HELD, (r, s, x) -> held(r)));
    all.add(new PostedFault("stuck from the middle on", AuditCheck.STUCK, (r, s, x) -> stuck(r)));
    all.add(
        new PostedFault(
            "stuck from the begin",
            AuditCheck.STUCK,
            (rows, sensor, random) -> each(rows, row -> coded(row, 0.73))));
  }

  private static List<ReadingRow> held(List<ReadingRow> rows) {
    List<ReadingRow> sorted = new ArrayList<>(rows);
    sorted.sort(
        Comparator.comparing(ReadingRow::run)
            .thenComparing(ReadingRow::sensor)
            .thenComparingDouble(ReadingRow::timeS));
    for (int i = 1; i < sorted.size(); i++) {
      ReadingRow before = sorted.get(i - 1);
      ReadingRow row = sorted.get(i);
      boolean follows = row.run().equals(before.run()) && row.sensor().equals(before.sensor());
      if (follows && row.reading() instanceof NoEcho) {
        sorted.set(i, with(row, before.reading()));
      }
    }
    return sorted;
  }

  private static List<ReadingRow> stuck(List<ReadingRow> rows) {
    List<ReadingRow> stuck = new ArrayList<>(rows);
    Reading last = NoEcho.NO_ECHO;
    for (int i = 0; i < rows.size(); i++) {
      if (2 * i < rows.size() || last instanceof NoEcho) {
        last = rows.get(i).reading();
      } else {
        stuck.set(i, with(rows.get(i), last));
      }
    }
    return stuck;
  }

  private static void addPoses(List<PostedFault> all) {
    all.add(pose("z up the page", p -> Pose.of(x(p), -z(p), heading(p))));
    all.add(pose("x and z exchanged", p -> Pose.of(z(p), x(p), heading(p))));
    all.add(pose("headings clockwise", p -> Pose.of(x(p), z(p), -heading(p))));
    all.add(pose("headings in radians", p -> Pose.of(x(p), z(p), Math.toRadians(heading(p)))));
    all.add(pose("headings of a compass", p -> Pose.of(x(p), z(p), Math.PI / 2 - heading(p))));
    all.add(pose("positions in centimetres", p -> Pose.of(100 * x(p), 100 * z(p), heading(p))));
    all.add(
        new PostedFault(
            "one pose for all",
            AuditCheck.STILL,
            (rows, sensor, random) -> each(rows, row -> posed(row, rows.get(0).pose()))));
  }

  private static void addTimes(List<PostedFault> all) {
    all.add(
        new PostedFault(
            "times in milliseconds",
            AuditCheck.PERIOD,
            (rows, sensor, random) -> each(rows, row -> timed(row, 1000 * row.timeS()))));
    all.add(
        new PostedFault(
            "the clock begins anew in each run", AuditCheck.CLOCK, (r, s, x) -> begunAnew(r)));
  }

  /** In the middle of each run and sensor. */
  private static List<ReadingRow> begunAnew(List<ReadingRow> rows) {
    return each(
        rows,
        row -> {
          double[] times =
              rows.stream()
                  .filter(one -> one.run().equals(row.run()) && one.sensor().equals(row.sensor()))
                  .mapToDouble(ReadingRow::timeS)
                  .sorted()
                  .toArray();
          double middle = times[times.length / 2];
          return row.timeS() < middle ? row : timed(row, row.timeS() - middle - 1e5);
        });
  }

  private static List<ReadingRow> each(List<ReadingRow> rows, UnaryOperator<ReadingRow> change) {
    return rows.stream().map(change).toList();
  }

  private static PostedFault range(String name, AuditCheck check, DoubleUnaryOperator change) {
    return new PostedFault(
        name,
        check,
        (rows, sensor, random) -> each(rows, row -> read(row, change.applyAsDouble(rangeM(row)))));
  }

  private interface Value {
    double of(SonarSpec sensor);
  }

  private static PostedFault code(String name, Value value) {
    return new PostedFault(
        name,
        AuditCheck.NO_ECHO_CODE,
        (rows, sensor, random) ->
            each(
                rows, row -> row.reading() instanceof NoEcho ? coded(row, value.of(sensor)) : row));
  }

  private static PostedFault pose(String name, UnaryOperator<Pose> change) {
    return new PostedFault(
        name,
        AuditCheck.AXES,
        (rows, sensor, random) -> each(rows, row -> posed(row, change.apply(row.pose()))));
  }

  private static double rangeM(ReadingRow row) {
    return row.reading() instanceof Echo echo ? echo.rangeM() : Double.NaN;
  }

  /** As files have them, with tenths of a millimetre; what was no echo stays none. */
  private static ReadingRow read(ReadingRow row, double range) {
    return row.reading() instanceof NoEcho ? row : coded(row, range);
  }

  private static ReadingRow coded(ReadingRow row, double range) {
    return with(row, new Echo(Math.rint(range * 1e4) / 1e4));
  }

  private static ReadingRow with(ReadingRow row, Reading reading) {
    return new ReadingRow(row.run(), row.sensor(), row.timeS(), row.pose(), reading);
  }

  private static ReadingRow posed(ReadingRow row, Pose pose) {
    return new ReadingRow(row.run(), row.sensor(), row.timeS(), pose, row.reading());
  }

  private static ReadingRow timed(ReadingRow row, double timeS) {
    return new ReadingRow(row.run(), row.sensor(), timeS, row.pose(), row.reading());
  }

  private static double x(Pose pose) {
    return pose.position().xM();
  }

  private static double z(Pose pose) {
    return pose.position().zM();
  }

  private static double heading(Pose pose) {
    return pose.heading().radians();
  }
}
