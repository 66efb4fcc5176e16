// The light of the operating room, shared by all materials: two surgical lamps, the dim room round
// them, shadow, openness to the room, and the way from radiance to a picture. Space: world, m.
// gl_LightSource[0] is the main lamp, [1] the second one; both are spot lights. [2] is the lamp at the
// eye: of a surgeon's head, or of a laparoscope; its cut-off angle is that of the beam, its exponent how
// steeply it falls off with distance, 0 to 128.

uniform sampler2DShadow lampShadow;  // see SoShadowMaps
uniform sampler2D shadowGrid;

const float kLampRadius = 0.20;  // m
const float kExposure = 1.40;
const float kHead = 1.44;        // of the lamp at the eye at full intensity

vec3 toWorld(vec3 eyeDirection) { return (gl_TextureMatrix[5] * vec4(eyeDirection, 0.0)).xyz; }
vec3 pointToWorld(vec3 eyePoint) { return (gl_TextureMatrix[5] * vec4(eyePoint, 1.0)).xyz; }

// Share of the light of a disc of `radius` at squared distance r2 from its centre, when seen
// through a blur of width b; energy is kept.
float blurredDisc(float r, float radius, float b) {
  float wide = radius + b;
  return (1.0 - smoothstep(max(radius - b, 0.0), wide, r)) * radius * radius / (wide * wide);
}

// Where the mirrored ray meets the lamp's plane: distance from the lamp's middle in the plane (xy)
// and along the ray (z); the ray that misses the front comes back far outside.
vec3 onLamp(int which, vec3 from, vec3 d) {
  vec3 axis = -toWorld(gl_LightSource[which].spotDirection);
  vec3 way = pointToWorld(gl_LightSource[which].position.xyz) - from;
  float facing = dot(d, axis), t = dot(way, axis) / max(facing, 0.05);
  vec3 q = d * t - way;
  vec3 side = normalize(cross(axis, vec3(0.0, 0.0, 1.0)));
  return vec3(dot(q, side), dot(q, cross(side, axis)), t) + (facing > 0.05 ? 0.0 : 10.0);
}

// Radiance of the two lamp heads seen from `from` in direction d: the main one has seven lights.
vec3 lampHeads(vec3 from, vec3 d, float blur) {
  vec3 q = onLamp(0, from, d);
  float b = blur * q.z + 0.004;
  // Six lights in a ring are one after folding the plane along its mirror lines.
  vec2 p = abs(q.xy), fold = vec2(-0.5, 0.866025);
  p -= 2.0 * max(dot(p, fold), 0.0) * fold;
  float glow = 1.5 * (blurredDisc(length(q.xy), 0.055, b) + blurredDisc(length(p - vec2(0.132, 0.0)), 0.055, b)) +
               0.04 * blurredDisc(length(q.xy), kLampRadius, b);
  vec3 second = onLamp(1, from, d);
  float soft = blurredDisc(length(second.xy), kLampRadius, blur * second.z + 0.01);
  // A lamp of radiance L and this radius lights a surface at 1.4 m with about L / 16.
  return 16.0 * (glow * gl_LightSource[0].diffuse.rgb + soft * gl_LightSource[1].diffuse.rgb);
}

