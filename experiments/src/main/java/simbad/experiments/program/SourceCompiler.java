package simbad.experiments.program;

import com.sun.j3d.utils.geometry.Cylinder;
import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.OutputStream;
import java.net.URI;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.CodeSource;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.media.j3d.Transform3D;
import javax.tools.Diagnostic;
import javax.tools.DiagnosticCollector;
import javax.tools.FileObject;
import javax.tools.ForwardingJavaFileManager;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileManager;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;
import javax.tools.ToolProvider;
import javax.vecmath.Vector3d;
import simbad.sim.Agent;
import simbad.sonar.format.DataFormatException;

/** Compiles a folder of sources into memory, each file in the encoding that it is written in. */
final class SourceCompiler {
  private static final String ENDING = ".java";
  private static final Pattern PACKAGE = Pattern.compile("(?m)^\\s*package\\s+([\\w.]+)\\s*;");

  private SourceCompiler() {}

  /** What came of compiling: class files by the classes' names, or errors by file and line. */
  private record Compiled(Map<String, byte[]> bytes, List<String> errors) {}

  /**
   * Compiles all sources below a folder, less those of classes that this Simbad has. Where the rest
   * needs what its own Simbad has and this one has not, all is compiled.
   *
   * @param folder of the program
   * @param more folders of sources that it needs
   * @param libraries jars and folders of classes that it needs
   * @param errors is told each error, by file and line
   * @return class files by the classes' names, perhaps with classes that this Simbad has
   * @throws DataFormatException with the first error, if they do not compile
   */
  static Map<String, byte[]> compile(
      Path folder, List<Path> more, List<Path> libraries, Consumer<String> errors)
      throws DataFormatException, IOException {
    List<Source> all = sources(folder);
    for (Path other : more) {
      all.addAll(sources(other));
    }
    List<Source> without = new ArrayList<>(all);
    without.removeIf(source -> ProgramClasses.isSimbads(source.className()));
    if (without.isEmpty()) {
      throw DataFormatException.inFile(folder, "has neither classes nor Java sources");
    }
    Compiled compiled = compile(without, libraries);
    if (compiled.errors.isEmpty()) {
      return compiled.bytes;
    }
    int own = all.size() - without.size();
    Compiled withOwn = own == 0 ? compiled : compile(all, libraries);
    if (withOwn.errors.isEmpty()) {
      return withOwn.bytes;
    }
    compiled.errors.forEach(errors);
    String instead = own == 0 ? "" : " with this Simbad in place of its own " + own + " classes";
    throw DataFormatException.inFile(
        folder,
        "does not compile"
            + instead
            + ": "
            + compiled.errors.size()
            + " errors, the first: "
            + compiled.errors.get(0));
  }

  private static Compiled compile(List<Source> sources, List<Path> libraries) throws IOException {
    JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
    if (compiler == null) {
      throw new IOException("sources need a JDK; this Java has no compiler");
    }
    DiagnosticCollector<JavaFileObject> said = new DiagnosticCollector<>();
    Memory memory = new Memory(compiler.getStandardFileManager(said, Locale.ROOT, null));
    List<String> options =
        List.of("-nowarn", "-proc:none", "-g", "-cp", classPath(libraries), "-Xmaxerrs", "1000");
    boolean done = compiler.getTask(null, memory, said, options, null, sources).call();
    List<String> errors = errors(said);
    return new Compiled(
        memory.bytes(), done || !errors.isEmpty() ? errors : List.of("the compiler failed"));
  }

  private static String classPath(List<Path> libraries) {
    List<String> entries = new ArrayList<>();
    libraries.forEach(library -> entries.add(library.toString()));
    // Where the classes are that programs ask for, however they were loaded.
    for (Class<?> asked : List.of(Agent.class, Vector3d.class, Transform3D.class, Cylinder.class)) {
      CodeSource source = asked.getProtectionDomain().getCodeSource();
      if (source != null) {
        entries.add(Path.of(URI.create(source.getLocation().toString())).toString());
      }
    }
    entries.add(System.getProperty("java.class.path"));
    return String.join(File.pathSeparator, entries);
  }

