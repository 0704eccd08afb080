// SPDX-License-Identifier: BSD-3-Clause
#version 330 core

// Gives every corner of a triangle a coordinate of its own, so that the fragment knows how far it
// is from each edge: surface and wireframe in one pass.

layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;

in Corner {
  vec3 position;
  vec3 normal;
  float value;
  float selection;
  float torn;
  float openness;
  vec3 rest;
  vec3 tint;
} corner[];

out Fragment {
  vec3 position;
  vec3 normal;
  float value;
  float selection;
  float torn;
  float openness;
  vec3 rest;
  vec3 tint;
  vec3 barycentric;
} fragment;

void main() {
  for (int i = 0; i < 3; ++i) {
    gl_Position = gl_in[i].gl_Position;
    fragment.position = corner[i].position;
    fragment.normal = corner[i].normal;
    fragment.value = corner[i].value;
    fragment.selection = corner[i].selection;
    fragment.torn = corner[i].torn;
    fragment.openness = corner[i].openness;
    fragment.rest = corner[i].rest;
    fragment.tint = corner[i].tint;
    fragment.barycentric = vec3(i == 0, i == 1, i == 2);
    EmitVertex();
  }
  EndPrimitive();
}
