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
        "diagnose HERE --out HERE/x | diagnose: DATASET: HERE/scene.json: no such file",
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
        "bench capture --auto --obstacle angle --out x --step 0 | bench capture: --step: 0.0 is"
            + " not in (0, 1] (see simbad bench capture --help)",
        "table predict angle --humidity 101 | table predict: --humidity: 101.0 is not in [0.0,"
            + " 100.0] (see simbad table predict --help)",
        "table import HERE/a.txt --unit ell | table import: Invalid value for option '--unit':"
            + " 'ell' is not one of m, cm, mm, in (see simbad table import --help)",
        "table import HERE/a.txt --provenance guess | table import: Invalid value for option"
            + " '--provenance': 'guess' is not one of measured, captured, reconstructed, predicted"
            + " (see simbad table import --help)",
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

  private void checkOneLine(String arguments, String line) throws IOException {
    Files.writeString(folder.resolve("a.txt"), "hello\n");
    Shell shell = Shell.simbad(arguments.replace("HERE", folder.toString()).split(" "));
    assertEquals(
        List.of("simbad " + line.replace("HERE", folder.toString())),
        shell.complaints(),
        shell.err());
    assertEquals(2, shell.status());
  }
}
