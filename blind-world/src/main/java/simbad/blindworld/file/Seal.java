package simbad.blindworld.file;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;

/** Salted commitments to truths, and one root over all of them. */
public final class Seal {

  private static final HexFormat HEX = HexFormat.of();

  private Seal() {}

  /** SHA-256 of the bytes, as 64 hexadecimal digits. */
  public static String sha256(byte[] bytes) {
    try {
      return HEX.formatHex(MessageDigest.getInstance("SHA-256").digest(bytes));
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every Java has SHA-256", e);
    }
  }

  /** The commitment to a truth: SHA-256 of the salt's bytes followed by the truth's. */
  public static String commitment(byte[] salt, byte[] truth) {
    byte[] both = new byte[salt.length + truth.length];
    System.arraycopy(salt, 0, both, 0, salt.length);
    System.arraycopy(truth, 0, both, salt.length, truth.length);
    return sha256(both);
  }

  /**
   * The root of a binary tree of SHA-256 over the leaves in order; a leaf without partner is paired
   * with itself.
   */
  public static String root(List<String> leaves) {
    List<String> level = new ArrayList<>(leaves);
    while (level.size() > 1) {
      List<String> above = new ArrayList<>();
      for (int i = 0; i < level.size(); i += 2) {
        String right = level.get(Math.min(i + 1, level.size() - 1));
        above.add(sha256((level.get(i) + right).getBytes(StandardCharsets.US_ASCII)));
      }
      level = above;
    }
    return level.isEmpty() ? sha256(new byte[0]) : level.get(0);
  }

  /** The bytes as hexadecimal digits. */
  public static String hex(byte[] bytes) {
    return HEX.formatHex(bytes);
  }

  /** The bytes of hexadecimal digits. */
  public static byte[] bytes(String hex) throws FormatException {
    try {
      return HEX.parseHex(hex.strip());
    } catch (IllegalArgumentException e) {
      throw new FormatException("salt: '" + hex.strip() + "', expected hexadecimal digits");
    }
  }
}
