// The cut edge of the abdominal wall's muscles: layers of fibres that run along the edge.
void sceneryTissue(inout Scenery t, vec3 p, float wide) {
  vec4 fibre = noise(p * vec3(120.0, 700.0, 120.0)) * finer(700.0 * wide), broad = noise(p * 90.0 + 2.0);
  t.albedo *= 1.0 + 0.30 * fibre.x + 0.15 * broad.x;
  t.bumps = 0.05 * vec3(0.2 * fibre.y, fibre.z, 0.2 * fibre.w) + 0.02 * broad.yzw;
  t.waves = 0.06 * broad.yzw + 0.02 * fibre.yzw;
  t.wet = 0.6;
}
