package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * What a wrong argument comes to: one line that names the argument, what was typed and what was
 * expected.
 */
class WrongArgumentTest {
  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "batch HERE/nope --out x | batch: SPEC: HERE/nope: no such file",
        "batch HERE --out x | batch: SPEC: HERE: is a folder, expected a file",
        "batch-plot HERE --along x --out x.png | batch-plot: DIR: HERE/results.csv: no such file",
        "board --sensor-file HERE | board: --sensor-file: HERE: is a folder, expected a file",
        "bench resume HERE/a.txt | bench resume: DIR: HERE/a.txt/journal.txt: no such file",
        "dataset mend HERE/nope --scale 2 --out HERE/x | dataset mend: SET: HERE/nope: no such"
            + " folder",
        "blind-check --foreign HERE/nope --out HERE/x | blind-check: --foreign: HERE/nope: no such"
            + " folder",
        "diagnose HERE --out HERE/x | diagnose: DATASET: HERE/scene.json: no such file",
        "diagnose HERE/a.txt --out HERE/x | diagnose: DATASET: HERE/a.txt: is not a folder,"
            + " expected one with scene.json and readings.csv",
        "program HERE/a.txt | program: PROGRAM: HERE/a.txt: is not a jar",
        "dataset bag HERE/a.txt --list | dataset bag: BAG: HERE/a.txt: is neither MCAP nor SQLite",
        "predict HERE/nope x --out HERE/x | predict: DIAGNOSIS_DIR: HERE/nope/scene.json: no such"
            + " file",
        "run angle --sensor diagnosed:HERE | run: --sensor: HERE/scene.json: no such file",
        "run angle --robot HERE/nope | run: --robot: HERE/nope: no such file",
        "run angle --out HERE/a.txt | run: --out: HERE/a.txt: exists already",
        "sensor show HERE/nope | sensor show: FILE: HERE/nope: no such file",
        "studio --scene HERE/nope | studio: --scene: HERE/nope: no such file",
        "table compare angle HERE/nope | table compare: B: HERE/nope: no such file"
      })
  void path_thatIsNoFile_isNamedWithItsArgument(String arguments, String line) throws IOException {
    checkOneLine(arguments, line);
  }

  /** Editors find a place by file and line, so what is wrong inside begins with them. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "run HERE/a.txt | run: HERE/a.txt:1: bearing_deg: column is missing; found hello"
            + " (columns are separated by commas)",
        "dataset csv HERE/a.txt --range a --out HERE/x | dataset csv: HERE/a.txt: has no rows"
      })
  void fault_insideAFile_beginsWithTheFile(String arguments, String line) throws IOException {
    checkOneLine(arguments, line);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "batch HERE/a.txt --spark nope --out HERE/x | batch: --spark: 'nope' is not"
            + " spark://HOST:PORT or local[N] (see simbad batch --help)",
        "blind-check --spark local[1] --cases 0 --out HERE/x | blind-check: --cases: 0 is not in"
            + " [1, 100000] (see simbad blind-check --help)",
        "bench capture --auto --obstacle angle --out x --step 0 | bench capture: --step: 0.0 is"
            + " not in (0, 1] (see simbad bench capture --help)",
        "table predict angle --humidity 101 | table predict: --humidity: 101.0 is not in [0.0,"
            + " 100.0] (see simbad table predict --help)",
        "table import HERE/a.txt --unit ell | table import: Invalid value for option '--unit':"
            + " 'ell' is not one of m, cm, mm, in (see simbad table import --help)",
        "table import HERE/a.txt --provenance guess | table import: Invalid value for option"
            + " '--provenance': 'guess' is not one of measured, captured, reconstructed, predicted"
            + " (see simbad table import --help)",
        "effects rain | effects: EFFECT: 'rain' is not the name of an effect; simbad effects lists"
            + " them; did you mean gain? (see simbad effects --help)",
        "program HERE --compat upstream,1.5 | program: --compat: '1.5' is no switch;"
            + " docs/compatibility.md lists them (see simbad program --help)",
        "diagnose HERE --out HERE/x --corrected HERE | diagnose: --corrected: HERE is a folder,"
            + " expected a file (see simbad diagnose --help)",
        "diagnose HERE --out HERE/x --withhold rain | diagnose: --withhold: 'rain' is not the"
            + " name of an effect; simbad effects lists them; did you mean gain? (see simbad"
            + " diagnose --help)"
      })
  void word_orNumber_isNamedWithItsOption(String arguments, String line) throws IOException {
    checkOneLine(arguments, line);
  }

  /** Nobody shall think that an option counted which nothing read. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "dataset csv HERE/log.csv --range 2 --distance 1 --time-unit nope --out HERE/x | dataset"
            + " csv: --time-unit: 'nope' changes nothing here; expected it only with what it"
            + " belongs to (see the help)",
        "dataset csv HERE/log.csv --range 2 --distance 1 --angle-zero up --out HERE/x | dataset"
            + " csv: --angle-zero: 'up' changes nothing here; expected it only with what it"
            + " belongs to (see the help)",
        "dataset motion csv HERE/drive.csv --wheel-base x --out HERE/x | dataset motion csv:"
            + " --wheel-base: 'x' changes nothing here; expected it only with what it belongs to"
            + " (see the help)",
        "dataset bag HERE --list --time-unit s | dataset bag: --list: expected no other option"
            + " beside it (see simbad dataset bag --help)",
        "demo --list --robot HERE/nope | demo: --list: expected nothing beside it (see simbad demo"
            + " --help)",
        "program HERE --pictures HERE/x | program: --pictures: 'HERE/x' needs --picture every:N"
            + " (see simbad program --help)",
        "program HERE --window --steps 5 | program: --window: expected only --compat, --seed,"
            + " --main and --class-path beside it (see simbad program --help)",
        "bench capture --port HERE/nope --sensor ray --obstacle angle --out HERE/x | bench"
            + " capture: --sensor: 'ray' is for the simulated sensor; expected --auto with it (see"
            + " simbad bench capture --help)",
        "bench measure HERE/a.txt --port HERE/nope --seed 3 --out HERE/x | bench measure: --seed:"
            + " 3 is for the simulated sensor; expected --auto with it (see simbad bench measure"
            + " --help)",
        "export c99 angle --obstacle a --out HERE/x.h | export c99: --obstacle: 'a' is for the"
            + " folder of a diagnosis, whose scene has labels; angle is none (see simbad export"
            + " c99 --help)"
      })
  void option_thatNothingReads_isRefused(String arguments, String line) throws IOException {
    checkOneLine(arguments, line);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "dataset csv HERE/log.csv --range 2 --distance 1 --time n0 --out HERE/x | dataset csv:"
            + " HERE/log.csv:1: n0: column is missing; found 1 true_cm (10, 20), 2 read_cm (9.8,"
            + " 19.7) (--time)",
        "table import HERE/log.csv --bearing n0 --out HERE/x.csv | table import: HERE/log.csv:1:"
            + " n0: column is missing; found true_cm, read_cm (--bearing)"
      })
  void column_thatIsMissing_isNamedWithItsOption(String arguments, String line) throws IOException {
    checkOneLine(arguments, line);
  }

  private void checkOneLine(String arguments, String line) throws IOException {
    Files.writeString(folder.resolve("a.txt"), "hello\n");
    Files.writeString(folder.resolve("log.csv"), "true_cm,read_cm\n10,9.8\n20,19.7\n");
    Files.writeString(
        folder.resolve("drive.csv"), "t_s,v,w,x_m,y_m,heading_deg\n0,0,0,0,0,0\n1,0,0,0,0,0\n");
    Shell shell = Shell.simbad(arguments.replace("HERE", folder.toString()).split(" "));
    assertEquals(
        List.of("simbad " + line.replace("HERE", folder.toString())),
        shell.complaints(),
        shell.err());
    assertEquals(2, shell.status());
  }
}
