package simbad.cli;

import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.OutputStream;

/**
 * Output to a reader that may have read enough, as in {@code simbad ... | head}: that is no
 * failure.
 */
final class PipeOutput extends FilterOutputStream {
  PipeOutput(OutputStream out) {
    super(out);
  }

  @Override
  public void write(int b) throws IOException {
    write(new byte[] {(byte) b}, 0, 1);
  }

  @Override
  public void write(byte[] bytes, int offset, int length) throws IOException {
    try {
      out.write(bytes, offset, length);
    } catch (IOException e) {
      // The JDK has no exception of its own for it.
      if (!"Broken pipe".equals(e.getMessage())) {
        throw e;
      }
    }
  }
}
