// SPDX-License-Identifier: BSD-3-Clause
// The printable parts, each lying as it is printed. ./run mechanics writes one STL for each;
// by hand: openscad -D 'part="crank"' -o crank.stl parts.scad
include <shapes.scad>

part = "crank";

arm_half_angle = (elevation_range[1] - elevation_range[0]) / 2 + sector_margin;
crank_half_angle = (forearm_range[1] - forearm_range[0]) / 2 + sector_margin;
yaw_half_angle = (yaw_range[1] - yaw_range[0]) / 2 + sector_margin;
// sectors face the pulley in the middle of the joint's range
arm_sector = motor_angle - (elevation_range[0] + elevation_range[1]) / 2;
crank_sector = motor_angle - (90 + (forearm_range[0] + forearm_range[1]) / 2);
motor_distance = sector_radius + cable + pulley_radius;
hub = large_bearing[0] + 10;
width = 22;
column = 60;
deck = [150, 110];
// beside the axle's middle: gap, arm, gap, cheek
cheek_inside = gap + plate / 2 + gap + plate + gap;

module column_screws(diameter) for (x = [-1, 1], y = [-1, 1])
  translate(38 * [x, y]) circle(d = diameter);

module base() linear_extrude(base_plate) difference() {
  offset(10) square(base_size - 20, center = true);
  column_screws(screw);
  for (x = [-1, 1], y = [-1, 1]) translate((base_size / 2 - 12) * [x, y]) circle(d = 6);
  for (y = [-1, 1]) translate([0, y * 66]) slot(60, 6);  // clamps and the cables' ties
}

module column() difference() {
  union() {
    linear_extrude(8) offset(6) square(84, center = true);
    linear_extrude(column_height) offset(4) square(column - 8, center = true);
    translate([0, 0, column_height - 8]) linear_extrude(8) offset(6) square(84, center = true);
    // so that the upper flange needs no support
    translate([0, 0, column_height - 26]) linear_extrude(18, scale = 96 / column)
      offset(4) square(column - 8, center = true);
  }
  translate([0, 0, -1]) linear_extrude(column_height + 2) offset(3) square(column - 18, center = true);
  for (z = [-1, column_height - 30]) translate([0, 0, z]) linear_extrude(40) column_screws(screw);
  for (z = [8, column_height - 40]) translate([0, 0, z]) linear_extrude(32) column_screws(7);
  translate([0, 0, 40]) rotate([90, 0, 0]) linear_extrude(column) slot(20, 14);  // cables
  // the yaw motor hangs beside it
  translate([-motor_distance, 0, column_height - 40]) cylinder(r = motor_radius + 1.5, h = 50);
}

module deck() difference() {
  union() {
    linear_extrude(deck_plate) translate([-15, 0]) offset(8) square(deck - [16, 16], center = true);
    cylinder(d = hub, h = deck_plate + 4);
  }
  bearing_seat(large_bearing, deck_plate + 4);
  translate([0, 0, -1]) linear_extrude(deck_plate + 2) {
    column_screws(insert);
    translate([-motor_distance, 0]) motor_holes(90);
  }
  // its face is let in, so that the pulley on its shaft reaches the turret
  translate([-motor_distance, 0, -1]) cylinder(r = motor_radius + 0.3, h = 7);
}

module turret_floor() {
  sector(sector_radius, 180, yaw_half_angle);
  circle(d = hub + 8);
}

module turret() difference() {
  union() {
    linear_extrude(plate) turret_floor();
    translate([0, 0, plate]) linear_extrude(floor_plate) difference() {
      translate([-68, -cheek_inside - cheek]) square([98, 2 * (cheek_inside + cheek)]);
    }
    for (side = [-1, 1]) translate([0, side * (cheek_inside + cheek / 2) + cheek / 2, plate + floor_plate])
      rotate([90, 0, 0]) linear_extrude(cheek) cheek_outline();
  }
  cable_way(sector_radius, plate, 180, yaw_half_angle);
  translate([0, 0, -1]) cylinder(d = axle, h = plate + floor_plate + 2);
  // a screw across the yaw axle, which turns with the turret
  translate([0, 0, plate / 2]) rotate([0, 90, 0]) cylinder(d = insert, h = 40);
}

module cheek_outline() translate([0, axle_over_floor]) difference() {
  union() {
    hull() {
      circle(d = 18);  // no more, or the coupler would meet it
      translate([-20, -axle_over_floor]) square([48, 1]);
    }
    hull() {
      at(motor_angle, motor_distance) circle(r = motor_radius + 4);
      translate([-66, -axle_over_floor]) square([66, 1]);
    }
  }
  circle(d = axle);
  at(motor_angle, motor_distance) motor_holes(motor_angle);
}

module arm_outline() {
  beam(upper_arm, width);
  circle(d = hub);
  sector(sector_radius, arm_sector, arm_half_angle);
}

// Lies across the bed: along it, arm and sector would be longer than 200 mm.
module upper_arm() rotate(-40) difference() {
  linear_extrude(plate) difference() {
    arm_outline();
    translate([hub / 2 + 8, 0]) beam(upper_arm - hub / 2 - 26, width - 12);
  }
  bearing_seat(large_bearing, plate);
  translate([upper_arm, 0, 0]) bearing_seat(small_bearing, plate);
  cable_way(sector_radius, plate, arm_sector, arm_half_angle);
}

module crank() difference() {
  linear_extrude(plate) {
    beam(crank_length, width);
    circle(d = hub);
    sector(sector_radius, crank_sector, crank_half_angle);
  }
  bearing_seat(large_bearing, plate);
  translate([crank_length, 0, -1]) cylinder(d = insert, h = plate + 2);
  cable_way(sector_radius, plate, crank_sector, crank_half_angle);
}

