package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class WebArgumentTest {
  @Test
  void portAlone_isThisComputerOnly() {
    assertTrue(WebArgument.parse("8080").orElseThrow().getAddress().isLoopbackAddress());
    assertEquals(8080, WebArgument.parse("8080").orElseThrow().getPort());
    assertEquals("192.168.1.5", WebArgument.parse("192.168.1.5:80").orElseThrow().getHostString());
    assertTrue(WebArgument.parse("[::1]:80").orElseThrow().getAddress().isLoopbackAddress());
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "x", "70000", "host.example:80", "1.2.3.4", "-1", "80:80:"})
  void anythingElse_isNone(String word) {
    assertTrue(WebArgument.parse(word).isEmpty());
  }
}
