// SPDX-License-Identifier: BSD-3-Clause
#version 330 core

in Fragment {
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

uniform vec3 eye;             // [m] world
uniform vec3 to_key;          // unit vectors towards the three lamps, which move with the camera
uniform vec3 to_fill;
uniform vec3 to_rim;
uniform float ambient;        // light from all around, of the theme
uniform float headlight;      // [m] at which a lamp at the eye is as bright as the key; 0 for none

uniform sampler2D colours;    // 256 by 1, linear light, like the colours below
uniform vec2 value_range;
uniform bool mapped;          // whether the colour map or `colour` paints this part
uniform bool tinted;          // whether the colours of the vertices stand for it and the pattern
uniform vec3 colour;
uniform vec3 highlight;       // of what is selected
uniform float gloss;          // 0 dull, 1 wet or polished
uniform float subsurface;       // how far light creeps around into the shade, as in flesh
uniform float sharpness;      // of highlights: 1 as a wet organ has them, less on dull ones
uniform float wire_width;     // [px], 0 for no wireframe
uniform float opacity;        // 0 to 1

// SHADOW_TAPS, 0 for no shadow, is defined by the program: were it a uniform, a processor that
// computes many fragments in step would make all comparisons and then not use them.
uniform mat4 world_to_shadow;
uniform sampler2DShadow shadow;
uniform float shadow_softness;  // radius of the blur, in texture coordinates

// PATTERN, 0 for none, is defined by the program for the same reason.
#if PATTERN
uniform vec3 pattern_colour;
uniform vec3 vein_colour;
uniform float pattern_size;      // [m]
uniform float pattern_strength;  // 0 to 1
uniform float vein_strength;     // 0 to 1
uniform float relief;            // height of the pattern in parts of its size
#endif

// INSTRUMENTS, 0 where none is near, is defined by the program for the same reason.
#if INSTRUMENTS
uniform vec4 capsule_from[16];  // [m] one end of the axis and, in w, the radius
uniform vec4 capsule_to[16];    // [m] the other end and, in w, 0 to 1: how what it touches glows
uniform vec4 rings[4];          // [m] a point of the surface and, in w, the radius of a ring round it
uniform int capsule_count;
uniform int ring_count;
uniform bool tissue;            // whether instruments cast their shadow on this part
#endif

out vec4 result;

const vec3 KEY = vec3(1.00, 0.965, 0.92);
const vec3 FILL = vec3(0.62, 0.74, 0.92);
const vec3 RIM = vec3(0.80, 0.90, 1.00);
const vec3 SKY = vec3(0.94, 0.97, 1.00);
const vec3 WOUND = vec3(0.085, 0.002, 0.004);  // what has torn bleeds
const vec3 FLOOR = vec3(0.50, 0.44, 0.41);
#if INSTRUMENTS
const vec3 GLOW = vec3(1.00, 0.72, 0.22);
const float GLOW_REACH = 0.0022;  // [m] in which it has faded to a third
const float RING_WIDTH = 2.6;     // [px]
#endif

// Screens end at white: what is brighter rolls off instead of being cut.
vec3 encode(vec3 light) {
  vec3 over = max(light - 0.8, 0.0);
  vec3 rolled = clamp(light, 0.0, 0.8) + 0.2 * (1.0 - exp(-over / 0.2));
  return pow(rolled, vec3(1.0 / 2.2));
}

#if PATTERN
// A number of 0 to 1 for every point of a grid.
float scatter(ivec2 cell) {
  uint h = uint(cell.x) * 0x9E3779B1u ^ uint(cell.y) * 0x85EBCA77u;
  h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
  h = (h ^ (h >> 12)) * 0x297A2D39u;
  return float((h ^ (h >> 15)) >> 8) / 16777215.0;
}

// Value noise: smooth between the points of the grid.
float noise(vec2 p) {
  ivec2 cell = ivec2(floor(p));
  vec2 t = fract(p);
  t = t * t * (3.0 - 2.0 * t);
  float low = mix(scatter(cell), scatter(cell + ivec2(1, 0)), t.x);
  float high = mix(scatter(cell + ivec2(0, 1)), scatter(cell + ivec2(1, 1)), t.x);
  return mix(low, high, t.y);
}

// Spots and, in y, fine vessels on one plane; lengths in pattern sizes.
vec2 draw_pattern(vec2 p) {
  float spots = 0.55 * noise(p) + 0.30 * noise(2.3 * p + 17.0) + 0.15 * noise(5.1 * p + 31.0);
  vec2 bent = 0.30 * p + 0.9 * vec2(noise(0.5 * p + 5.0), noise(0.5 * p + 47.0));
  float ridge = 1.0 - abs(2.0 * noise(bent) - 1.0);
  float twig = 1.0 - abs(2.0 * noise(2.6 * bent + 11.0) - 1.0);
  float trunk = smoothstep(0.91, 0.985, ridge);
  return vec2(spots, max(trunk, 0.6 * smoothstep(0.92, 0.99, twig) * smoothstep(0.5, 0.9, ridge)));
}

// The pattern on the three planes of space, each as far as the surface faces it.
vec2 wrap_pattern(vec3 n) {
  vec3 p = fragment.rest / pattern_size, weight = n * n * n * n;
  weight /= weight.x + weight.y + weight.z;
  return weight.x * draw_pattern(p.yz) + weight.y * draw_pattern(p.zx + 101.0) +
         weight.z * draw_pattern(p.xy + 211.0);
}

// The normal where the spots stand out from the surface: bump mapping with nothing but how height
// and place change from pixel to pixel.
vec3 raise(vec3 n, float height) {
  vec3 dx = dFdx(fragment.position), dy = dFdy(fragment.position);
  vec3 across = cross(dy, n), along = cross(n, dx);
  float area = dot(dx, across);
  vec3 slope = sign(area) * (dFdx(height) * across + dFdy(height) * along);
  vec3 raised = abs(area) * n - slope;
  return dot(raised, raised) > 0.0 ? normalize(raised) : n;
}
#endif

vec3 paint(bool outside, vec2 pattern) {
  vec3 c = tinted ? fragment.tint : colour;
#if PATTERN
  if (!tinted) {
    c = mix(c, pattern_colour, pattern_strength * smoothstep(0.32, 0.72, pattern.x));
    c = mix(c, vein_colour, vein_strength * pattern.y);
  }
#endif
  if (mapped) {
    float t = clamp((fragment.value - value_range.x) / (value_range.y - value_range.x), 0.0, 1.0);
    // texel centres, so that both ends of the range get their very colour
    c = texture(colours, vec2((t * 255.0 + 0.5) / 256.0, 0.5)).rgb;
  }
  // the inner side of an open surface is paler and duller, so it is never taken for the outer one
  float grey = dot(c, vec3(0.2126, 0.7152, 0.0722));
  if (!outside) c = mix(vec3(0.55 * grey + 0.16), c, 0.45) * vec3(1.0, 0.93, 0.88);
  // all of a triangle that has torn, and the nearer half of those around it, whatever paints them
  c = mix(c, WOUND, 0.95 * smoothstep(0.4, 0.8, fragment.torn));
  return mix(c, highlight, 0.85 * smoothstep(0.0, 1.0, fragment.selection));
}

// Share of the key light that arrives: a disc of comparisons in the shadow map, each of them
// already smoothed over four texels.
float lit(vec3 n) {
#if SHADOW_TAPS == 0
  return 1.0;
#else
  float facing = dot(n, to_key);
  vec3 at = (world_to_shadow * vec4(fragment.position, 1.0)).xyz;
  at.z -= 0.002 + 0.008 * (1.0 - clamp(facing, 0.0, 1.0));
  float sum = 0.0;
  for (int i = 0; i < SHADOW_TAPS; ++i) {
    // a sunflower fills the disc evenly
    float radius = sqrt((float(i) + 0.5) / float(SHADOW_TAPS)), angle = 2.399963 * float(i);
    vec2 offset = shadow_softness * radius * vec2(cos(angle), sin(angle));
    sum += texture(shadow, at + vec3(offset, 0.0));
  }
  // where light only grazes, the flat triangles of a coarse mesh would shade their own smooth normals
  return mix(1.0, sum / float(SHADOW_TAPS), smoothstep(0.05, 0.45, facing));
#endif
}

#if INSTRUMENTS
// How near the axis of a capsule comes to the ray from here to the lamp, and how far along the ray:
// the closest points of a ray and a segment, each clamped in turn [Ericson04].
vec2 meet_lamp(vec3 a, vec3 b) {
  vec3 along = b - a, away = fragment.position - a;
  float aa = dot(along, along), ba = dot(to_key, along);
  float ca = dot(along, away), cl = dot(to_key, away);
  float u = 0.0, denominator = aa - ba * ba;
  if (aa > 1e-14) u = denominator > 1e-9 * aa ? clamp((ca - ba * cl) / denominator, 0.0, 1.0) : 0.0;
  float t = max(u * ba - cl, 0.0);
  if (aa > 1e-14) u = clamp((ca + t * ba) / aa, 0.0, 1.0);
  return vec2(length(away + t * to_key - u * along), t);
}

// [m] From here to the axis of a capsule.
float measure_gap(vec3 a, vec3 b) {
  vec3 along = b - a, away = fragment.position - a;
  float aa = dot(along, along);
  float u = aa > 1e-14 ? clamp(dot(away, along) / aa, 0.0, 1.0) : 0.0;
  return length(away - u * along);
}

// Share of the key light that the instruments leave; x is that, y how much this glows. The edge of
// the shadow is soft with the distance, as under a lamp that is 7 degrees wide.
vec2 pass_instruments(vec3 n) {
  float left = 1.0, glow = 0.0;
  for (int i = 0; i < capsule_count; ++i) {
    vec3 a = capsule_from[i].xyz, b = capsule_to[i].xyz;
    float radius = capsule_from[i].w;
    vec2 met = meet_lamp(a, b);
    float soft = 0.12 * radius + 0.06 * met.y;
    left = min(left, smoothstep(radius - soft, radius + soft, met.x));
    float apart = max(measure_gap(a, b) - radius, 0.0) / GLOW_REACH;
    glow = max(glow, capsule_to[i].w * exp(-apart * apart));
  }
  // what faces away from the lamp is dark by itself
  return vec2(mix(1.0, left, smoothstep(0.0, 0.15, dot(n, to_key))), glow);
}

// A ring round the point that is nearest to a tip: light between two dark edges, so that it is seen on
// whatever is painted.
vec3 draw_rings(vec3 c) {
  for (int i = 0; i < ring_count; ++i) {
    float apart = length(fragment.position - rings[i].xyz) - rings[i].w;
    // at its outline the surface runs away from the eye, and a pixel there covers any distance
    float away = abs(apart) / clamp(fwidth(apart), 1e-9, 0.08 * rings[i].w);
    c = mix(c, vec3(0.03), 0.7 * (1.0 - smoothstep(RING_WIDTH - 0.5, RING_WIDTH + 0.5, away)));
    c = mix(c, vec3(0.95), 1.0 - smoothstep(0.5 * RING_WIDTH - 0.5, 0.5 * RING_WIDTH + 0.5, away));
  }
  return c;
}
#endif

// 1 on an edge of the triangle, 0 away from it; edges that would run together fade away.
float wire() {
  if (wire_width <= 0.0) return 0.0;
  vec3 dx = dFdx(fragment.barycentric), dy = dFdy(fragment.barycentric);
  vec3 slope = sqrt(max(dx * dx + dy * dy, 1e-12));
  vec3 away = fragment.barycentric / slope;
  float nearest = min(away.x, min(away.y, away.z));
  float height = 1.0 / max(slope.x, max(slope.y, slope.z));
  float fade = smoothstep(2.0, 9.0, height / wire_width);
  return fade * (1.0 - smoothstep(0.5 * wire_width - 0.5, 0.5 * wire_width + 0.7, nearest));
}

void main() {
  vec3 v = normalize(eye - fragment.position);
  float length2 = dot(fragment.normal, fragment.normal);
  vec3 n = length2 > 1e-12 ? fragment.normal * inversesqrt(length2) : v;
  if (!gl_FrontFacing) n = -n;

  vec2 pattern = vec2(0.0);
#if PATTERN
  pattern = wrap_pattern(n);
  n = raise(n, relief * pattern_size * pattern.x);
#endif
  vec3 albedo = paint(gl_FrontFacing, pattern);
  albedo *= mix(1.0, 0.22, wire() * 0.72);

  float open = clamp(fragment.openness, 0.0, 1.0);
  float shade = lit(n);
#if INSTRUMENTS
  vec2 passed = tissue ? pass_instruments(n) : vec2(1.0, 0.0);
  shade *= passed.x;
#endif
  // a lamp at the eye in place of the three: by the inverse square, as far as a camera's own
  // exposure does not make up for it
  vec3 to_lamp = to_key;
  float beam = 1.0, around = 1.0;
  if (headlight > 0.0) {
    float near = headlight / distance(eye, fragment.position);
    to_lamp = v;
    beam = min(near * near, 1.1);
    around = 0.12 * beam;
    shade = 1.0;
  }
  // red light travels farthest through tissue, so its edge of the shade lies farthest round
  vec3 wrap = subsurface * vec3(1.0, 0.45, 0.35);
  vec3 key = max((vec3(dot(n, to_lamp)) + wrap) / (1.0 + wrap), 0.0) * mix(0.12, 1.0, shade);
  float fill = max(0.5 + 0.5 * dot(n, to_fill), 0.0);
  float graze = 1.0 - clamp(dot(n, v), 0.0, 1.0);
  float edge = graze * graze * graze;
  float rim = edge * max(0.25 + 0.75 * dot(n, to_rim), 0.0);

  vec3 light = beam * 1.1 * KEY * key * mix(0.6, 1.0, open);
  light += around * 0.16 * FILL * fill * fill * open;
  light += around * ambient * mix(FLOOR, SKY, 0.5 + 0.5 * n.z) * open;
#if INSTRUMENTS
  // what is so near to the surface keeps light from all around from it as well
  light *= headlight > 0.0 ? 1.0 : mix(0.62, 1.0, passed.x);
#endif
  vec3 c = albedo * light;

  float mirror = max(dot(n, normalize(to_lamp + v)), 0.0);
  float sharp = pow(mirror, 90.0 * sharpness), broad = pow(mirror, 14.0 * sharpness);
  float window = pow(max(dot(n, normalize(to_fill + v)), 0.0), 50.0);
  c += beam * gloss * shade * KEY * (0.30 * sharp + 0.085 * broad);
  c += around * gloss * 0.06 * FILL * window * open;
  c += (headlight > 0.0 ? 0.0 : 1.0) * RIM * rim * open * (0.10 + 0.35 * albedo) * 1.3;

#if INSTRUMENTS
  if (tissue) c = draw_rings(c + passed.y * GLOW * (0.35 + 0.65 * albedo));
#endif

  result = vec4(encode(c), opacity);
}
