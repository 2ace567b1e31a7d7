package simbad.blindworld.score;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import simbad.blindworld.file.Csv;
import simbad.blindworld.file.FormatException;
import simbad.blindworld.file.JsonObject;

/**
 * Finds the numbers that a truth and an answer state in the same sense. Which ones they are stands
 * in parameters.csv: a truth's forms are this program's own, and many have no counterpart.
 */
final class ParameterHits {

  private static final List<Sense> SENSES = senses();

  private ParameterHits() {}

  /**
   * One number in two words.
   *
   * @param effect its name
   * @param form of the truth
   * @param own what the truth calls it
   * @param said what an answer calls it
   * @param times the truth's number times this is the answer's, where they have other units
   * @param power of the truth's number: -1 where the answer states its inverse
   */
  private record Sense(
      String effect, String form, String own, String said, double times, double power) {
    double value(double ofTruth) {
      return times * StrictMath.pow(ofTruth, power);
    }
  }

  private static List<Sense> senses() {
    try (InputStream in =
        Objects.requireNonNull(ParameterHits.class.getResourceAsStream("parameters.csv"))) {
      String text = new String(in.readAllBytes(), StandardCharsets.UTF_8);
      Csv csv = Csv.parse("parameters.csv", text);
      List<Sense> senses = new ArrayList<>();
      for (int i = 0; i < csv.size(); i++) {
        senses.add(
            new Sense(
                csv.text(i, csv.column("effect")),
                csv.text(i, csv.column("form")),
                csv.text(i, csv.column("truth")),
                csv.text(i, csv.column("answer")),
                csv.number(i, csv.column("times")),
                csv.number(i, csv.column("power"))));
      }
      return List.copyOf(senses);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    } catch (FormatException e) {
      throw new IllegalStateException(e);
    }
  }

  /**
   * The numbers of effects that an answer names and that are at work; without an interval of two
   * ends there is none.
   *
   * @param truth the tree of truth.json
   * @param answer the tree of diagnosis.json
   */
  static List<Particulars.Parameter> of(JsonObject truth, JsonObject answer)
      throws FormatException {
    List<String> named = answer.texts("explanation");
    JsonObject atWork = truth.object("effects");
    List<Particulars.Parameter> hits = new ArrayList<>();
    for (JsonObject effect : answer.objects("effects")) {
      String name = effect.text("name");
      if (named.contains(name) && atWork.has(name) && effect.has("parameters")) {
        add(hits, name, atWork.object(name), effect);
      }
    }
    return hits;
  }

  private static void add(
      List<Particulars.Parameter> hits, String name, JsonObject own, JsonObject said)
      throws FormatException {
    String form = own.has("form") ? own.text("form") : "";
    for (Sense sense : SENSES) {
      boolean fits = sense.effect().equals(name) && sense.form().equals(form);
      if (fits && own.has(sense.own()) && said.object("parameters").has(sense.said())) {
        off(said, sense.said(), sense.value(own.number(sense.own())))
            .ifPresent(off -> hits.add(new Particulars.Parameter(name, off)));
      }
    }
  }

  private static Optional<Double> off(JsonObject said, String name, double real)
      throws FormatException {
    if (!said.has("ci95") || !said.object("ci95").has(name)) {
      return Optional.empty();
    }
    JsonObject intervals = said.object("ci95");
    if (intervals.hasNull(name)) {
      return Optional.empty();
    }
    List<Double> ends = intervals.numbers(name);
    double value = said.object("parameters").number(name);
    if (ends.size() != 2 || !(ends.get(0) <= value && value <= ends.get(1))) {
      throw new FormatException(
          intervals.where() + ", " + name + ": " + ends + ", expected two ends about " + value);
    }
    double half = real < value ? value - ends.get(0) : ends.get(1) - value;
    return Optional.of(real == value ? 0 : Math.abs(real - value) / half);
  }
}
