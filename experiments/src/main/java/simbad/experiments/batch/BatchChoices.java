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
record BatchChoices<T>(long size, LongFunction<T> maker) {
  static <T> BatchChoices<T> of(List<T> values) {
    List<T> copy = List.copyOf(values);
    return new BatchChoices<>(copy.size(), number -> copy.get(Math.toIntExact(number)));
  }

  /** Those of one after those of the other; the size must fit 64 bits. */
  BatchChoices<T> then(BatchChoices<T> others) {
    return new BatchChoices<>(
        Math.addExact(size, others.size),
        number -> number < size ? maker.apply(number) : others.maker.apply(number - size));
  }

  T at(long number) {
    return maker.apply(number);
  }
}
