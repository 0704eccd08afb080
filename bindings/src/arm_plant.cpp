// SPDX-License-Identifier: BSD-3-Clause
#include "bindings.h"
#include "border.h"
#include "palpate/sim/arm/calibration.h"
#include "palpate/sim/arm/plant.h"
#include "value.h"

namespace palpate::bindings {

namespace {

void bind_parts(py::module_& m) {
  const ArmMasses mass;
  py::class_<ArmMasses> masses(m, "ArmMasses", "The masses of the arm's parts.");
  masses
      .def(py::init([](double upper, double forearm, double gimbal, double motor, double balance) {
             return ArmMasses{upper, forearm, gimbal, motor, balance};
           }),
           py::kw_only(), "upper"_a = mass.upper, "forearm"_a = mass.forearm,
           "gimbal"_a = mass.gimbal, "motor"_a = mass.motor, "balance"_a = mass.balance)
      .def_readwrite("upper", &ArmMasses::upper, "[kg] a rod, heavy in its middle.")
      .def_readwrite("forearm", &ArmMasses::forearm, "[kg] likewise.")
      .def_readwrite("gimbal", &ArmMasses::gimbal, "[kg] at the tip.")
      .def_readwrite("motor", &ArmMasses::motor, "[kg·m²] of each motor, seen from its joint.")
      .def_readwrite("balance", &ArmMasses::balance,
                     "[-] 0 to 1: how much of the weight springs or counterweights carry.");
  def_value(masses, &ArmMasses::upper, &ArmMasses::forearm, &ArmMasses::gimbal, &ArmMasses::motor,
            &ArmMasses::balance);
  def_repr(masses, {"upper", "forearm", "gimbal", "motor", "balance"});

  const Motor usual;
  py::class_<Motor> motor(m, "Motor", "One brushed motor under a voltage, behind a capstan.");
  motor
      .def(py::init([](double supply, double resistance, double torque_constant, double gear,
                       double efficiency) {
             return Motor{supply, resistance, torque_constant, gear, efficiency};
           }),
           py::kw_only(), "supply"_a = usual.supply, "resistance"_a = usual.resistance,
           "torque_constant"_a = usual.torque_constant, "gear"_a = usual.gear,
           "efficiency"_a = usual.efficiency)
      .def_readwrite("supply", &Motor::supply, "[V]")
      .def_readwrite("resistance", &Motor::resistance, "[Ohm]")
      .def_readwrite("torque_constant", &Motor::torque_constant, "[N·m/A], and [V·s/rad].")
      .def_readwrite("gear", &Motor::gear, "[-] Motor turns per joint turn.")
      .def_readwrite("efficiency", &Motor::efficiency, "[-] 0 to 1.");
  def_value(motor, &Motor::supply, &Motor::resistance, &Motor::torque_constant, &Motor::gear,
            &Motor::efficiency);
  def_repr(motor, {"supply", "resistance", "torque_constant", "gear", "efficiency"});

  const Hand soft;
  py::class_<Hand> hand(m, "Hand",
                        "The hand that holds the stylus: a mass, drawn by spring and damper to "
                        "where it wants to be.");
  hand.def(py::init([](double hand_mass, double stiffness, double damping) {
             return Hand{hand_mass, stiffness, damping};
           }),
           py::kw_only(), "mass"_a = soft.mass, "stiffness"_a = soft.stiffness,
           "damping"_a = soft.damping)
      .def_readwrite("mass", &Hand::mass, "[kg]")
      .def_readwrite("stiffness", &Hand::stiffness, "[N/m]")
      .def_readwrite("damping", &Hand::damping, "[N·s/m]");
  def_value(hand, &Hand::mass, &Hand::stiffness, &Hand::damping);
  def_repr(hand, {"mass", "stiffness", "damping"});
}

void bind_plant_struct(py::module_& m) {
  py::class_<Plant> plant(m, "Plant",
                          "What a real arm does to what it is told, and to what it says: "
                          "everything of the device that is not firmware, in numbers. Nothing in "
                          "it is left to chance: noise comes from the seed.");
  plant.def(py::init<>())
      .def_readwrite("upper_length", &Plant::upper_length, "[m]")
      .def_readwrite("forearm_length", &Plant::forearm_length, "[m]")
      .def_readwrite("masses", &Plant::masses, "The masses of its parts.");
  def_vector(plant, "joint_min", &Plant::joint_min, "[rad] where the joints have their stops.");
  def_vector(plant, "joint_max", &Plant::joint_max, "[rad]");
  plant.def_readwrite("motor", &Plant::motor, "Each of its three motors.");
  def_vector(plant, "dry_friction", &Plant::dry_friction, "[N·m] per joint.");
  def_vector(plant, "viscous_friction", &Plant::viscous_friction, "[N·m·s/rad] per joint.");
  plant.def_readwrite("hand", &Plant::hand, "The hand that holds the stylus.")
      .def_readwrite("count", &Plant::count, "[rad] of the arm joints' sensors.")
      .def_readwrite("gimbal_count", &Plant::gimbal_count, "[rad] of the gimbal's.")
      .def_readwrite("noise", &Plant::noise, "[counts] standard deviation.")
      .def_readwrite("seed", &Plant::seed, "Of the noise.")
      .def_readwrite("step", &Plant::step, "[s] the longest step of its motion.");
  def_value(plant, &Plant::upper_length, &Plant::forearm_length, &Plant::masses, &Plant::joint_min,
            &Plant::joint_max, &Plant::motor, &Plant::dry_friction, &Plant::viscous_friction,
            &Plant::hand, &Plant::count, &Plant::gimbal_count, &Plant::noise, &Plant::seed,
            &Plant::step);
  def_repr(plant, {"upper_length", "forearm_length", "masses", "motor", "dry_friction",
                   "viscous_friction", "hand", "count", "noise", "seed"});
}

void bind_plant_state(py::module_& m) {
  py::class_<Drive> drive(m, "Drive", "What the drivers are told.");
  drive.def(py::init([](const Vec3& duty, bool enabled) {
              return Drive{duty, enabled};
            }),
            "duty"_a = Vec3::Zero().eval(), "enabled"_a = false);
  def_vector(drive, "duty", &Drive::duty, "[-] -255 to 255.");
  drive.def_readwrite("enabled", &Drive::enabled, "Off, the motors are not connected.");
  def_value(drive, &Drive::duty, &Drive::enabled);
  def_repr(drive, {"duty", "enabled"});

  py::class_<HandTarget> target(m, "HandTarget", "Where the hand wants to be.");
  target.def(py::init([](const Vec3& position, const Vec3& velocity, bool holding) {
               return HandTarget{position, velocity, holding};
             }),
             "position"_a = Vec3::Zero().eval(), "velocity"_a = Vec3::Zero().eval(),
             "holding"_a = false);
  def_vector(target, "position", &HandTarget::position, "[m] in the arm's frame.");
  def_vector(target, "velocity", &HandTarget::velocity, "[m/s]");
  target.def_readwrite("holding", &HandTarget::holding, "No hand holds the stylus otherwise.");
  def_value(target, &HandTarget::position, &HandTarget::velocity, &HandTarget::holding);
  def_repr(target, {"position", "velocity", "holding"});

  py::class_<PlantState> state(m, "PlantState",
                               "At rest in the middle of its workspace, at first.");
  state
      .def(py::init([](const Plant& plant) {
             validate(plant);
             return PlantState(plant);
           }),
           "plant"_a, "The arm of this plant, at rest.")
      .def_readwrite("time", &PlantState::time, "[s]");
  def_vector(state, "joints", &PlantState::joints, "[rad]");
  def_vector(state, "rates", &PlantState::rates, "[rad/s]");
  def_vector(state, "gimbal", &PlantState::gimbal, "[rad]");
  def_vector(state, "hand_force", &PlantState::hand_force, "[N] of the hand on the stylus.");
  state.def_readwrite("random", &PlantState::random, "State of the noise.");
  def_value(state, &PlantState::time, &PlantState::joints, &PlantState::rates, &PlantState::gimbal,
            &PlantState::hand_force, &PlantState::random);
  def_repr(state, {"time", "joints", "rates", "gimbal", "hand_force"});
  m.attr("SENSOR_MIDDLE") = kSensorMiddle;
  m.attr("SENSOR_END") = kSensorEnd;
}

constexpr double kMostSteps = 1e6;  // of a plant in one call: about a second

void bind_plant_functions(py::module_& m) {
  m.def("validate", py::overload_cast<const Plant&>(&validate), "plant"_a,
        "Raises ValueError naming the field, what it got and what was expected.");
  m.def("find_arm", py::overload_cast<const Plant&>(&find_arm), "plant"_a,
        "What kinematics and weights of this plant are, as a calibration would find them.");
  m.def("compute_mass", &compute_mass, "plant"_a, "joints"_a, "holding"_a,
        "[kg·m²] of the arm, and of the hand where one is holding it.");
  m.def("compute_energy", py::overload_cast<const Plant&, const PlantState&>(&compute_energy),
        "plant"_a, "state"_a, "[J] kinetic and potential, without the hand.");
  m.def("compute_motor_torque", &compute_motor_torque, "plant"_a, "drive"_a, "rates"_a,
        "[N·m] at the joints, of motors that turn at rates [rad/s].");
  m.def("compute_stall_torque", &compute_stall_torque, "motor"_a,
        "[N·m] at the joint of a motor held still at full duty.");
  m.def("compute_motor_damping", &compute_motor_damping, "motor"_a,
        "[N·m·s/rad] that a motor under voltage brakes its joint with.");
  m.def(
      "move_plant",
      [](const Plant& plant, const Drive& drive, const HandTarget& hand, double dt,
         PlantState& state) {
        validate(plant);
        require_positive("dt", dt);
        if (dt > kMostSteps * plant.step) {
          refuse("dt [s]", write_text(dt), write_text("at most ", kMostSteps * plant.step));
        }
        const py::gil_scoped_release released;
        move_plant(plant, drive, hand, dt, state);
      },
      "plant"_a, "drive"_a, "hand"_a, "dt"_a, "state"_a,
      "Moves the arm on by dt [s] in steps no longer than its own.");
  m.def("read_sensors", &read_sensors, "plant"_a, "state"_a,
        "What the sensors of three joints and the gimbal say: 0 to 1023. Noise moves the seed on.");
  m.def("find_tip", &find_tip, "plant"_a, "state"_a, "[m] where the stylus' tip really is.");
}

void bind_calibration(py::module_& m) {
  const JointSensor usual;
  py::class_<JointSensor> joint(m, "JointSensor", "What one sensor's counts mean.");
  joint
      .def(py::init([](int zero, double scale, int min, int max) {
             return JointSensor{zero, scale, min, max};
           }),
           py::kw_only(), "zero"_a = usual.zero, "scale"_a = usual.scale, "min"_a = usual.min,
           "max"_a = usual.max)
      .def_readwrite("zero", &JointSensor::zero, "[counts] at angle zero.")
      .def_readwrite("scale", &JointSensor::scale, "[rad/count], its sign is the direction.")
      .def_readwrite("min", &JointSensor::min, "[counts] end of the joint's range.")
      .def_readwrite("max", &JointSensor::max, "[counts] end of the joint's range.");
  def_value(joint, &JointSensor::zero, &JointSensor::scale, &JointSensor::min, &JointSensor::max);
  def_repr(joint, {"zero", "scale", "min", "max"});

  py::class_<Calibration> calibration(m, "Calibration",
                                      "What a device keeps of itself in its EEPROM, in SI units.");
  calibration.def(py::init<>())
      .def_readwrite("joints", &Calibration::joints,
                     "Three of the arm, three of the gimbal; assign the whole list.")
      .def_readwrite("upper_length", &Calibration::upper_length, "[m]")
      .def_readwrite("forearm_length", &Calibration::forearm_length, "[m]");
  def_vector(calibration, "torque_full", &Calibration::torque_full,
             "[N·m] at the joint, of full duty; signed.");
  calibration
      .def_readwrite("upper_weight", &Calibration::upper_weight,
                     "[N·m] that carries the level upper link.")
      .def_readwrite("forearm_weight", &Calibration::forearm_weight,
                     "[N·m] that carries the level forearm.")
      .def_readwrite("deadband", &Calibration::deadband,
                     "[duty] at which the motor begins to push.")
      .def_readwrite("continuous_duty", &Calibration::continuous_duty,
                     "[duty] that may be held for ever.")
      .def_readwrite("heat_time", &Calibration::heat_time, "[s] in which the motors warm up.")
      .def_readwrite("speed_max", &Calibration::speed_max,
                     "[counts/ms] of an arm joint; more is a fault.")
      .def_readwrite("serial_number", &Calibration::serial_number, "Of the device.");
  def_value(calibration, &Calibration::joints, &Calibration::upper_length,
            &Calibration::forearm_length, &Calibration::torque_full, &Calibration::upper_weight,
            &Calibration::forearm_weight, &Calibration::deadband, &Calibration::continuous_duty,
            &Calibration::heat_time, &Calibration::speed_max, &Calibration::serial_number);
  def_repr(calibration, {"joints", "upper_length", "forearm_length", "torque_full", "upper_weight",
                         "forearm_weight", "deadband", "continuous_duty", "heat_time", "speed_max",
                         "serial_number"});

  m.def("validate", py::overload_cast<const Calibration&>(&validate), "calibration"_a,
        "Raises ValueError naming the field, what it got and what was expected.");
  m.def("find_calibration", &find_calibration, "plant"_a,
        "The calibration a plant would get if nothing were measured wrong.");
  m.def("compute_angles", &compute_angles, "calibration"_a, "counts"_a, "[rad] of six sensors.");
  m.def("find_arm", py::overload_cast<const Calibration&>(&find_arm), "calibration"_a,
        "The kinematics and the joints' limits of a calibrated device.");
  m.def("find_safety_limits", &find_safety_limits, "calibration"_a,
        "What forces a device can bear: in every direction and place of its workspace, at any "
        "moment and for ever.");
}

}  // namespace

void bind_plant(py::module_& m) {
  bind_parts(m);
  bind_plant_struct(m);
  bind_plant_state(m);
  bind_plant_functions(m);
  bind_calibration(m);
}

}  // namespace palpate::bindings
