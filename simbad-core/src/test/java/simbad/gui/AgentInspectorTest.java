package simbad.gui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import javax.vecmath.Vector3d;
import org.junit.jupiter.api.Test;
import simbad.sim.Agent;

class AgentInspectorTest {
  @Test
  void text_hasAUnitAtEveryNumber() {
    String shown = AgentInspector.withUnits(new Agent(new Vector3d(), "agent").asString());
    assertTrue(shown.contains("counter:   0 steps"), shown);
    assertTrue(shown.contains("pace:      0.000 steps/s now"), shown);
    assertTrue(shown.contains("           0.000 steps/s on average"), shown);
    assertTrue(shown.lines().noneMatch(line -> line.matches(".*\\d( now| on average)?")), shown);
    assertFalse(shown.contains("steps/s:"), shown);
  }

  /** What a program says of its own agent stays as it is. */
  @Test
  void foreignText_isLeftAlone() {
    String own = "energy: 3\nmy counter: 4";
    assertEquals(own, AgentInspector.withUnits(own));
  }
}
