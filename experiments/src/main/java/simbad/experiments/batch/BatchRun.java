package simbad.experiments.batch;

import simbad.experiments.run.Circuit;
import simbad.experiments.run.Pace;
import simbad.experiments.run.Trace;

/**
 * One run of a batch.
 *
 * @param number in the batch, from 0
 * @param scene what is circled
 * @param sensorFile how a row names the sonar's figures
 * @param effects how a row names the effects at work; empty: none
 * @param controller of the robot
 * @param pace how much time the robot is given for each decision
 * @param circuit what the robot does
 */
record BatchRun(
    long number,
    BatchScene scene,
    String sensorFile,
    String effects,
    ControllerSetting controller,
    Pace pace,
    Circuit circuit) {

  Trace drive() {
    return circuit.drive(controller.controller(circuit.speedMPerS()), pace, false);
  }
}
