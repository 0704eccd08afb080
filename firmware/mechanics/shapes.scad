// SPDX-License-Identifier: BSD-3-Clause
// Shapes that several parts share. Flat outlines first: they are cheap, and joined before they
// are made solid.
include <parameters.scad>

$fn = 72;

module at(angle, distance) rotate(angle) translate([distance, 0]) children();

// A strip from the origin along +x, rounded at both ends.
module beam(length, width) hull() {
  circle(d = width);
  translate([length, 0]) circle(d = width);
}

// The part of a disc around `middle` that a cable unrolls from.
module sector(radius, middle, half_angle) intersection() {
  circle(radius);
  polygon(concat([[0, 0]], [for (k = [-6 : 6]) let (a = middle + k * half_angle / 6)
    2 * radius * [cos(a), sin(a)]]));
}

module slot(length, width) translate([-length / 2, 0]) beam(length, width);

// Holes for a motor's boss and its two screws.
module motor_holes(turn = 0) {
  circle(d = motor_boss);
  for (side = [0, 180]) at(turn + side, motor_screws / 2) circle(d = screw);
}

// Four holes of a square sensor board.
module sensor_holes(diameter) for (x = [-1, 1], y = [-1, 1])
  translate(sensor_screws / 2 * [x, y]) circle(d = diameter);

// What is cut for a bearing that is pushed in from above `top`, with a shoulder below it.
module bearing_seat(bearing, top) {
  translate([0, 0, top - bearing[1]]) cylinder(d = bearing[0] + play, h = bearing[1] + 1);
  translate([0, 0, -1]) cylinder(d = bearing[0] - 4, h = top + 2);
}

// The groove and the two holes that hold the cable of a sector of `thickness`.
module cable_way(radius, thickness, middle, half_angle) {
  translate([0, 0, thickness / 2]) rotate_extrude()
    translate([radius, 0]) circle(d = 2 * cable, $fn = 12);
  for (end = [-1, 1]) rotate(middle + end * (half_angle - 6)) translate([radius - 7, 0, -1])
    cylinder(d = 2, h = thickness + 2, $fn = 16);
}
