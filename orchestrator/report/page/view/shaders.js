const shaderStart = `#version 300 es
precision highp float;
uniform mat3 turn;
uniform vec3 eye;
uniform vec4 lens;
vec4 seen(vec3 place) { return vec4(lens.xy * place.xy, lens.z * place.z + lens.w, -place.z); }
`;

/** The light comes from the left above the eye. */
const lightShader = `
vec3 lit(vec3 colour, vec3 normal) {
  float towards = 0.5 + 0.5 * dot(normal, normalize(vec3(-0.35, 0.6, 0.9)));
  return colour * (0.36 + 0.64 * towards * towards);
}
`;

/** A square in front of each particle, on which the sphere is found by where the ray meets it. */
const sphereShaders = {
  vertex: shaderStart + `
uniform float share, duration, turning, slip, low, slice, fast, pixel;
uniform int colouring;
uniform highp sampler2D palette;
layout(location = 0) in vec3 before;
layout(location = 1) in vec3 after;
layout(location = 2) in float size;
layout(location = 3) in uint particleClass;
flat out vec3 centre;
flat out float radius;
flat out vec3 colour;
out vec3 ray;

int entry(vec3 move) {
  if (colouring == 0) return int(particleClass);
  vec3 velocity = move / duration;
  if (colouring == 1) return int(255.0 * clamp(length(velocity) / fast, 0.0, 1.0));
  vec3 middle = before + 0.5 * move;
  vec3 wall = turning * vec3(middle.z, 0.0, -middle.x);
  return distance(velocity, wall) < slip ? 1 : 0;
}

void main() {
  vec3 move = after - before;
  move.y -= slice * round(move.y / slice);
  vec3 place = before + share * move;
  place.y = low + mod(place.y - low, slice);
  centre = turn * (place - eye);
  radius = size;
  colour = texelFetch(palette, ivec2(entry(move), 0), 0).rgb;
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  float away = length(centre);
  if (away <= size) { gl_Position = vec4(2.0, 2.0, 2.0, 1.0); return; }
  vec3 right = normalize(cross(centre, vec3(0.0, 1.0, 0.0)));
  vec3 up = cross(right, centre / away);
  float reach = size * away / sqrt(away * away - size * size) + pixel * away;
  ray = centre + reach * (corner.x * right + corner.y * up);
  gl_Position = seen(ray);
}
`,
  fragment: shaderStart + lightShader + `
flat in vec3 centre;
flat in float radius;
flat in vec3 colour;
in vec3 ray;
out vec4 shown;

void main() {
  vec3 direction = normalize(ray);
  vec3 nearest = dot(centre, direction) * direction;
  float off = distance(nearest, centre);
  float covered = clamp(0.5 + (radius - off) / fwidth(off), 0.0, 1.0);
  if (covered == 0.0) discard;
  vec3 hit = nearest - sqrt(max(radius * radius - off * off, 0.0)) * direction;
  vec3 normal = (hit - centre) / radius;
  float edge = 0.62 + 0.38 * smoothstep(0.0, 0.55, -dot(normal, direction));
  vec4 place = seen(hit);
  gl_FragDepth = 0.5 + 0.5 * place.z / place.w;
  shown = vec4(edge * lit(colour, normal), covered);
}
`};

/** The steel of one sector after the other, turned about the axis. */
const linerShaders = {
  vertex: shaderStart + `
uniform float millAngle, pitch;
layout(location = 0) in vec3 place;
layout(location = 1) in vec3 normal;
out vec3 facing;
vec3 turned(vec3 v, float angle) {
  return vec3(v.x * cos(angle) + v.z * sin(angle), v.y, v.z * cos(angle) - v.x * sin(angle));
}
void main() {
  float angle = millAngle + pitch * float(gl_InstanceID);
  facing = turn * turned(normal, angle);
  gl_Position = seen(turn * (turned(place, angle) - eye));
}
`,
  fragment: shaderStart + lightShader + `
uniform vec3 colour;
in vec3 facing;
out vec4 shown;
void main() { shown = vec4(lit(colour, normalize(facing)), 1.0); }
`};
