// SPDX-License-Identifier: BSD-3-Clause
#version 330 core

in vec3 position;     // [m] world
in vec3 normal;       // unit, outward
in float value;       // what the colour map shows
in float selection;   // 0 to 1
in float torn;        // 0 whole to 1
in float openness;    // share of the sky that is seen, 0 to 1
in vec3 rest;         // [m] where the vertex is at rest, to which the pattern sticks
in vec3 tint;         // its own colour, linear light

uniform mat4 world_to_clip;

out Corner {
  vec3 position;
  vec3 normal;
  float value;
  float selection;
  float torn;
  float openness;
  vec3 rest;
  vec3 tint;
} corner;

void main() {
  gl_Position = world_to_clip * vec4(position, 1.0);
  corner.position = position;
  corner.normal = normal;
  corner.value = value;
  corner.selection = selection;
  corner.torn = torn;
  corner.openness = openness;
  corner.rest = rest;
  corner.tint = tint;
}