// Radiance of the dim room in direction d; `blur` is the tangent of the half angle over which it is
// averaged, 0 = a mirror.
vec3 roomLight(vec3 d, float blur) {
  float soft = 0.08 + blur;
  vec3 floorColor = vec3(0.010, 0.012, 0.014), wall = vec3(0.045, 0.058, 0.066),
       ceiling = vec3(0.10, 0.115, 0.125);
  vec3 light = mix(floorColor, wall, smoothstep(-0.55 - soft, 0.05 + soft, d.y));
  light = mix(light, ceiling, smoothstep(0.35 - soft, 0.75 + soft, d.y));
  // A window of light along the far wall, and a screen at the side: what polished steel shows.
  float strip = smoothstep(0.10 - soft, 0.20 + 0.5 * soft, d.y) *
                (1.0 - smoothstep(0.32 - 0.5 * soft, 0.42 + soft, d.y));
  light += strip * smoothstep(0.0, 0.9, -d.z) * vec3(0.20, 0.26, 0.29);
  light += strip * smoothstep(0.5, 0.9, d.x) * vec3(0.14, 0.17, 0.19);
  // The lit end of the room behind the surgeon.
  light += smoothstep(-0.30 - soft, 0.15 + soft, d.y) * (1.0 - smoothstep(0.45 - soft, 0.85 + soft, d.y)) *
           smoothstep(0.1, 0.9, d.z) * vec3(0.15, 0.155, 0.155);
  // Two rows of panels in the ceiling.
  if (d.y > 0.25) {
    vec2 q = vec2(abs(d.x), d.z) / d.y;
    float e = 0.03 + 1.2 * blur;
    float panels = smoothstep(0.55 - e, 0.55 + e, q.x) * (1.0 - smoothstep(0.85 - e, 0.85 + e, q.x)) *
                   (1.0 - smoothstep(1.3 - e, 1.3 + e, abs(q.y + 0.2)));
    light += panels * smoothstep(0.25, 0.45, d.y) * vec3(1.7, 1.85, 2.0);
  }
  return light;
}

// What a surface at `from` mirrors in direction d: room and lamps.
vec3 mirrored(vec3 from, vec3 d, float blur) {
  return roomLight(d, blur) + lampHeads(from, d, blur);
}

// Share of the main lamp that reaches the point, 0..1: eight taps on a disc, each smoothed over four
// texels.
float lampVisible(vec3 eyePoint, vec3 eyeNormal) {
  vec4 s = gl_TextureMatrix[7] * vec4(eyePoint + 0.0015 * eyeNormal, 1.0);
  vec3 p = s.xyz / s.w;
  float size = 0.010, lit = 0.0;
  for (int k = 0; k < 8; ++k) {
    float a = 2.399963 * float(k), r = size * sqrt((float(k) + 0.5) / 8.0);
    lit += shadow2D(lampShadow, p + vec3(r * cos(a), r * sin(a), 0.0)).r;
  }
  return lit / 8.0;
}

// Light of the main lamp that comes through tissue: four places 3 to 15 mm towards the lamp, spread
// as they go deeper; each is lit where no more than that stands between. Red goes farthest.
vec3 lampThrough(vec3 eyePoint) {
  vec3 towards = normalize(gl_LightSource[0].position.xyz - eyePoint);
  vec3 sum = vec3(0.0), weight = vec3(0.13, 0.040, 0.028);
  for (int k = 0; k < 4; ++k) {
    float a = 2.399963 * float(k) + 1.0, r = 0.005 + 0.003 * float(k);
    vec4 s = gl_TextureMatrix[7] * vec4(eyePoint + (0.003 + 0.004 * float(k)) * towards, 1.0);
    sum += weight * shadow2D(lampShadow, s.xyz / s.w + vec3(r * cos(a), r * sin(a), 0.0)).r;
    weight *= vec3(0.60, 0.36, 0.30);
  }
  return sum;
}

// Squared distance from the axis of the beam at the eye; 1 at its border.
float offBeam(vec3 eyePoint) {
  vec2 q = eyePoint.xy / (tan(radians(gl_LightSource[2].spotCutoff)) * max(-eyePoint.z, 1e-4));
  return dot(q, q);
}

// Irradiance of the lamp at the eye: it throws no shadow that the eye could see, falls off with
// distance and towards the border of its beam.
vec3 headLight(vec3 eyePoint) {
  float wide = mix(0.20, 0.03, gl_LightSource[2].spotExponent / 128.0);  // m^2
  return gl_LightSource[2].diffuse.rgb * kHead * exp(-0.84 * offBeam(eyePoint)) / (dot(eyePoint, eyePoint) + wide);
}

