package simbad.blindworld.world;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Rows in the order of their file, and the tracks that they form. */
public final class Recording {

  private final List<Row> rows;
  private final List<Track> tracks;

  /** A recording of these rows; their order is kept. */
  public Recording(List<Row> rows) {
    this.rows = List.copyOf(rows);
    this.tracks = tracksOf(this.rows);
  }

  private static List<Track> tracksOf(List<Row> rows) {
    Map<List<String>, List<Integer>> byKey = new LinkedHashMap<>();
    for (int i = 0; i < rows.size(); i++) {
      Row row = rows.get(i);
      byKey.computeIfAbsent(List.of(row.run(), row.sensor()), key -> new ArrayList<>()).add(i);
    }
    List<Track> tracks = new ArrayList<>();
    byKey.forEach(
        (key, indices) -> {
          indices.sort(Comparator.comparingDouble(i -> rows.get(i).tS()));
          tracks.add(new Track(key.get(0), key.get(1), indices));
        });
    return List.copyOf(tracks);
  }

  /** The rows, in the order of the file. */
  public List<Row> rows() {
    return rows;
  }

  /** One track for each pair of run and transducer. */
  public List<Track> tracks() {
    return tracks;
  }

  /** How many rows there are. */
  public int size() {
    return rows.size();
  }

  /** The transducers' labels, each once. */
  public List<String> sensors() {
    return tracks.stream().map(Track::sensor).distinct().toList();
  }

  /** Rows of one run at one and the same pose: nothing was moved between them. */
  public List<List<Integer>> placements() {
    Map<List<Object>, List<Integer>> byPlace = new LinkedHashMap<>();
    for (int i = 0; i < rows.size(); i++) {
      Row row = rows.get(i);
      byPlace.computeIfAbsent(List.of(row.run(), row.pose()), key -> new ArrayList<>()).add(i);
    }
    return List.copyOf(byPlace.values());
  }

  /** The time of a row within its run, in seconds. */
  public double tS(int row) {
    return rows.get(row).tS();
  }

  /** The believed pose of a row. */
  public Pose pose(int row) {
    return rows.get(row).pose();
  }

  /** The median time between two pings of one transducer, in seconds; 0 with single pings only. */
  public double periodS() {
    List<Double> steps = new ArrayList<>();
    for (Track track : tracks) {
      for (int k = 1; k < track.rows().size(); k++) {
        steps.add(tS(track.rows().get(k)) - tS(track.rows().get(k - 1)));
      }
    }
    steps.sort(null);
    return steps.isEmpty() ? 0 : steps.get(steps.size() / 2);
  }

  /** The time from a run's first ping to its last, over the longest run, in seconds. */
  public double longestS() {
    return tracks.stream()
        .mapToDouble(
            track -> tS(track.rows().get(track.rows().size() - 1)) - tS(track.rows().get(0)))
        .max()
        .orElse(0);
  }
}
