package simbad.sim;

import java.util.ArrayList;
import javax.media.j3d.BranchGroup;
import org.jspecify.annotations.Nullable;

/** The devices of an agent, in the order in which they were added. */
final class DeviceRack {
  final ArrayList<SensorDevice> sensors = new ArrayList<>();
  final ArrayList<ActuatorDevice> actuators = new ArrayList<>();

  int add(SensorDevice sensor) {
    sensors.add(sensor);
    return sensors.size() - 1;
  }

  int add(ActuatorDevice actuator) {
    actuators.add(actuator);
    return actuators.size() - 1;
  }

  void reset() {
    sensors.forEach(Device::restartClock);
    sensors.forEach(SensorDevice::reset);
    actuators.forEach(ActuatorDevice::reset);
  }

  /** Iterates by index, also below: a step allocates nothing, not even an iterator. */
  void updateSensors(double elapsedSecond, @Nullable BranchGroup branch) {
    for (int i = 0; i < sensors.size(); i++) {
      SensorDevice sensor = sensors.get(i);
      if (branch != null && sensor instanceof PickSensor pickSensor) {
        pickSensor.setPickableSceneBranch(branch);
      }
      sensor.update(elapsedSecond);
    }
  }

  void updateActuators(double elapsedSecond) {
    for (int i = 0; i < actuators.size(); i++) {
      actuators.get(i).update(elapsedSecond);
    }
  }
}