coupler_plate = 8;
// from the coupler's plane to the forearm's: over the crank
coupler_rise = gap + plate + gap;

module coupler() difference() {
  union() {
    linear_extrude(coupler_plate) beam(upper_arm, 14);
    translate([upper_arm, 0, 0]) cylinder(d = 14, h = coupler_plate + coupler_rise - 0.5);
  }
  bearing_seat(small_bearing, coupler_plate);
  translate([upper_arm, 0, -1]) cylinder(d = screw, h = 60);
  translate([upper_arm, 0, coupler_plate + coupler_rise - 0.5 - small_bearing[1]])
    cylinder(d = small_bearing[0] + play, h = 10);
}

yoke_back = 32;  // from the tip to where the yoke's stem leaves the forearm
housing = 18;

module forearm() difference() {
  union() {
    linear_extrude(plate) {
      translate([-crank_length, 0]) beam(forearm + crank_length - yoke_back - housing, 16);
      circle(d = width);
    }
    translate([forearm - yoke_back - housing, -housing / 2, 0])
      cube([housing, housing, plate / 2 + housing / 2]);
  }
  translate([0, 0, -1]) cylinder(d = insert, h = plate + 2);
  translate([-crank_length, 0, -1]) cylinder(d = insert, h = plate + 2);
  // the gimbal's first axis lies in the middle of the forearm and goes through the tip
  translate([forearm - yoke_back + 1, 0, plate / 2]) rotate([0, -90, 0]) {
    cylinder(d = screw + 1, h = housing + 2);
    cylinder(d = small_bearing[0] + play, h = small_bearing[1] + 1);
    // a window behind the second bearing, to put it in and to turn the screw's nut
    translate([0, 0, housing + 1 - small_bearing[1]]) cylinder(d = small_bearing[0] + play, h = 14);
  }
}

// Its back lies on the bed; the arms' holes are yoke_back - gap from the stem's face.
module yoke() {
  reach = yoke_back - gap;
  difference() {
    union() {
      linear_extrude(6) square([gimbal_width, 14], center = true);
      for (side = [-1, 1]) translate([side * (gimbal_width / 2 - 3), 0, 0]) rotate([90, 0, 90])
        translate([0, 0, -3]) linear_extrude(6) {
          translate([-7, 0]) square([14, reach]);
          translate([0, reach]) circle(d = 14);
        }
    }
    translate([0, 0, -1]) cylinder(d = insert, h = 8);
    for (side = [-1, 1]) translate([side * (gimbal_width / 2 - 3), 0, reach]) rotate([0, 90, 0]) {
      cylinder(d = screw + 1, h = 20, center = true);
      translate([0, 0, side > 0 ? -1 : -small_bearing[1] + 1])
        cylinder(d = small_bearing[0] + play, h = small_bearing[1]);
    }
  }
}

ring_width = gimbal_width - 12 - 2;

// Pivots on the yoke's screws; the stylus turns in it. All three axes meet in its middle.
module ring() difference() {
  linear_extrude(14) difference() {
    hull() for (side = [-1, 1]) translate([side * (ring_width / 2 - 6), 0]) square([12, 20], center = true);
    circle(d = 2 * stylus_radius + 0.4);
  }
  translate([0, 0, 7]) rotate([0, 90, 0]) cylinder(d = insert - 0.6, h = 60, center = true);
}

module stylus() difference() {
  union() {
    cylinder(r = stylus_radius, h = stylus_length);
    cylinder(r = stylus_radius + 3, h = 20);
    translate([0, 0, 20]) cylinder(r1 = stylus_radius + 3, r2 = stylus_radius, h = 4);
  }
  translate([0, 0, -1]) cylinder(d = 6.1, h = 3.5);  // magnet of the roll sensor
  translate([0, 0, stylus_length - 30]) cylinder(d = 5, h = 31);  // cables of two buttons
  for (z = [60, 75]) translate([0, 0, z]) rotate([0, 90, 0]) cylinder(d = 3, h = 20);
  translate([0, 0, 56]) cylinder(d = 5, h = stylus_length);
}

module pulley() difference() {
  union() {
    cylinder(r = pulley_radius, h = 14);
    cylinder(r = pulley_radius + 3, h = pulley_flange);
  }
  translate([0, 0, -1]) cylinder(d = motor_shaft + 0.1, h = 20);
  translate([0, 0, 9]) rotate([0, 90, 0]) cylinder(d = 2.5, h = 20, $fn = 16);  // set screw
  // both ends of the line stop here
  for (z = [4.5, 12.5]) translate([0, 0, z]) rotate([90, 0, 0])
    cylinder(d = 1.2, h = 20, center = true, $fn = 12);
}

// Holds a sensor board before the end of a shaft; two screws, two slots to set the distance.
module sensor_mount() {
  side = sensor_board + 8;
  difference() {
    union() {
      linear_extrude(4) square(side, center = true);
      translate([-side / 2, -side / 2, 0]) cube([side, 4, 26]);
    }
    translate([0, 0, -1]) linear_extrude(6) {
      circle(d = 9);
      sensor_holes(2.2);
    }
    for (x = [-9, 9]) translate([x, 0, 17]) rotate([90, 0, 0]) linear_extrude(side)
      rotate(90) slot(8, screw);
  }
}

if (part == "base") base();
else if (part == "column") column();
else if (part == "deck") deck();
else if (part == "turret") turret();
else if (part == "upper_arm") upper_arm();
else if (part == "crank") crank();
else if (part == "coupler") coupler();
else if (part == "forearm") forearm();
else if (part == "yoke") yoke();
else if (part == "ring") ring();
else if (part == "stylus") stylus();
else if (part == "pulley") pulley();
else if (part == "sensor_mount") sensor_mount();
else assert(false, str("no part named '", part, "'"));
