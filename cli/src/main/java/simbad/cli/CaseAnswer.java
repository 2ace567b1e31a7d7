package simbad.cli;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.TreeMap;

/**
 * What came of a case.
 *
 * @param id the case's name
 * @param files contents by name; none when there is no answer
 * @param complaints lines, in the order in which they were made
 */
record CaseAnswer(String id, TreeMap<String, byte[]> files, ArrayList<String> complaints)
    implements Serializable {}
