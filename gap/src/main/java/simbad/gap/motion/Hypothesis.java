package simbad.gap.motion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import simbad.motion.MotionChain;
import simbad.motion.effect.MotionForm;

/**
 * Forms with values.
 *
 * @param base what is believed already
 * @param forms that act after it
 * @param values of all forms' parameters, in their order
 */
@SuppressWarnings("ArrayRecordComponent") // Numbers by window, never compared.
record Hypothesis(MotionChain base, List<MotionForm> forms, double[] values) {
  MotionChain chain() {
    MotionChain chain = base;
    int at = 0;
    for (MotionForm form : forms) {
      int n = form.parameters().size();
      chain = chain.with(form.change(Arrays.copyOfRange(values, at, at + n)));
      at += n;
    }
    return chain;
  }

  double[] values(MotionForm form) {
    int at = 0;
    for (MotionForm one : forms) {
      if (one.equals(form)) {
        return Arrays.copyOfRange(values, at, at + one.parameters().size());
      }
      at += one.parameters().size();
    }
    throw new IllegalArgumentException(form.form() + " is not among the forms");
  }

  Hypothesis with(MotionForm form, double[] start) {
    List<MotionForm> longer = new ArrayList<>(forms);
    longer.add(form);
    double[] all = Arrays.copyOf(values, values.length + start.length);
    System.arraycopy(start, 0, all, values.length, start.length);
    return new Hypothesis(base, longer, all);
  }

  Hypothesis without(MotionForm form) {
    List<MotionForm> shorter = new ArrayList<>();
    double[] left = new double[values.length - form.parameters().size()];
    int at = 0;
    for (MotionForm one : forms) {
      if (!one.equals(form)) {
        double[] own = values(one);
        System.arraycopy(own, 0, left, at, own.length);
        at += own.length;
        shorter.add(one);
      }
    }
    return new Hypothesis(base, shorter, left);
  }

  Hypothesis withValues(double[] other) {
    return new Hypothesis(base, forms, other);
  }

  boolean names(String effect) {
    return forms.stream().anyMatch(form -> form.effect().equals(effect));
  }
}
