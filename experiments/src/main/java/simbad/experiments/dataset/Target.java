package simbad.experiments.dataset;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleType;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.OutlineFile;
import simbad.sonar.format.TableFile;
import simbad.sonar.frame.Placement;
import simbad.sonar.scene.Detection;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.TableDetection;
import simbad.sonar.scene.UniformDetection;
import simbad.sonar.scene.VerticalExtent;
import simbad.sonar.shape.Outline;
import simbad.sonar.shape.ThresholdTable;

/**
 * What a sensor looked at, as a person says it: {@code board:1.2m}, {@code board:1.2m x 0.4m},
 * {@code round:30mm}, {@code square:25mm}, a type of the catalogue, an outline's file; with
 * {@code @X,Z,TURN} behind it where it does not stand at the origin.
 *
 * @param name of the obstacle
 * @param place where it stands
 * @param outline its cross-section
 * @param heightM from bottom to top; empty for no end
 */
record Target(String name, Placement place, Outline outline, Optional<Double> heightM) {
  private static final String OPTION = "target";
  private static final String FORMS =
      "board:1.2m, board:1.2m x 0.4m, round:30mm, square:25mm, an outline's file, ";
  private static final double LARGEST_M = 100;
  private static final double SMALLEST_M = 1e-4;

  /** Reads one. */
  static Target of(String text) throws DataFormatException {
    int at = text.lastIndexOf('@');
    Placement place = at < 0 ? Placement.IDENTITY : place(OPTION, text.substring(at + 1));
    String shape = (at < 0 ? text : text.substring(0, at)).strip();
    int colon = shape.indexOf(':');
    String word = (colon < 0 ? shape : shape.substring(0, colon)).toLowerCase(Locale.ROOT);
    if (colon > 0
        && List.of("board", "wall", "plate", "round", "cylinder", "pole", "ball", "square", "box")
            .contains(word)) {
      return sized(word, place, shape.substring(colon + 1));
    }
    Optional<ObstacleType> known = Catalogue.findAny(word.equals("cylinder") ? "round" : shape);
    if (known.isPresent()) {
      return new Target(shape, place, known.get().outline(), Optional.empty());
    }
    Optional<Path> alone = LogSettings.findFile(shape);
    Optional<Path> file = alone.isPresent() ? alone : LogSettings.findFile(shape + "/outline.csv");
    if (file.isPresent()) {
      Outline outline = Outline.joined(OutlineFile.read(file.get()).parts());
      return new Target(stem(Path.of(shape)), place, outline, Optional.empty());
    }
    throw LogSettings.fault(
        OPTION, "'" + text + "' is none of " + FORMS + String.join(", ", names()));
  }

  /** Returns an obstacle of a scene as one. */
  static Target of(Obstacle obstacle) {
    return new Target(
        obstacle.name(), obstacle.worldFromObstacle(), obstacle.outline(), Optional.empty());
  }

  static List<String> names() throws DataFormatException {
    return Catalogue.all().stream().map(ObstacleType::name).toList();
  }

  private static String stem(Path file) {
    return String.valueOf(file.getFileName()).replaceFirst("\\.[^.]*$", "");
  }

  private static Target sized(String word, Placement place, String sizes)
      throws DataFormatException {
    String[] parts = sizes.split("x", 2);
    double sizeM = size(parts[0]);
    Optional<Double> height = parts.length > 1 ? Optional.of(size(parts[1])) : Optional.empty();
    Outline outline =
        switch (word) {
          case "board", "wall", "plate" -> Shapes.board(sizeM);
          case "square", "box" -> Shapes.square(sizeM);
          default -> Shapes.round(sizeM / 2);
        };
    return new Target(word, place, outline, height);
  }

  private static double size(String text) throws DataFormatException {
    double sizeM = LogSettings.measure(OPTION, text, Unit.Kind.LENGTH);
    if (!(sizeM >= SMALLEST_M && sizeM <= LARGEST_M)) {
      throw LogSettings.fault(
          OPTION, "'" + text.strip() + "' is not in [" + SMALLEST_M + ", " + LARGEST_M + "] m");
    }
    return sizeM;
  }

  /**
   * Reads where something stands: X,Z,TURN, metres and degrees where no unit is said; what is left
   * out at the end is 0.
   */
  static Placement place(String option, String text) throws DataFormatException {
    String[] parts = text.split(",", -1);
    if (parts.length > 3) {
      throw LogSettings.fault(option, "'" + text + "' is not X,Z,TURN, such as 10cm,0,90deg");
    }
    double[] values = new double[3];
    for (int i = 0; i < parts.length; i++) {
      String part = parts[i].strip();
      Optional<LogNumber> plain = LogNumber.find(part, false);
      Unit.Kind kind = i < 2 ? Unit.Kind.LENGTH : Unit.Kind.ANGLE;
      values[i] =
          plain.isPresent() && plain.get().unit().isEmpty()
              ? plain.get().value()
              : LogSettings.measure(option, part, kind);
      if (Math.abs(values[i]) > 1e5) {
        throw LogSettings.fault(option, "'" + part + "' is too far");
      }
    }
    return new Placement(values[0], values[1], Math.toRadians(values[2]));
  }

  /** How far from its centre its face lies, towards the sensor of a ladder. */
  double frontM() {
    return Shapes.frontM(outline);
  }

  /** Its extent, with its middle at a height. */
  VerticalExtent extent(double middleM) {
    return heightM
        .map(height -> new VerticalExtent(middleM - height / 2, middleM + height / 2))
        .orElse(VerticalExtent.ENDLESS);
  }

  /** It as an obstacle. */
  Obstacle obstacle(Detection detection, double mountHeightM) {
    return new Obstacle(name, place, outline, detection, extent(mountHeightM));
  }

  /**
   * Reads at which distances it is lost: {@code uniform:2.5m}, the name of a type whose table it
   * shall have, or a table's file.
   */
  static Detection detection(String text) throws DataFormatException {
    String option = "detection";
    if (text.startsWith("uniform:")) {
      double rangeM =
          LogSettings.measure(option, text.substring("uniform:".length()), Unit.Kind.LENGTH);
      if (!ThresholdTable.isThreshold(rangeM)) {
        throw LogSettings.fault(
            option, "'" + text + "' is not in [0, " + ThresholdTable.GREATEST_THRESHOLD_M + "] m");
      }
      return new UniformDetection(rangeM);
    }
    Optional<ObstacleType> known = Catalogue.findAny(text);
    if (known.isPresent()) {
      return new TableDetection(known.get().thresholds().table());
    }
    Optional<Path> file = LogSettings.findFile(text);
    if (file.isPresent()) {
      return new TableDetection(TableFile.read(file.get()).table());
    }
    throw LogSettings.fault(
        option,
        "'" + text + "' is none of uniform:2.5m, a table's file, " + String.join(", ", names()));
  }
}
