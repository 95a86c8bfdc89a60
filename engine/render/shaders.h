/// The renderer's shader programs as GLSL 3.30. No `pow`, no loops over lights: written for a CPU that runs them.
#pragma once

namespace trocar::render {

// Attributes: 0 position, 1 normal, 2 colour; for each instance 3–5 the rows of X_WM, 6 base colour, 7 material
// (roughness, metallic, emission).

/// Light is added up in squared colours (gamma 2), so that the square root at the end gives back an unlit colour
/// exactly.
inline constexpr const char* kSurfaceVertex = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 colour;
layout(location = 3) in vec4 row0;
layout(location = 4) in vec4 row1;
layout(location = 5) in vec4 row2;
layout(location = 6) in vec4 base;
layout(location = 7) in vec4 material;
uniform mat4 clip_from_world;
uniform mat4 shadow_from_world;
uniform float shadow_texel_m;
out vec3 p_W;
out vec3 n_W;
out vec3 p_shadow;
flat out vec4 surface;
out vec4 tint;
void main() {
  vec4 local = vec4(position, 1.0);
  p_W = vec3(dot(row0, local), dot(row1, local), dot(row2, local));
  vec3 x = vec3(row0.x, row1.x, row2.x);
  vec3 y = vec3(row0.y, row1.y, row2.y);
  vec3 z = vec3(row0.z, row1.z, row2.z);
  n_W = normalize(cross(y, z) * normal.x + cross(z, x) * normal.y + cross(x, y) * normal.z);
  // Looked up a little outside of the surface, so that it does not shadow itself.
  p_shadow = (shadow_from_world * vec4(p_W + 1.2 * shadow_texel_m * n_W, 1.0)).xyz;
  vec4 mixed = base * colour;
  tint = vec4(mixed.rgb * mixed.rgb, mixed.a);
  surface = material;
  gl_Position = clip_from_world * vec4(p_W, 1.0);
}
)";

/// Before it come the version and some of: `SOFT_SHADOW` or `HARD_SHADOW`; `MATTE`, for surfaces that mirror nothing,
/// which are most of a picture.
inline constexpr const char* kSurfaceFragment = R"(
in vec3 p_W;
in vec3 n_W;
in vec3 p_shadow;
flat in vec4 surface;
in vec4 tint;
uniform vec4 eye;            // w 1: a point; w 0: the direction towards the viewer
uniform vec3 to_light;
uniform vec3 background_top;  // as shown, not squared
uniform vec3 background_bottom;
uniform vec3 fade;           // begin, 1 / (end - begin), 1 / picture height
uniform sampler2DShadow shadow_map;
uniform float shadow_texel;
out vec4 shown;

float lit_share() {
#if defined(SOFT_SHADOW)
  // Each tap is itself a mean of four texels: together they smooth over four by four.
  float s = 0.95 * shadow_texel;
  return 0.25 * (texture(shadow_map, p_shadow + vec3(-s, -s, 0.0)) + texture(shadow_map, p_shadow + vec3(s, -s, 0.0)) +
                 texture(shadow_map, p_shadow + vec3(-s, s, 0.0)) + texture(shadow_map, p_shadow + vec3(s, s, 0.0)));
#elif defined(HARD_SHADOW)
  return texture(shadow_map, p_shadow);
#else
  return 1.0;
#endif
}

#ifndef MATTE
vec3 glossy(vec3 n, float direct) {
  float roughness = surface.x;
  float metallic = surface.y;
  vec3 v = normalize(eye.xyz - eye.w * p_W);
  float nv = max(dot(n, v), 0.0);
  float nh = max(dot(n, normalize(to_light + v)), 0.0);
  float a = max(roughness * roughness, 0.02);
  float bell = nh * nh * (a * a - 1.0) + 1.0;
  float lobe = a * a / (bell * bell * (0.4 + 4.0 * a));
  float edge = (1.0 - nv) * (1.0 - nv);
  vec3 f0 = mix(vec3(0.04), tint.rgb, metallic);
  vec3 mirror = f0 + (vec3(1.0) - f0) * (edge * edge * (0.9 - 0.85 * roughness));
  // A studio to be mirrored: dark floor, light from above, a bright strip over the viewer's shoulder.
  vec3 r = 2.0 * dot(n, v) * n - v;
  float up = clamp(0.5 + (0.9 - 0.5 * roughness) * r.z, 0.0, 1.0);
  float strip = clamp(1.0 - 2.2 * abs(r.x - 0.5), 0.0, 1.0) * (1.0 - roughness);
  vec3 room = mix(vec3(0.10, 0.10, 0.11), vec3(0.74, 0.78, 0.84), up * up) + vec3(0.42 * strip);
  return mirror * (room * (0.3 + 0.7 * metallic) + vec3(1.3 * lobe * direct));
}
#endif

void main() {
  vec3 n = normalize(n_W);
  float direct = max(dot(n, to_light), 0.0) * lit_share();
  vec3 ambient = mix(vec3(0.105, 0.10, 0.095), vec3(0.34, 0.365, 0.40), 0.5 + 0.5 * n.z);
  vec3 light = ambient + vec3(1.02, 0.99, 0.94) * direct;
#ifdef MATTE
  vec3 lit = tint.rgb * light;
#else
  vec3 lit = tint.rgb * (1.0 - surface.y) * light + glossy(n, direct);
#endif
  lit = mix(lit, tint.rgb, surface.z);
  vec3 behind = mix(background_top, background_bottom, gl_FragCoord.y * fade.z);
  float far_share = clamp((length(p_W.xy) - fade.x) * fade.y, 0.0, 1.0);
  shown = vec4(mix(sqrt(lit), behind, far_share * far_share * (3.0 - 2.0 * far_share)) * tint.a, tint.a);
}
)";

inline constexpr const char* kShadowVertex = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 3) in vec4 row0;
layout(location = 4) in vec4 row1;
layout(location = 5) in vec4 row2;
uniform mat4 clip_from_world;
void main() {
  vec4 local = vec4(position, 1.0);
  gl_Position = clip_from_world * vec4(dot(row0, local), dot(row1, local), dot(row2, local), 1.0);
}
)";

inline constexpr const char* kShadowFragment = R"(#version 330 core
void main() {}
)";

/// A triangle over the whole picture at the greatest depth; needs no buffer.
inline constexpr const char* kBackgroundVertex = R"(#version 330 core
void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  gl_Position = vec4(corner, 1.0, 1.0);
}
)";

inline constexpr const char* kBackgroundFragment = R"(#version 330 core
uniform vec3 background_top;
uniform vec3 background_bottom;
uniform float height_scale;
out vec4 shown;
void main() { shown = vec4(mix(background_top, background_bottom, gl_FragCoord.y * height_scale), 1.0); }
)";

/// Corners come from the vertex number: 0 origin, 1 u, 2 v, 3 u + v.
inline constexpr const char* kQuadVertex = R"(#version 330 core
uniform mat4 clip_from_world;
uniform vec3 origin;
uniform vec3 u;
uniform vec3 v;
out vec2 at;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  at = vec2(corner.x, 1.0 - corner.y);
  gl_Position = clip_from_world * vec4(origin + corner.x * u + corner.y * v, 1.0);
}
)";

/// The texture is premultiplied, so that texels of no opacity do not bleed.
inline constexpr const char* kQuadFragment = R"(#version 330 core
in vec2 at;
uniform sampler2D picture;
uniform float opacity;
out vec4 shown;
void main() { shown = texture(picture, at) * opacity; }
)";

}  // namespace trocar::render
