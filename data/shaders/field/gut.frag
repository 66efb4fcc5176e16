// Stomach and bowel, and the belly's wall from inside: a smooth, wet skin with fine vessels under it.
void sceneryTissue(inout Scenery t, vec3 p, float wide) {
  vec4 broad = noise(p * 60.0 + 4.0), fine = noise(turned(p) * 300.0) * finer(300.0 * wide);
  vec3 bent = turned(p) + 0.0006 * broad.yzw + 0.0002 * fine.yzw;
  t.albedo *= 1.0 + 0.09 * broad.x + 0.06 * fine.x;
  t.albedo = mix(t.albedo, vec3(0.14, 0.024, 0.022), 0.32 * fineVessels(bent, 48.0, wide, broad.x));
  t.albedo = mix(t.albedo, vec3(0.15, 0.032, 0.028), 0.16 * fineVessels(bent.zxy, 115.0, wide, -broad.x));
  t.bumps = 0.018 * broad.yzw + 0.010 * fine.yzw;
  t.waves = 0.080 * broad.yzw + 0.030 * fine.yzw;
  t.wet = 0.45 + 0.45 * smoothstep(-0.3, 0.5, broad.x);
}
