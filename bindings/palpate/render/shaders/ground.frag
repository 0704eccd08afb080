// SPDX-License-Identifier: BSD-3-Clause
#version 330 core

in vec2 place;

uniform sampler2D darkness;
uniform vec3 colour;     // sRGB, of the shadow
uniform float strength;  // 0 to 1

out vec4 result;

void main() { result = vec4(colour, strength * texture(darkness, place).r); }
