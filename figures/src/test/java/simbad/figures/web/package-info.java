@NullMarked
package simbad.figures.web;

import org.jspecify.annotations.NullMarked;
