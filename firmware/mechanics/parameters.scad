// SPDX-License-Identifier: BSD-3-Clause
// Every measure of the device [mm, degrees]. Change it here, then ./run mechanics.
// What a shop sells differs: measure your motors, bearings and sensors before you print.

// the arm, as the firmware's calibration and the driver's kinematics have it
upper_arm = 150;       // elevation axis to elbow
forearm = 150;         // elbow to the point where the gimbal's three axes meet: the tip
crank_length = 40;     // parallelogram, so that both motors stand still on the turret
yaw_range = [-60, 60];
elevation_range = [-15, 90];
forearm_range = [-45, 80];  // from straight down

// capstan drives: sector to pulley is the ratio, 10 to 1
sector_radius = 50;
pulley_radius = 5;
pulley_flange = 3;
cable = 0.6;           // braided line
sector_margin = 14;    // of the sector beyond the joint's range
motor_angle = 217.5;   // seen from the axle, 0 forward, 90 up: behind, below, clear of the floor

// motors: RS-385 can, on two screws
motor_radius = 14;
motor_boss = 10.4;     // diameter of the hole for its boss
motor_screws = 16;     // apart
motor_shaft = 2.3;

// bearings: 608 on the 8 mm axles, 623 on M3 screws
axle = 8;
large_bearing = [22, 7];
small_bearing = [10, 4];
screw = 3.2;
insert = 4.0;          // for M3 inserts set with a soldering iron
sensor_board = 23;     // AS5600 breakout, square
sensor_screws = 16.5;  // apart

// plates and play
plate = 10;            // arm, crank, forearm
cheek = 6;
gap = 2;
play = 0.25;           // of a bearing's seat: prints come out small

// heights: the tip reaches 160 mm below the elevation axis and must not touch the table
base_size = 180;
base_plate = 8;
column_height = 120;
deck_plate = 10;
axle_over_floor = 58;  // the sectors must clear the turret's floor
floor_plate = 6;

// handle
stylus_length = 120;
stylus_radius = 6;
gimbal_width = 46;     // between the outsides of the yoke's arms
