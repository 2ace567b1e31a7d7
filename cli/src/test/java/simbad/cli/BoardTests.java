package simbad.cli;

import org.junit.platform.suite.api.SelectClasses;
import org.junit.platform.suite.api.Suite;

/**
 * The tests with a simulated board, one after the other: it keeps real time, and two of them at
 * once are too slow on two cores. Surefire runs them as one class beside all others. Where it asks
 * for tests of another kind, as for those with a display, there are none here.
 */
@Suite(failIfNoTests = false)
@SelectClasses({
  BenchCommandTest.class,
  BenchFaultTest.class,
  BenchMeasureCommandTest.class,
  BoardCommandTest.class,
  HelpExamplesTest.class,
  KillsTest.class
})
final class BoardTests {}
