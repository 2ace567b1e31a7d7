/**
 * The project's pages (README, docs, what lies beside data) as a folder of HTML with a search,
 * which needs no server.
 *
 * <p>Knows files and Markdown, nothing of sonars.
 */
@NullMarked
package simbad.figures.site;

import org.jspecify.annotations.NullMarked;
