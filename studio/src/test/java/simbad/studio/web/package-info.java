@NullMarked
package simbad.studio.web;

import org.jspecify.annotations.NullMarked;
