@NullMarked
package simbad.experiments.web;

import org.jspecify.annotations.NullMarked;
