package simbad.experiments.report;

import simbad.experiments.run.RunSettings;

/**
 * What made a run's results.
 *
 * @param version of the program, with its commit
 * @param settings of the run
 */
public record RunOrigin(String version, RunSettings settings) {}
