// Fat: yellow cushions with fine red vessels; also the bowel's fatty apron, and the floor between.
void sceneryTissue(inout Scenery t, vec3 p, float wide) {
  vec4 broad = noise(p * 70.0), fine = noise(turned(p) * 420.0 + 3.1) * finer(420.0 * wide);
  float yellow = smoothstep(0.0, 0.10, t.albedo.g - 0.5 * t.albedo.r);
  t.albedo *= 1.0 + 0.10 * broad.x + (0.05 + 0.08 * yellow) * fine.x;
  float vessel = fineVessels(turned(p) + 0.0003 * broad.yzw, 62.0, wide, broad.x);
  t.albedo = mix(t.albedo, vec3(0.16, 0.020, 0.014), 0.75 * vessel * (0.4 + 0.6 * yellow));
  float rough = 0.4 + 0.6 * yellow;  // the peritoneum between is smooth
  t.bumps = 0.020 * broad.yzw + 0.030 * rough * fine.yzw;
  t.waves = 0.070 * broad.yzw + 0.035 * rough * fine.yzw;
  t.wet = (0.6 + 0.4 * yellow) * (0.35 + 0.30 * smoothstep(-0.2, 0.6, broad.x));
}
