package simbad.studio.folders;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.file.Path;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.TextFile;

/** JSON files that are handed on as they are. */
final class JsonText {
  static final ObjectMapper MAPPER = new ObjectMapper();

  private JsonText() {}

  /**
   * Reads a file.
   *
   * @throws DataFormatException if it cannot be read, or is no JSON object
   */
  static JsonNode read(Path file) throws DataFormatException {
    String text = TextFile.read(file);
    try {
      JsonNode node = MAPPER.readTree(text);
      if (node.isObject()) {
        return node;
      }
    } catch (JsonProcessingException e) {
      throw DataFormatException.inFile(file, "is not JSON: " + e.getOriginalMessage());
    }
    throw DataFormatException.inFile(file, "is not a JSON object");
  }
}
