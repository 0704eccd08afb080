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
  // half a level of grain, interleaved gradient noise [Jimenez14]: eight bits would show as rings
  float wave = dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715));
  float grain = fract(52.9829189 * fract(wave)) - 0.5;
  result = vec4(mix(middle, rim, t) + grain / 255.0, 1.0);
}
