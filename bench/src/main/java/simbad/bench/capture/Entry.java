package simbad.bench.capture;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import simbad.bench.protocol.PingStatus;
import simbad.sonar.check.Checks;

/** What a journal tells. */
public sealed interface Entry {
  /**
   * How the capture was begun: the first entry.
   *
   * @param settings by name, texts without commas
   */
  record Begun(Map<String, String> settings) implements Entry {
    /** Copies the settings in their order. */
    public Begun {
      settings = new LinkedHashMap<>(settings);
    }
  }

  /**
   * A reading.
   *
   * @param timeS since the epoch, seconds
   * @param bearing index in the plan
   * @param probe where the obstacle stood, and why
   * @param sequence the board's number
   * @param status what became of the ping
   * @param echoUs length of the sensor's pulse
   * @param temperatureC of the air, if known
   */
  record Taken(
      double timeS,
      int bearing,
      TriedDistance probe,
      int sequence,
      PingStatus status,
      OptionalInt echoUs,
      OptionalDouble temperatureC)
      implements Entry {
    /** Checks the time and the temperature. */
    public Taken {
      Checks.finite("timeS", timeS);
      Checks.finite("temperatureC", temperatureC);
    }

    /** Tells whether something answered. */
    public boolean isHeard() {
      return status == PingStatus.ECHO || status == PingStatus.TOO_NEAR;
    }
  }

  /**
   * A bearing is done.
   *
   * @param bearing index in the plan
   */
  record Done(int bearing) implements Entry {}

  /**
   * The last distance of a bearing does not count: the obstacle did not stand there.
   *
   * @param bearing index in the plan
   */
  record Undone(int bearing) implements Entry {}

  /**
   * Nothing of a bearing counts: it is to be taken again.
   *
   * @param bearing index in the plan
   */
  record Repeated(int bearing) implements Entry {}

  /**
   * Something happened that a reader should know.
   *
   * @param timeS since the epoch, seconds
   * @param text for people
   */
  record Note(double timeS, String text) implements Entry {
    /** Checks the time. */
    public Note {
      Checks.finite("timeS", timeS);
    }
  }

  /** Kind and fields of its line. */
  default JournalLine line(long number) {
    if (this instanceof Begun begun) {
      List<String> fields = new ArrayList<>();
      begun.settings().forEach((name, value) -> fields.add(name + "=" + JournalLine.field(value)));
      return new JournalLine(number, "begun", fields);
    } else if (this instanceof Taken taken) {
      return new JournalLine(number, "ping", EntryFields.of(taken));
    } else if (this instanceof Note note) {
      return new JournalLine(
          number,
          "note",
          List.of(EntryFields.seconds(note.timeS()), JournalLine.field(note.text())));
    } else if (this instanceof Done done) {
      return new JournalLine(number, "done", List.of(Integer.toString(done.bearing())));
    } else if (this instanceof Undone undone) {
      return new JournalLine(number, "undone", List.of(Integer.toString(undone.bearing())));
    }
    return new JournalLine(
        number, "repeated", List.of(Integer.toString(((Repeated) this).bearing())));
  }

  /**
   * Reads what a line tells.
   *
   * @param bearings how many the capture has
   * @throws JournalFieldException if it tells what no capture can have written
   */
  static Entry of(JournalLine line, int bearings) throws JournalFieldException {
    return EntryFields.entry(line.kind(), line.fields(), bearings);
  }
}
