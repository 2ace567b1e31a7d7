package simbad.bench.board;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.TextFile;

/**
 * A program in Intel's hexadecimal format, made fit for gpsim 0.31, which reads configuration bytes
 * in whole words only: a record of them that begins or ends in the middle of a word is filled up
 * with FF, at addresses that the chip does not have. Everything else stays as it is.
 */
final class GpsimImage {
  private static final int CONFIGURATION = 0x30;
  private static final int DATA = 0;
  private static final int UPPER_ADDRESS = 4;
  private static final Pattern RECORD = Pattern.compile(":([0-9A-Fa-f]{2}){5,260}");

  private GpsimImage() {}

  static String read(Path hexFile) throws DataFormatException {
    List<String> records = new ArrayList<>();
    int upper = 0;
    int line = 0;
    for (String record : TextFile.read(hexFile).lines().toList()) {
      byte[] bytes = bytes(hexFile, ++line, record);
      if (bytes[3] == UPPER_ADDRESS) {
        upper = word(bytes, 4);
      }
      boolean fill = bytes[3] == DATA && upper == CONFIGURATION;
      records.add(fill ? filled(bytes) : record);
    }
    return String.join("\n", records) + "\n";
  }

  private static byte[] bytes(Path hexFile, int line, String record) throws DataFormatException {
    if (!RECORD.matcher(record).matches()) {
      throw DataFormatException.inField(hexFile, line, "record", "'" + record + "' is none");
    }
    byte[] bytes = HexFormat.of().parseHex(record, 1, record.length());
    int sum = 0;
    for (byte b : bytes) {
      sum += b;
    }
    if ((sum & 0xFF) != 0 || (bytes[0] & 0xFF) != bytes.length - 5) {
      throw DataFormatException.inField(
          hexFile, line, "record", "length or checksum of '" + record + "' do not fit");
    }
    return bytes;
  }

  private static int word(byte[] bytes, int at) {
    return ((bytes[at] & 0xFF) << 8) | (bytes[at + 1] & 0xFF);
  }

  private static String filled(byte[] record) {
    int address = word(record, 1);
    String data = HexFormat.of().formatHex(record, 4, record.length - 1);
    if (address % 2 == 1) {
      data = "FF" + data;
      address--;
    }
    if (data.length() / 2 % 2 == 1) {
      data += "FF";
    }
    String body = String.format(Locale.ROOT, "%02X%04X%02X", data.length() / 2, address, DATA);
    return withChecksum(body + data.toUpperCase(Locale.ROOT));
  }

  private static String withChecksum(String body) {
    int sum = 0;
    for (byte b : HexFormat.of().parseHex(body)) {
      sum += b;
    }
    return ":" + body + String.format(Locale.ROOT, "%02X", -sum & 0xFF);
  }
}
