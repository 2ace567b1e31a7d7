package simbad.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.util.Locale;
import picocli.CommandLine.Command;
import simbad.bench.board.BoardKit;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.Sha256;
import simbad.sonar.format.TextFile;

/** {@code simbad flash-info}: how to program a real board. */
@Command(
    name = "flash-info",
    description = "Say how to program a real board, and check the program's checksum.",
    footer = {"", "Example: simbad flash-info"})
final class FlashInfoCommand extends Subcommand {
  @Override
  protected void run() throws IOException, DataFormatException {
    BoardKit kit = BoardKit.ofProject(ProjectFolder.find());
    String expected = TextFile.read(kit.programChecksum()).split(" ", 2)[0];
    String found = Sha256.hex(Files.readAllBytes(kit.program()));
    if (!found.equals(expected)) {
      throw new IOException(
          kit.program() + ": SHA-256 is " + found + ", expected " + expected + "; do not burn it");
    }
    out()
        .printf(
            Locale.ROOT,
            """
            program     %s
            SHA-256     %s (checked)
            chip        PIC18F4320; the configuration words are in the file: internal oscillator of
                        4 MHz, brown-out reset at 4.5 V, watchdog of half a second, reset pin in use

            wiring      RB3 (36) to the SRF04's trigger, RB4 (37) from its echo line, RD0 to RD7 to
                        eight LEDs, RC6 (25) to and RC7 (26) from a level converter for the serial
                        line, 5 V with 100 nF at the chip

            programmer  any that knows the chip, at MCLR (1), PGC (39, RB6), PGD (40, RB7), 5 V, 0 V;
                        low-voltage programming is off. Nothing else may be tied to RB6 and RB7:
                        the program drives them low.
              PICkit 2  pk2cmd -PPIC18F4320 -F%s -M -Y -R
              PICkit 3, 4, ICD   ipecmd -P18F4320 -TPPK4 -F%s -M -Y -OL
                        or MPLAB X IPE: device PIC18F4320, this file, Program, Verify

            then        19200 baud, 8N1, no handshake; it says
                        I simbad-ranger VERSION BUILD power-on*CHECKSUM
                        and pings four times a second. docs/guide/board.md has the commands.
            """,
            kit.program(),
            found,
            kit.program(),
            kit.program());
  }
}
