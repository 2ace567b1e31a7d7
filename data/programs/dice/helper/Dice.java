package helper;

/** Other people's library, of which the wanderer needs one number. */
public class Dice {
  public static double bias() {
    return 0.05;
  }
}
