// Skin painted with iodine: matt, with pores.
void sceneryTissue(inout Scenery t, vec3 p, float wide) {
  vec4 broad = noise(p * 40.0), pores = noise(p * 900.0) * finer(900.0 * wide);
  t.albedo *= 1.0 + 0.07 * broad.x + 0.08 * pores.x;
  t.bumps = 0.03 * pores.yzw;
  t.wet = 0.12;
}
