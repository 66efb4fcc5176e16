// Bare vessels: walls under a film of fluid, smeared with blood in places.
varying vec3 eyePosition;
varying vec3 objectPosition;
varying vec3 objectNormal;
varying vec3 baseColor;

const float kBend = 300.0;  // 1/m: of a thin vessel

void main() {
  vec3 n0 = normalize(objectNormal);
  if (dot(gl_NormalMatrix * n0, eyePosition) > 0.0) n0 = -n0;
  vec3 p = objectPosition;
  vec4 smear = noise(p * 330.0), fine = noise(p.zxy * 1100.0);
  Tissue t;
  t.albedo = fromScreen(baseColor) * (1.0 + 0.10 * smear.x + 0.08 * fine.x);
  float blood = smoothstep(-0.25, 0.45, smear.x + 0.35 * fine.x);
  t.albedo = mix(t.albedo, vec3(0.085, 0.0055, 0.0050), 0.75 * blood);
  t.bumps = 0.020 * fine.yzw;
  t.waves = 0.050 * smear.yzw;
  t.wet = 0.55 + 0.35 * blood;
  t.lost = 0.06;
  t.cut = 0.0;
  vec3 point = pointToWorld(eyePosition);
  Surroundings around = surroundings(eyePosition, point);
  around.open = max(around.open, 0.30);  // vessels are bared in wounds, as in liver()
  gl_FragColor = vec4(wetTissue(t, n0, kBend, around, eyePosition), 1.0);
}