  /** Returns the names of the classes among a folder's sources that this Simbad has. */
  static List<String> simbads(Path folder) throws IOException {
    return sources(folder).stream()
        .map(Source::className)
        .filter(ProgramClasses::isSimbads)
        .toList();
  }

  private static List<Source> sources(Path folder) throws IOException {
    List<Source> sources = new ArrayList<>();
    try (Stream<Path> files = Files.walk(folder)) {
      for (Path file : files.filter(SourceCompiler::isSource).sorted().toList()) {
        sources.add(new Source(file, text(Files.readAllBytes(file))));
      }
    }
    return sources;
  }

  private static boolean isSource(Path file) {
    String name = file.getFileName().toString();
    return name.endsWith(ENDING) && !name.equals("module-info.java") && Files.isRegularFile(file);
  }

  /** UTF-16 says so in its first bytes; what is no UTF-8 is ISO-8859-1, as every byte is. */
  static String text(byte[] bytes) {
    int mark = bytes.length < 2 ? 0 : 256 * (bytes[0] & 0xff) + (bytes[1] & 0xff);
    if (mark == 0xfeff || mark == 0xfffe) {
      return new String(bytes, StandardCharsets.UTF_16);
    }
    for (Charset charset : List.of(StandardCharsets.UTF_8, StandardCharsets.ISO_8859_1)) {
      try {
        String text = charset.newDecoder().decode(ByteBuffer.wrap(bytes)).toString();
        return text.startsWith("\uFEFF") ? text.substring(1) : text;
      } catch (CharacterCodingException e) {
        // The next one takes every byte.
      }
    }
    throw new IllegalStateException("ISO-8859-1 decodes every byte");
  }

  private static List<String> errors(DiagnosticCollector<JavaFileObject> said) {
    return said.getDiagnostics().stream()
        .filter(d -> d.getKind() == Diagnostic.Kind.ERROR)
        .map(SourceCompiler::line)
        .distinct()
        .toList();
  }

  private static String line(Diagnostic<? extends JavaFileObject> error) {
    String message = error.getMessage(Locale.ROOT).replaceAll("\\s*\\n\\s*", "; ");
    JavaFileObject source = error.getSource();
    String place = source instanceof Source file ? file.file + ":" + error.getLineNumber() : "";
    return place + ": " + message;
  }

  private static final class Source extends SimpleJavaFileObject {
    private final Path file;
    private final String text;

    Source(Path file, String text) {
      super(file.toUri(), Kind.SOURCE);
      this.file = file;
      this.text = text;
    }

    String className() {
      String name = file.getFileName().toString();
      Matcher declared = PACKAGE.matcher(text);
      String simple = name.substring(0, name.length() - ENDING.length());
      return declared.find() ? declared.group(1) + "." + simple : simple;
    }

    @Override
    public CharSequence getCharContent(boolean ignoreEncodingErrors) {
      return text;
    }
  }

  private static final class Memory extends ForwardingJavaFileManager<JavaFileManager> {
    private final Map<String, ByteArrayOutputStream> classes = new HashMap<>();

    Memory(JavaFileManager next) {
      super(next);
    }

    Map<String, byte[]> bytes() {
      return classes.entrySet().stream()
          .collect(Collectors.toMap(Map.Entry::getKey, entry -> entry.getValue().toByteArray()));
    }

    @Override
    public JavaFileObject getJavaFileForOutput(
        Location location, String name, JavaFileObject.Kind kind, FileObject sibling) {
      return new SimpleJavaFileObject(URI.create("memory:///" + name), kind) {
        @Override
        public OutputStream openOutputStream() {
          ByteArrayOutputStream bytes = new ByteArrayOutputStream();
          classes.put(name, bytes);
          return bytes;
        }
      };
    }
  }
}
