package simbad.sonar.level;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import simbad.sonar.check.Checks;

/**
 * What is known of a sensor's level law, as a file states it; all of it may be left out.
 *
 * @param frequencyHz of the carrier; positive
 * @param spreadingExponent of the echo's pressure; at least 0
 * @param absorptionDbPerM one way; at least 0; overrides what temperature and humidity say
 * @param temperatureC of the air
 * @param humidityPercent of the air, relative
 * @param apertureRadiusM of the piston of sender and receiver, metres; positive
 * @param twoWayDb the beam as a curve over degrees off the axis; not beside an aperture
 * @param receiverThresholdDb over the distance in metres
 * @param excessSdDb scatter of the excess; at least 0
 * @param walkM over the excess in decibels, metres
 * @param noiseM over the excess in decibels, metres; nowhere below 0
 * @param pulseLengthS duration of the pulse, seconds; at least 0
 * @param levelDb of a target of 0 dB at 1 m
 */
public record LevelFigures(
    OptionalDouble frequencyHz,
    OptionalDouble spreadingExponent,
    OptionalDouble absorptionDbPerM,
    OptionalDouble temperatureC,
    OptionalDouble humidityPercent,
    OptionalDouble apertureRadiusM,
    Optional<Curve> twoWayDb,
    Optional<Curve> receiverThresholdDb,
    OptionalDouble excessSdDb,
    Optional<Curve> walkM,
    Optional<Curve> noiseM,
    OptionalDouble pulseLengthS,
    OptionalDouble levelDb) {

  /** Nothing is known. */
  public static final LevelFigures NONE =
      new LevelFigures(
          OptionalDouble.empty(),
          OptionalDouble.empty(),
          OptionalDouble.empty(),
          OptionalDouble.empty(),
          OptionalDouble.empty(),
          OptionalDouble.empty(),
          Optional.empty(),
          Optional.empty(),
          OptionalDouble.empty(),
          Optional.empty(),
          Optional.empty(),
          OptionalDouble.empty(),
          OptionalDouble.empty());

  /** Refuses what is no number, and a beam that is stated twice. */
  public LevelFigures {
    Checks.finite("frequencyHz", frequencyHz);
    Checks.finite("spreadingExponent", spreadingExponent);
    Checks.finite("absorptionDbPerM", absorptionDbPerM);
    Checks.finite("temperatureC", temperatureC);
    Checks.finite("humidityPercent", humidityPercent);
    Checks.finite("apertureRadiusM", apertureRadiusM);
    Checks.finite("excessSdDb", excessSdDb);
    Checks.finite("pulseLengthS", pulseLengthS);
    Checks.finite("levelDb", levelDb);
    if (apertureRadiusM.isPresent() && twoWayDb.isPresent()) {
      throw new IllegalArgumentException(
          "apertureRadiusM = " + apertureRadiusM.getAsDouble() + " beside a curve of the beam");
    }
  }

  /** Returns the names, as in files, of what is left out and comes from the defaults. */
  public List<String> missing() {
    List<String> missing = new ArrayList<>();
    note(missing, "frequency_hz", frequencyHz.isPresent());
    note(missing, "spreading_exponent", spreadingExponent.isPresent());
    note(missing, "temperature_c", absorptionDbPerM.isPresent() || temperatureC.isPresent());
    note(missing, "humidity_percent", absorptionDbPerM.isPresent() || humidityPercent.isPresent());
    note(missing, "beam", apertureRadiusM.isPresent() || twoWayDb.isPresent());
    note(missing, "receiver_threshold_db", receiverThresholdDb.isPresent());
    note(missing, "excess_sd_db", excessSdDb.isPresent());
    note(missing, "walk_m", walkM.isPresent());
    note(missing, "noise_m", noiseM.isPresent());
    note(missing, "pulse_length_s", pulseLengthS.isPresent());
    note(missing, "level_db", levelDb.isPresent());
    return List.copyOf(missing);
  }

  private static void note(List<String> missing, String name, boolean present) {
    if (!present) {
      missing.add(name);
    }
  }

  /** Returns the air: what is not stated is that of a room. */
  public Air air() {
    return new Air(
        temperatureC.orElse(Air.ROOM.temperatureC()),
        humidityPercent.orElse(Air.ROOM.humidityPercent()));
  }

  /**
   * Returns the law; what is left out comes from {@link LevelDefaults} and from the sensor's other
   * figures.
   *
   * @param coneHalfAngleRad of the sensor: without a beam, the piston that is 6 dB down there one
   *     way
   * @param rangeNoiseM of the sensor, metres: without a curve of the noise, the noise everywhere
   */
  public LevelLaw law(double coneHalfAngleRad, double rangeNoiseM) {
    double hz = frequencyHz.orElse(LevelDefaults.FREQUENCY_HZ);
    Air air = air();
    double pulseS = pulseLengthS.orElse(LevelDefaults.PULSE_LENGTH_S);
    return new LevelLaw(
        levelDb.orElse(LevelDefaults.LEVEL_DB),
        spreadingExponent.orElse(LevelDefaults.SPREADING_EXPONENT),
        absorptionDbPerM.isPresent() ? absorptionDbPerM.getAsDouble() : air.absorptionDbPerM(hz),
        beam(coneHalfAngleRad, air.wavenumberPerM(hz)),
        receiverThresholdDb.orElse(LevelDefaults.RECEIVER_THRESHOLD_DB),
        excessSdDb.orElse(LevelDefaults.EXCESS_SD_DB),
        walkM.orElse(LevelDefaults.WALK_M),
        noiseM.orElseGet(() -> Curve.constant(rangeNoiseM)),
        air.soundSpeedMPerS() * pulseS / 2);
  }

  private Beam beam(double coneHalfAngleRad, double wavenumberPerM) {
    if (twoWayDb.isPresent()) {
      return new CurveBeam(twoWayDb.get());
    }
    if (apertureRadiusM.isPresent()) {
      return PistonBeam.of(apertureRadiusM.getAsDouble(), wavenumberPerM);
    }
    // No piston is so small that it hears as well behind itself.
    return coneHalfAngleRad < Math.PI / 2
        ? PistonBeam.ofHalfAmplitude(coneHalfAngleRad, wavenumberPerM)
        : Beam.everywhere();
  }
}
