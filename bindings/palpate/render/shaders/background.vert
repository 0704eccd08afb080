// SPDX-License-Identifier: BSD-3-Clause
#version 330 core

// One triangle that covers the picture.

uniform vec4 tile;  // left, bottom, right, top of what is drawn, as shares of the whole picture

out vec2 place;

void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 2.0 : 0.0, gl_VertexID == 2 ? 2.0 : 0.0);
  gl_Position = vec4(2.0 * corner - 1.0, 1.0, 1.0);
  place = mix(tile.xy, tile.zw, corner);
}
