package simbad.experiments.export;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;

/** A header's whole numbers on a simulated ATmega328P: the sum of readings at places all round. */
final class OnAChip {
  private static final int PLACES = 300;

  private static final String PROGRAM =
      """
      #define NAME_INTEGER_ONLY
      #include <avr/io.h>
      #include <avr/interrupt.h>
      #include <avr/sleep.h>
      #include "sonar.h"
      static void say(char c) {
        while (!(UCSR0A & (1 << UDRE0))) {
        }
        UDR0 = (uint8_t)c;
      }
      int main(void) {
        uint32_t sum = 0;
        int8_t i;
        int16_t k;
        UCSR0B = 1 << TXEN0;
        for (k = 0; k < 300; k++) {
          name_pose at;
          at.x_mm = (int16_t)((k * 37) % 41 * 100 - 2000);
          at.z_mm = (int16_t)((k * 23) % 41 * 100 - 2000);
          at.heading_cdeg = (int16_t)((k * 121L) % 36001 - 18000);
          sum = sum * 31 + (uint32_t)(int32_t)name_read(at);
        }
        for (i = 28; i >= 0; i -= 4) {
          say("0123456789abcdef"[(sum >> i) & 15]);
        }
        say('\\n');
        cli();
        sleep_mode();
        return 0;
      }
      """;

  /** Reads millimetres at x and z in millimetres and a heading in hundredths of a degree. */
  interface Reader {
    int readMm(int xMm, int zMm, int headingCdeg);
  }

  private OnAChip() {}

  /**
   * Compiles a folder's sonar.h for the chip and runs it.
   *
   * @param name that all names in the header begin with
   * @return what the simulator prints
   */
  static String run(Path folder, String name) throws Exception {
    Files.writeString(
        folder.resolve("main.c"),
        PROGRAM.replace("NAME", name.toUpperCase(Locale.ROOT)).replace("name_", name + "_"));
    Compilers.run(
        folder,
        "",
        ("avr-gcc -std=c99 -Os -mmcu=atmega328p -DF_CPU=16000000UL -Wall -Wextra -Werror main.c"
                + " -o main.elf")
            .split(" ", -1));
    List<String> simulator =
        List.of("timeout", "60", "simavr", "-m", "atmega328p", "-f", "16000000", "main.elf");
    return Compilers.run(folder, "", simulator.toArray(String[]::new));
  }

  /** The same sum in Java. */
  static String sum(Reader reader) {
    int sum = 0;
    for (int k = 0; k < PLACES; k++) {
      int x = (k * 37) % 41 * 100 - 2000;
      int z = (k * 23) % 41 * 100 - 2000;
      sum = sum * 31 + reader.readMm(x, z, (k * 121) % 36_001 - 18_000);
    }
    return String.format(Locale.ROOT, "%08x", sum);
  }
}
