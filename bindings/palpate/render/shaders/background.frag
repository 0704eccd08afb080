// SPDX-License-Identifier: BSD-3-Clause
#version 330 core

in vec2 place;

uniform vec3 middle;  // sRGB
uniform vec3 rim;     // sRGB
uniform float aspect;

out vec4 result;

// A lit backdrop: brightest a little above the middle, darker towards the corners.
void main() {
  vec2 away = (place - vec2(0.54, 0.56)) * vec2(min(aspect, 1.8), 1.0);
  float t = smoothstep(0.0, 1.05, length(away));
  result = vec4(mix(middle, rim, t), 1.0);
}
