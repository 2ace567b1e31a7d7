/**
 * Programs as people write them for Simbad, in the style that the statistics of public programs
 * show: star imports, raw types, fields of the environment, classes called Robot. They use public
 * and protected names only and are run without a display.
 */
package oldprograms;
