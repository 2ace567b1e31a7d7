package simbad.figures.page;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.net.URI;
import java.nio.file.Path;
import java.util.Map;
import javax.imageio.ImageIO;

/**
 * Somebody at the keyboard before a page in Chromium: keys go the way of real ones (DevTools
 * protocol, Input.dispatchKeyEvent), so that the browser's own doings with them happen as well.
 */
public final class Typist implements AutoCloseable {
  private static final ObjectMapper MAPPER = new ObjectMapper();

  /** Windows' numbers of keys that type nothing. */
  private static final Map<String, Integer> CODES =
      Map.of(
          "Tab",
          9,
          "Enter",
          13,
          "Escape",
          27,
          "End",
          35,
          "Home",
          36,
          "ArrowLeft",
          37,
          "ArrowUp",
          38,
          "ArrowRight",
          39,
          "ArrowDown",
          40);

  private final DevTools tools;

  private Typist(DevTools tools) {
    this.tools = tools;
  }

  /** Opens a page in a browser whose files go to the folder. */
  public static Typist before(URI page, Path folder) throws Exception {
    return new Typist(DevTools.before(page, folder));
  }

  private JsonNode ask(String method, ObjectNode parameters) throws Exception {
    return tools.ask(method, parameters);
  }

  /** Shows another page. */
  public void open(URI page) throws Exception {
    ask("Page.navigate", MAPPER.createObjectNode().put("url", page.toString()));
    await("location.href === '" + page + "' && document.readyState === 'complete'");
  }

  /** Gives the page so many pixels to the right and a theme. */
  public void show(int width, boolean dark) throws Exception {
    resize(width, 800);
    ObjectNode media = MAPPER.createObjectNode().put("media", "");
    media
        .putArray("features")
        .addObject()
        .put("name", "prefers-color-scheme")
        .put("value", dark ? "dark" : "light");
    ask("Emulation.setEmulatedMedia", media);
  }

  /** Makes the page look as it is printed. */
  public void print() throws Exception {
    ask("Emulation.setEmulatedMedia", MAPPER.createObjectNode().put("media", "print"));
  }

  /** Lets scripts run in pages that are opened from now on, or not. */
  public void allowScripts(boolean allowed) throws Exception {
    ask("Emulation.setScriptExecutionDisabled", MAPPER.createObjectNode().put("value", !allowed));
  }

  /** Goes with the mouse to the middle of what a selector finds, which is scrolled into sight. */
  public void pointAt(String selector) throws Exception {
    look("document.querySelector('" + selector + "').scrollIntoView({block: 'center'})");
    ask("Input.dispatchMouseEvent", mouse("mouseMoved", middle(selector)));
  }

  /** Turns the wheel over the middle of what a selector finds. */
  public void wheel(String selector, double delta) throws Exception {
    pointAt(selector);
    double[] at = middle(selector);
    ask("Input.dispatchMouseEvent", mouse("mouseWheel", at).put("deltaX", 0).put("deltaY", delta));
  }

  private double[] middle(String selector) throws Exception {
    String box = "document.querySelector('" + selector + "').getBoundingClientRect()";
    return new double[] {
      Double.parseDouble(look(box + ".x + " + box + ".width / 2")),
      Double.parseDouble(look(box + ".y + " + box + ".height / 2"))
    };
  }

  private static ObjectNode mouse(String type, double... at) {
    return MAPPER.createObjectNode().put("type", type).put("x", at[0]).put("y", at[1]);
  }

  /** What a reader would see amiss on the page: a list in brackets, empty when nothing is. */
  public String faults() throws Exception {
    look(Browser.axe());
    return look(Browser.PROBE);
  }

  /** What is in sight. */
  public BufferedImage picture() throws Exception {
    return ImageIO.read(new ByteArrayInputStream(tools.picture()));
  }

  /** Makes the page as large as that in pixels. */
  public void resize(int width, int height) throws Exception {
    ObjectNode size = MAPPER.createObjectNode().put("width", width).put("height", height);
    ask(
        "Emulation.setDeviceMetricsOverride",
        size.put("deviceScaleFactor", 1).put("mobile", false));
  }

  /** Presses and lets go a key: a character, or one that types nothing. */
  public void press(String key) throws Exception {
    ObjectNode down = MAPPER.createObjectNode().put("type", "keyDown").put("key", key);
    ObjectNode up = MAPPER.createObjectNode().put("type", "keyUp").put("key", key);
    if (CODES.containsKey(key)) {
      down.put("code", key).put("windowsVirtualKeyCode", CODES.get(key));
      up.put("code", key).put("windowsVirtualKeyCode", CODES.get(key));
    }
    if (key.length() == 1 || key.equals("Enter")) {
      down.put("text", key.equals("Enter") ? "\r" : key);
    }
    ask("Input.dispatchKeyEvent", down);
    ask("Input.dispatchKeyEvent", up);
  }

  public void type(String text) throws Exception {
    for (int i = 0; i < text.length(); i++) {
      press(text.substring(i, i + 1));
    }
  }

  /** What an expression is on the page, as text. */
  public String look(String expression) throws Exception {
    return tools.look(expression);
  }

  /** Waits until an expression is true; what it never became is said. */
  public void await(String expression) throws Exception {
    tools.await(expression);
  }

  @Override
  public void close() {
    tools.close();
  }
}
