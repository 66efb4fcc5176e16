// Stomach and bowel: a smooth, wet skin with fine vessels under it.
void sceneryTissue(inout Scenery t, vec3 p, float wide) {
  vec4 broad = noise(p * 60.0 + 4.0), fine = noise(p * 300.0) * finer(300.0 * wide);
  vec3 bent = p + 0.0003 * broad.yzw;
  t.albedo *= 1.0 + 0.09 * broad.x + 0.06 * fine.x;
  t.albedo = mix(t.albedo, vec3(0.19, 0.030, 0.026),
                 0.55 * fineVessels(bent, 48.0, wide) * smoothstep(-0.1, 0.5, broad.x));
  t.albedo = mix(t.albedo, vec3(0.19, 0.040, 0.034), 0.28 * fineVessels(bent.zxy, 115.0, wide));
  t.bumps = 0.018 * broad.yzw + 0.010 * fine.yzw;
  t.waves = 0.080 * broad.yzw + 0.030 * fine.yzw;
  t.wet = 0.45 + 0.45 * smoothstep(-0.3, 0.5, broad.x);
}
