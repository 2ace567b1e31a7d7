package simbad.experiments.program;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.util.Optional;

/**
 * Loads a program's classes and those of its libraries anew, rewritten for a run; what they do not
 * have, this program has.
 */
final class ProgramLoader extends URLClassLoader {
  private final ProgramClasses classes;
  private final ClassRewriter rewriter;

  ProgramLoader(ProgramClasses classes, boolean headless) {
    super(classes.places().toArray(URL[]::new), ProgramLoader.class.getClassLoader());
    this.classes = classes;
    rewriter = new ClassRewriter(this::bytes, headless);
  }

  private Optional<byte[]> bytes(String name) {
    byte[] own = classes.bytes().get(name);
    URL url = own == null ? findResource(name.replace('.', '/') + ".class") : null;
    if (url == null) {
      return Optional.ofNullable(own);
    }
    try (InputStream in = url.openStream()) {
      return Optional.of(in.readAllBytes());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
    synchronized (getClassLoadingLock(name)) {
      // The program's own come first, whatever else has a class of that name.
      if (!classes.bytes().containsKey(name)) {
        return super.loadClass(name, resolve);
      }
      Class<?> loaded = findLoadedClass(name);
      return loaded != null ? loaded : findClass(name);
    }
  }

  @Override
  protected Class<?> findClass(String name) throws ClassNotFoundException {
    byte[] bytes = bytes(name).orElseThrow(() -> new ClassNotFoundException(name));
    byte[] rewritten = rewriter.rewrite(bytes);
    return defineClass(name, rewritten, 0, rewritten.length);
  }
}
