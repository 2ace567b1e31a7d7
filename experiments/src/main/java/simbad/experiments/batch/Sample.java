package simbad.experiments.batch;

/**
 * Some of a product's runs, by chance.
 *
 * @param runs how many, all different
 * @param seed of chance
 */
record Sample(long runs, long seed) {}
