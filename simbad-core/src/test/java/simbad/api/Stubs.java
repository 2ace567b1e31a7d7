package simbad.api;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.io.IOException;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;

/**
 * Empty classes with the members of a list of signatures, in place of a jar that this project does
 * not have: what is compiled against them asks for the members that it would ask of that jar.
 */
final class Stubs {
  private static final Pattern PARENT = Pattern.compile(" extends (\\w+)");
  private static final Pattern PARAMETERS = Pattern.compile("\\((.*)\\)");
  private static final String IMPORTS =
      """
      import java.awt.Graphics;
      import java.awt.event.*;
      import java.awt.image.BufferedImage;
      import java.text.DecimalFormat;
      import java.util.ArrayList;
      import javax.media.j3d.*;
      import javax.swing.*;
      import javax.swing.event.MouseInputListener;
      import javax.vecmath.*;
      import simbad.gui.*;
      import simbad.sim.*;
      import simbad.sim.Box;
      """;

  private Stubs() {}

  /** Compiles the stubs of a list, of whose lines nested classes are left out, into a folder. */
  static void compile(List<String> signatures, Path sources, Path classes) throws IOException {
    Map<String, List<String>> byClass = new TreeMap<>();
    for (String line : signatures) {
      Signature signature = Signature.parse(line);
      if (signature.owner().matches("simbad\\.\\w+\\.\\w+")) {
        byClass.computeIfAbsent(signature.owner(), c -> new ArrayList<>()).add(signature.what());
      }
    }
    List<Path> files = new ArrayList<>();
    for (Map.Entry<String, List<String>> type : byClass.entrySet()) {
      Path file = sources.resolve(type.getKey().replace('.', '/') + ".java");
      Files.createDirectories(file.getParent());
      files.add(Files.writeString(file, source(type.getKey(), type.getValue())));
    }
    String messages = compile(files, libraries(), classes);
    assertTrue(messages.isEmpty(), messages);
  }

  /** Compiles files and returns what the compiler complains of; empty when it does not. */
  static String compile(List<Path> files, String classPath, Path classes) throws IOException {
    JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
    StringWriter messages = new StringWriter();
    try (StandardJavaFileManager manager = compiler.getStandardFileManager(null, null, null)) {
      List<String> options =
          List.of("-nowarn", "-proc:none", "-d", classes.toString(), "-cp", classPath);
      var units = manager.getJavaFileObjectsFromPaths(files);
      boolean compiled = compiler.getTask(messages, manager, null, options, null, units).call();
      return compiled ? "" : messages.toString();
    }
  }

  /** The class path without this project's own classes. */
  static String libraries() {
    String all =
        System.getProperty("surefire.test.class.path", System.getProperty("java.class.path"));
    return Arrays.stream(all.split(File.pathSeparator))
        .filter(entry -> !Files.isDirectory(Path.of(entry)))
        .collect(Collectors.joining(File.pathSeparator));
  }

  private static String source(String owner, List<String> members) {
    String simple = owner.substring(owner.lastIndexOf('.') + 1);
    // A class that the list does not describe is one that only its own package could name.
    String head =
        members.stream()
            .filter(m -> m.startsWith("is "))
            .findFirst()
            .map(m -> m.substring("is ".length()))
            .orElse("class");
    Matcher parent = PARENT.matcher(head);
    boolean isStubsChild = parent.find() && !parent.group(1).startsWith("J");
    String begin = isStubsChild ? "super((byte[][][]) null);" : "";
    StringBuilder source = new StringBuilder();
    source.append("package ").append(owner, 0, owner.lastIndexOf('.')).append(";\n");
    source.append(IMPORTS).append(head.replaceFirst("class", "class " + simple)).append(" {\n");
    // By which a child's constructor can begin, whatever its parent's are.
    source.append("  protected " + simple + "(byte[][][] stub) { " + begin + " }\n");
    members.stream()
        .filter(m -> m.startsWith("has "))
        .map(m -> member(simple, m.substring("has ".length()), begin))
        .forEach(source::append);
    return source.append("}\n").toString();
  }

  private static String member(String simple, String signature, String begin) {
    Matcher list = PARAMETERS.matcher(signature);
    if (!list.find()) {
      return "  " + signature + ";\n";
    }
    String[] types = list.group(1).isEmpty() ? new String[0] : list.group(1).split(", ");
    String parameters =
        IntStream.range(0, types.length)
            .mapToObj(i -> types[i] + " p" + i)
            .collect(Collectors.joining(", ", "(", ")"));
    String words = signature.substring(0, list.start());
    if (words.endsWith(" ")) {
      return "  " + words + simple + parameters + " { " + begin + " }\n";
    }
    boolean isAbstract = words.contains(" abstract ");
    return "  "
        + words
        + parameters
        + (isAbstract ? ";\n" : " { throw new UnsupportedOperationException(); }\n");
  }
}
