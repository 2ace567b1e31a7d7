/**
 * The audit of a data set before anything is fitted: whether its numbers can be what they are said
 * to be. Each check has its rule and its derivation in docs/method/audit.md.
 */
@NullMarked
package simbad.gap.audit;

import org.jspecify.annotations.NullMarked;