// Irradiance of lamp `which` on a surface that faces it, without shadow: a pool of light, bright over
// a hand's breadth. The second lamp is wider and turned down: it fills.
vec3 lampLight(int which, vec3 point, out vec3 toLamp) {
  vec3 way = pointToWorld(gl_LightSource[which].position.xyz) - point;
  toLamp = normalize(way);
  float c = dot(toLamp, -toWorld(gl_LightSource[which].spotDirection));
  float across = (1.0 - c * c) / max(c * c, 0.01) * (which == 0 ? 13.0 : 7.0);
  float pool = step(0.0, c) * exp(-across) + 0.03;
  vec3 white = gl_LightSource[which].diffuse.rgb;
  if (which == 1) white = 0.20 * mix(white, vec3(dot(white, vec3(0.333))), 0.6);
  return white * pool * 2.0 / max(dot(way, way), 0.1);
}

// What SoShadowMaps knows about the place under a point of the scene.
struct Surroundings {
  float tableOpen;   // share of the room seen from the table
  float tableLit;    // share of the lamp seen from the table
  float open;        // share of the room seen from the point itself
};

Surroundings fromGrid(vec4 grid, float radius, vec3 point) {
  float top = max(grid.a * radius, 0.002);
  return Surroundings(grid.r, grid.g, mix(grid.r, grid.b, clamp(point.y / top, 0.0, 1.0)));
}

// The grid is a cube of side 2 * radius: its scale tells the radius.
float gridRadius() { return 0.5 / length((gl_TextureMatrix[6] * vec4(1.0, 0.0, 0.0, 0.0)).xyz); }

Surroundings surroundings(vec3 eyePoint, vec3 point) {
  vec2 place = (gl_TextureMatrix[6] * vec4(eyePoint, 1.0)).xy;
  return fromGrid(texture2D(shadowGrid, place), gridRadius(), point);
}

// The same over 1 cm, for the table: the grid's values are sampled by chance.
Surroundings softSurroundings(vec3 eyePoint, vec3 point) {
  vec2 place = (gl_TextureMatrix[6] * vec4(eyePoint, 1.0)).xy;
  float radius = gridRadius();
  vec2 a = vec2(0.0036, 0.0015) / radius, b = vec2(-a.y, a.x);
  vec4 grid = 0.25 * (texture2D(shadowGrid, place + a) + texture2D(shadowGrid, place - a) +
                      texture2D(shadowGrid, place + b) + texture2D(shadowGrid, place - b));
  return fromGrid(grid, radius, point);
}

// Diffuse light of the room on a surface of this normal.
vec3 ambientLight(vec3 normal) {
  vec3 above = vec3(0.085, 0.092, 0.098), below = vec3(0.014, 0.022, 0.020);
  return mix(below, above, 0.5 + 0.5 * normal.y);
}

float fresnel(float f0, float cosine) {
  float x = 1.0 - clamp(cosine, 0.0, 1.0), x2 = x * x;
  return f0 + (1.0 - f0) * x2 * x2 * x;
}

// Trowbridge-Reitz (GGX) distribution times a simple visibility term, for one lamp.
float glossLobe(vec3 n, vec3 l, vec3 v, float roughness) {
  vec3 h = normalize(l + v);
  float a2 = roughness * roughness * roughness * roughness, nh = max(dot(n, h), 0.0);
  float d = nh * nh * (a2 - 1.0) + 1.0, lh = max(dot(l, h), 0.1);
  return a2 / (12.566 * d * d * lh * lh * (roughness + 0.5));
}

// A colour as designers write it, to the share of light it sends back.
vec3 fromScreen(vec3 color) { return pow(color, vec3(2.2)); }

// Radiance at a place before the eye to displayed colour: the lens darkens towards the edge of the
// picture (by the angle, so that parts of a picture fit together), filmic curve (Narkowicz 2016), sRGB
// gamma, a dither of half a step against bands in the dark.
vec3 picture(vec3 light, vec3 eyePoint) {
  vec3 x = kExposure * light * (1.0 - 0.72 * smoothstep(0.30, 1.75, offBeam(eyePoint)));
  vec3 film = clamp(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0);
  float dither = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  return pow(film, vec3(1.0 / 2.2)) + (dither - 0.5) / 255.0;
}
