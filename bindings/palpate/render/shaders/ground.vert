// SPDX-License-Identifier: BSD-3-Clause
#version 330 core

in vec2 corner;  // -1 to 1

uniform mat4 world_to_clip;
uniform vec3 centre;  // [m]
uniform float reach;  // [m]

out vec2 place;

void main() {
  gl_Position = world_to_clip * vec4(centre + vec3(reach * corner, 0.0), 1.0);
  // the floor reaches beyond what the near and far planes were chosen for
  gl_Position.z = 0.0;
  place = 0.5 + 0.5 * corner;
}
