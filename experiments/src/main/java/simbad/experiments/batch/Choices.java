package simbad.experiments.batch;

import java.util.List;
import java.util.function.LongFunction;

/**
 * What one dimension of a batch may be, by number; made when it is asked for.
 *
 * @param <T> of the values
 * @param size how many there are
 * @param maker of the value of a number in [0, size)
 */
record Choices<T>(long size, LongFunction<T> maker) {
  static <T> Choices<T> of(List<T> values) {
    List<T> copy = List.copyOf(values);
    return new Choices<>(copy.size(), number -> copy.get(Math.toIntExact(number)));
  }

  /** Those of one after those of the other; the size must fit 64 bits. */
  Choices<T> then(Choices<T> others) {
    return new Choices<>(
        Math.addExact(size, others.size),
        number -> number < size ? maker.apply(number) : others.maker.apply(number - size));
  }

  T at(long number) {
    return maker.apply(number);
  }
}
