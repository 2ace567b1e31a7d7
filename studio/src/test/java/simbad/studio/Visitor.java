package simbad.studio;

import com.deque.html.axecore.selenium.AxeBuilder;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.InputStream;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Objects;
import simbad.figures.page.Browser;
import simbad.figures.page.DevTools;

/** Somebody with mouse and keyboard before a page in headless Chromium (DevTools protocol). */
public final class Visitor implements AutoCloseable {
  private static final ObjectMapper MAPPER = new ObjectMapper();

  private final DevTools tools;

  private Visitor(DevTools tools) {
    this.tools = tools;
  }

  public static boolean isThere() {
    return Browser.isThere();
  }

  public static Visitor at(String page, Path folder) throws Exception {
    return new Visitor(DevTools.before(URI.create(page), folder));
  }

  private void ask(String method, String parameters) throws Exception {
    tools.ask(method, (ObjectNode) MAPPER.readTree(parameters));
  }

  /** The window's size in pixels, and the theme. */
  public void resize(int width, int height, boolean dark) throws Exception {
    ask(
        "Emulation.setDeviceMetricsOverride",
        "{\"width\":%d,\"height\":%d,\"deviceScaleFactor\":1,\"mobile\":false}"
            .formatted(width, height));
    ask(
        "Emulation.setEmulatedMedia",
        "{\"features\":[{\"name\":\"prefers-color-scheme\",\"value\":\"%s\"}]}"
            .formatted(dark ? "dark" : "light"));
  }

  /** As somebody whose computer is set to less motion. */
  public void lessMotion() throws Exception {
    ask(
        "Emulation.setEmulatedMedia",
        "{\"features\":[{\"name\":\"prefers-reduced-motion\",\"value\":\"reduce\"}]}");
  }

  /** Presses and lets go a key: a character, or an arrow with Windows' number of it. */
  public void press(String key, int code) throws Exception {
    String text = key.length() == 1 ? ",\"text\":\"" + key + "\"" : "";
    String rest = "\"key\":\"%s\",\"windowsVirtualKeyCode\":%d%s}".formatted(key, code, text);
    ask("Input.dispatchKeyEvent", "{\"type\":\"keyDown\"," + rest);
    ask("Input.dispatchKeyEvent", "{\"type\":\"keyUp\"," + rest);
  }

  /** Clicks the middle of what a selector finds. */
  public void click(String selector) throws Exception {
    look("document.querySelector('" + selector + "').scrollIntoView({block: 'center'})");
    JsonNode at =
        MAPPER.readTree(
            look(
                "{const b = document.querySelector('"
                    + selector
                    + "').getBoundingClientRect();"
                    + " JSON.stringify([b.x + b.width / 2, b.y + b.height / 2])}"));
    drag(at.get(0).asDouble(), at.get(1).asDouble(), 0, 0);
  }

  /** Presses at a place of the window, goes some pixels, lets go. */
  public void drag(double x, double y, double byX, double byY) throws Exception {
    mouse("mouseMoved", x, y);
    mouse("mousePressed", x, y);
    if (byX != 0 || byY != 0) {
      mouse("mouseMoved", x + byX / 2, y + byY / 2);
      mouse("mouseMoved", x + byX, y + byY);
    }
    mouse("mouseReleased", x + byX, y + byY);
  }

  public void mouse(String type, double x, double y) throws Exception {
    String button = type.equals("mouseMoved") ? "none" : "left";
    ask(
        "Input.dispatchMouseEvent",
        "{\"type\":\"%s\",\"x\":%s,\"y\":%s,\"button\":\"%s\",\"clickCount\":1}"
            .formatted(type, x, y, button));
  }

  /** What an expression is on the page, as text; a promise is awaited. */
  public String look(String expression) throws Exception {
    return tools.look(expression);
  }

  /** Waits until an expression is true; what it never became is said. */
  public void await(String expression) throws Exception {
    tools.await(expression);
  }

  /** What axe-core, an accessibility checker, finds wrong. */
  public String violations() throws Exception {
    try (InputStream in =
        Objects.requireNonNull(AxeBuilder.class.getResourceAsStream("/axe.min.js"))) {
      look(new String(in.readAllBytes(), StandardCharsets.UTF_8) + ";1");
    }
    return look(
        "axe.run().then(r => JSON.stringify(r.violations.map(v => v.id + ' ' + v.nodes.map(n => n.html))))");
  }

  /** The window as a picture in PNG. */
  public byte[] picture() throws Exception {
    return tools.picture();
  }

  @Override
  public void close() {
    tools.close();
  }
}
