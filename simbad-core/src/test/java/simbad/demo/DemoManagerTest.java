package simbad.demo;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.event.ActionEvent;
import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JMenu;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class DemoManagerTest {
  /** Stands for a demo of another jar. */
  public static final class ProvidedDemo extends Demo {
    /** Called by the service loader. */
    public ProvidedDemo() {}
  }

  @Test
  void names_findDemos() {
    assertTrue(DemoManager.names().size() >= 11);
    assertEquals("BaseDemo", DemoManager.names().get(0));
    for (String name : DemoManager.names()) {
      assertEquals(name, DemoManager.find(name).orElseThrow().getClass().getSimpleName());
    }
    assertEquals(Optional.empty(), DemoManager.find("NoDemo"));
  }

  @Test
  void find_makesAnotherOneEachTime() {
    assertNotSame(
        DemoManager.find("BaseDemo").orElseThrow(), DemoManager.find("BaseDemo").orElseThrow());
  }

  @Test
  void menu_startsDemos() {
    List<ActionEvent> events = new ArrayList<>();
    JMenu menu = DemoManager.createMenu(events::add);
    assertEquals(DemoManager.names().size(), menu.getItemCount());
    assertEquals("Examples", menu.getText());
    menu.getItem(1).doClick(0);
    assertInstanceOf(SimplestDemo.class, DemoManager.getDemoFromActionEvent(events.get(0)));
    assertNull(DemoManager.getDemoFromActionEvent(new ActionEvent(this, 0, "quit")));
    assertNull(DemoManager.getDemoFromActionEvent(new ActionEvent(this, 0, null)));
  }

  /** As with a jar that is put on the class path. */
  @Test
  void otherJars_provideDemos(@TempDir Path folder) throws IOException {
    Path services = Files.createDirectories(folder.resolve("META-INF/services"));
    Files.writeString(services.resolve(Demo.class.getName()), ProvidedDemo.class.getName());
    Thread thread = Thread.currentThread();
    ClassLoader before = thread.getContextClassLoader();
    try (URLClassLoader jar = new URLClassLoader(new URL[] {folder.toUri().toURL()}, before)) {
      thread.setContextClassLoader(jar);
      assertTrue(DemoManager.names().contains("ProvidedDemo"));
      assertInstanceOf(ProvidedDemo.class, DemoManager.find("ProvidedDemo").orElseThrow());
    } finally {
      thread.setContextClassLoader(before);
    }
  }
}
