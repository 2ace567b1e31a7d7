package simbad.gap.motion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import simbad.motion.MotionChain;
import simbad.motion.MotionChange;
import simbad.motion.effect.FittedMotion;
import simbad.motion.effect.MotionForm;
import simbad.motion.effect.MotionParameter;

/**
 * Forms with values.
 *
 * @param base what is believed already
 * @param forms that act after it
 * @param values of all forms' parameters, in their order
 * @param changes that the forms make with them: one that stays is the very same in what is derived
 */
@SuppressWarnings("ArrayRecordComponent") // Numbers by window, never compared.
record MotionHypothesis(
    MotionChain base, List<MotionForm> forms, double[] values, List<MotionChange> changes) {
  /** Creates one whose changes are made anew. */
  MotionHypothesis(MotionChain base, List<MotionForm> forms, double[] values) {
    this(base, forms, values, changes(forms, values));
  }

  private static List<MotionChange> changes(List<MotionForm> forms, double[] values) {
    List<MotionChange> changes = new ArrayList<>();
    int at = 0;
    for (MotionForm form : forms) {
      int end = at + form.parameters().size();
      changes.add(form.change(Arrays.copyOfRange(values, at, end)));
      at = end;
    }
    return changes;
  }

  MotionChain chain() {
    List<MotionChange> all = new ArrayList<>(base.changes());
    all.addAll(changes);
    return new MotionChain(all);
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

  MotionHypothesis with(MotionForm form, double[] start) {
    List<MotionForm> longer = new ArrayList<>(forms);
    longer.add(form);
    double[] all = Arrays.copyOf(values, values.length + start.length);
    System.arraycopy(start, 0, all, values.length, start.length);
    List<MotionChange> more = new ArrayList<>(changes);
    more.add(form.change(start));
    return new MotionHypothesis(base, longer, all, more);
  }

  MotionHypothesis without(MotionForm form) {
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
    return new MotionHypothesis(base, shorter, left);
  }

  /** Returns the forms, each with its values. */
  List<FittedMotion> fitted() {
    return forms.stream().map(form -> new FittedMotion(form, values(form))).toList();
  }

  /** Returns the parameters of all forms, in the order of the values. */
  List<MotionParameter> parameters() {
    return forms.stream().flatMap(form -> form.parameters().stream()).toList();
  }

  /** Returns the same with one value changed. */
  MotionHypothesis withValue(int index, double value) {
    double[] other = values.clone();
    other[index] = value;
    int end = 0;
    int which = -1;
    while (end <= index) {
      end += forms.get(++which).parameters().size();
    }
    int from = end - forms.get(which).parameters().size();
    List<MotionChange> changed = new ArrayList<>(changes);
    changed.set(which, forms.get(which).change(Arrays.copyOfRange(other, from, end)));
    return new MotionHypothesis(base, forms, other, changed);
  }

  /** Returns the names of the effects, each once. */
  Set<String> effects() {
    return forms.stream().map(MotionForm::effect).collect(Collectors.toCollection(TreeSet::new));
  }

  /** Returns the same without any form of an effect. */
  MotionHypothesis without(String effect) {
    MotionHypothesis less = this;
    for (MotionForm form : forms) {
      less = form.effect().equals(effect) ? less.without(form) : less;
    }
    return less;
  }

  boolean names(String effect) {
    return forms.stream().anyMatch(form -> form.effect().equals(effect));
  }
}
