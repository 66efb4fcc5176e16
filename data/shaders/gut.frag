// Stomach and bowel: a smooth, wet skin with fine vessels under it.
void sceneryTissue(inout Tissue t, vec3 p, float wide) {
  vec4 broad = noise(p * 60.0 + 4.0), middle = noise(p * 170.0), fine = noise(p * 500.0) * finer(500.0 * wide);
  t.albedo *= 1.0 + 0.08 * broad.x + 0.06 * middle.x + 0.05 * fine.x;
  t.albedo = mix(t.albedo, vec3(0.19, 0.030, 0.026), 0.55 * fineVessels(p, 48.0, wide));
  t.albedo = mix(t.albedo, vec3(0.19, 0.040, 0.034), 0.30 * fineVessels(p.zxy, 115.0, wide));
  t.bumps = 0.012 * broad.yzw + 0.012 * middle.yzw + 0.008 * fine.yzw;
  t.waves = 0.055 * broad.yzw + 0.050 * middle.yzw + 0.020 * fine.yzw;
  t.wet = 0.45 + 0.45 * smoothstep(-0.3, 0.5, broad.x);
}
