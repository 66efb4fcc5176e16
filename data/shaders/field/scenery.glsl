// Still tissue round the organ, in the operative field: its light, simpler than that of the organ
// (wet.glsl), and blood on it. Each kind's file defines
//   void sceneryTissue(inout Scenery t, vec3 p, float wide);
// t comes with the model's colour and a thin film; p: position in the model, m; wide: how far it
// moves within a pixel.
varying vec3 eyePosition;
varying vec3 objectPosition;
varying vec3 objectNormal;
varying vec3 baseColor;
uniform sampler2D pool;  // depth of blood on the table: 1 m square round the origin, 1 stands for 5 mm

struct Scenery {
  vec3 albedo;
  vec3 bumps;  // slope of the tissue
  vec3 waves;  // slope of the film on it
  float wet;   // how thick the film is, 0 to 1
};

void sceneryTissue(inout Scenery t, vec3 p, float wide);

// Turned against the axes, so that no lattice of a noise shows.
vec3 turned(vec3 p) {
  return mat3(0.36, 0.48, -0.80, -0.80, 0.60, 0.0, 0.48, 0.64, 0.60) * p;
}

// Fine vessels in a skin: curves where a noise vanishes; 0 to 1. Waves per metre. Where `some`, -1 to 1, is
// low they thin out and end.
float fineVessels(vec3 p, float perMetre, float wide, float some) {
  float soft = 0.012 + 0.035 * smoothstep(0.0, 0.7, some) + perMetre * wide;
  return smoothstep(-0.05, 0.35, some) * (1.0 - smoothstep(0.0, soft, abs(noise(p * perMetre).x))) * 0.05 / (0.02 + soft);
}

// Blood of the pool, deepest in the grooves. point: world, m.
void flood(inout Scenery t, vec3 point) {
  // The pool is one of centimetres; its border is drawn out.
  vec2 q = mat2(0.80, 0.60, -0.60, 0.80) * point.xz;  // so that no lattice of the noise shows
  vec3 wave = noise2(q.yx * 22.0 + 3.0), broad = noise2(mat2(0.6, 0.8, -0.8, 0.6) * q * 66.0);
  vec3 small = noise2(q * 230.0) + 0.5 * noise2(mat2(0.6, 0.8, -0.8, 0.6) * q * 520.0);
  vec2 drawn = 0.007 * vec2(broad.x, noise2(q * 60.0 + 7.0).x) + 0.014 * vec2(wave.x, wave.y) + 0.0025 * small.x;
  float depth = 5.0 * texture2D(pool, point.xz + 0.5 + drawn).r;
  if (depth < 0.01) return;
  depth *= 1.6 - 1.4 * smoothstep(-0.008, 0.006, point.y + 0.0015 * small.x);
  // What bulges out of it is wetted in smears.
  depth *= 1.0 - smoothstep(0.008, 0.017, point.y + 0.007 * broad.x + 0.0035 * small.x);
  depth = max(depth - 0.05 * (1.0 + small.x), 0.0);
  t.albedo = underBlood(t.albedo, vec2(0.5 * depth, 0.0));
  float covered = smoothstep(0.05, 0.6, depth);
  t.bumps *= 1.0 - 0.8 * covered;
  t.waves *= 1.0 - 0.8 * covered;
  t.wet = mix(t.wet, 0.9, covered);
}

void main() {
  vec3 n0 = normalize(objectNormal);
  if (dot(gl_NormalMatrix * n0, eyePosition) > 0.0) n0 = -n0;
  vec3 point = pointToWorld(eyePosition), v = toWorld(-normalize(eyePosition));
  // What stands round the organ is lit less than the organ: the eye goes there.
  Scenery t = Scenery(0.40 * fromScreen(baseColor), vec3(0.0), vec3(0.0), 0.3);
  sceneryTissue(t, objectPosition, widest(objectPosition));
  if (point.y < 0.03 && abs(point.x) < 0.5 && abs(point.z) < 0.5) flood(t, point);

  vec3 flatEye = normalize(gl_NormalMatrix * n0);
  vec3 n = toWorld(normalize(gl_NormalMatrix * (n0 - t.bumps + dot(t.bumps, n0) * n0)));
  vec3 film = toWorld(normalize(gl_NormalMatrix * (n0 - t.waves + dot(t.waves, n0) * n0)));
  float lit = lampVisible(eyePosition, flatEye);
  // Over the table the organ's occlusion fades with the height.
  vec4 grid = texture2D(shadowGrid, (gl_TextureMatrix[6] * vec4(eyePosition, 1.0)).xy);
  float open = mix(grid.r, 1.0, clamp(point.y / 0.09, 0.0, 1.0));
  vec3 l0, l1;
  vec3 e0 = lampLight(0, point, l0), e1 = lampLight(1, point, l1);
  vec3 eh = headLight(eyePosition) * (0.35 + 0.65 * open);
  float facing = max(dot(n, v), 0.0);
  const vec3 kWrap = vec3(0.28, 0.10, 0.07);  // light comes round the terminator, red farthest
  vec3 soft = max((vec3(dot(n, l0)) + kWrap) / (1.0 + kWrap), 0.0);
  // What is hidden from the room is lit by the tissue round it, in red.
  vec3 hidden = vec3(open) / (1.0 - min(3.0 * t.albedo, 0.85) * (1.0 - open));
  vec3 diffuse = eh * facing * (0.15 + 0.85 * facing) + 1.25 * e0 * soft * lit +
                 0.4 * e1 * max(dot(n, l1), 0.0) * hidden + 0.6 * ambientLight(n) * hidden;
  vec3 color = t.albedo * diffuse;
  // Sky in the film, and glints of the lamps where it is thick enough.
  color += min(fresnel(0.028, facing), 0.20) * vec3(0.10, 0.11, 0.12) * open * smoothstep(-0.3, 0.6, n.y);
  vec3 glints = 0.014 * eh * glossLobe(film, v, v, 0.19) +
                0.010 * e0 * lit * max(dot(film, l0), 0.0) * glossLobe(film, l0, v, 0.20);
  color += t.wet * t.wet * glints;
  gl_FragColor = vec4(picture(color, eyePosition), 1.0);
}
