package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class WebOptionTest {
  @Test
  void portAlone_isThisComputerOnly() {
    assertTrue(WebOption.place("8080").orElseThrow().getAddress().isLoopbackAddress());
    assertEquals(8080, WebOption.place("8080").orElseThrow().getPort());
    assertEquals("192.168.1.5", WebOption.place("192.168.1.5:80").orElseThrow().getHostString());
    assertTrue(WebOption.place("[::1]:80").orElseThrow().getAddress().isLoopbackAddress());
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "x", "70000", "host.example:80", "1.2.3.4", "-1", "80:80:"})
  void anythingElse_isNone(String word) {
    assertTrue(WebOption.place(word).isEmpty());
  }
}
