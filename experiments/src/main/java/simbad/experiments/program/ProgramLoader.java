package simbad.experiments.program;

import java.net.URL;
import java.net.URLClassLoader;

/** Loads a program's classes anew, rewritten for a run; what it does not have, this program has. */
final class ProgramLoader extends URLClassLoader {
  private final ProgramClasses classes;
  private final boolean headless;

  ProgramLoader(ProgramClasses classes, boolean headless) {
    super(classes.places().toArray(URL[]::new), ProgramLoader.class.getClassLoader());
    this.classes = classes;
    this.headless = headless;
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
    byte[] bytes = classes.bytes().get(name);
    if (bytes == null) {
      return super.findClass(name);
    }
    byte[] rewritten = ClassRewriter.rewrite(bytes, headless);
    return defineClass(name, rewritten, 0, rewritten.length);
  }
}
