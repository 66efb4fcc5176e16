// Blood on the organ: how thick it is, and how it looks; and what heat has done to the tissue.
uniform sampler3D bloodMap;   // liquid and clotted; 1 stands for 2 mm
uniform vec3 bloodLow;        // of the map, at rest, m
uniform vec3 bloodPerMetre;   // 0: there is no blood

uniform sampler3D heatMap;    // coagulated; burnt: up to 0.4 dried out, above charred
uniform vec3 heatLow;         // of the map, at rest, m
uniform vec3 heatPerMetre;    // 0: nothing was heated

uniform sampler3D structureMap;     // tumour, and any other structure
uniform vec3 structureLow;          // of the map, at rest, m
uniform vec3 structurePerMetre;     // 0: there is none

// A noise drawn out downhill, -1 to 1: that of the way along the slope and the height. q: along the slope
// and upwards, m.
float streaks(vec2 q) {
  q.x += 0.0045 * noise2(q * vec2(30.0, 38.0)).x + 0.0014 * noise2(q * vec2(90.0, 120.0) + 3.0).x;
  q.y *= 0.15;
  return 0.75 * noise2(q * 190.0 + 0.7).x + 0.40 * noise2(q * 410.0 + 5.3).x;
}

// How much of the tissue is tumour (x) and another structure (y), 0 to 1; from cell to cell it goes
// over slowly.
vec2 structureAt(vec3 rest) {
  if (structurePerMetre.x == 0.0) return vec2(0.0);
  vec3 at = (rest - structureLow) * structurePerMetre;
  if (any(lessThan(at, vec3(0.0))) || any(greaterThan(at, vec3(1.0)))) return vec2(0.0);
  return texture3D(structureMap, at).ra;
}

// How much heat has coagulated (x) and burnt (y) tissue, 0 to 1.
vec2 heatAt(vec3 rest) {
  if (heatPerMetre.x == 0.0) return vec2(0.0);
  vec3 at = (rest - heatLow) * heatPerMetre;
  if (any(lessThan(at, vec3(0.0))) || any(greaterThan(at, vec3(1.0)))) return vec2(0.0);
  return texture3D(heatMap, at).ra;
}

// Thickness of liquid (x) and clotted (y) blood, mm. The map is that of cells, far wider than what
// runs over a slope: there blood runs in rivulets, thick ones with bare tissue between, the more of them
// the more blood there is. Borders are broken up by noise (`rough`, -1 to 1). n: normal; upright
// surfaces have the longest rivulets. cut: 1 on a cut face, whose grains stand out of all but deep blood.
vec2 bloodAt(vec3 rest, float rough, vec3 n, float cut) {
  if (bloodPerMetre.x == 0.0) return vec2(0.0);
  vec2 here = 2.0 * texture3D(bloodMap, (rest - bloodLow) * bloodPerMetre).ra;
  if (here.x + here.y == 0.0) return vec2(0.0);  // as deferred/mark_rich.frag has it
  // Looked up a few millimetres aside, so that borders do not follow the cells.
  vec3 aside = 0.0022 * noise(rest * 95.0 + 2.0).yzw + 0.0006 * noise(rest.zxy * 310.0).yzw;
  vec2 thick = 2.0 * texture3D(bloodMap, (rest + aside - bloodLow) * bloodPerMetre).ra;
  thick *= smoothstep(0.0, 0.08, here.x + here.y);
  if (thick.x + thick.y == 0.0) return thick;
  float steep = sqrt(max(1.0 - n.y * n.y, 0.0));
  float stream = mix(streaks(rest.zy), streaks(rest.xy), smoothstep(-0.4, 0.4, abs(n.z) - abs(n.x)));
  const float kRivulet = 0.8;  // mm thick
  float covered = thick.x / kRivulet, from = mix(0.50, -1.05, covered);
  float rivulet = kRivulet * smoothstep(from - 0.15, from + 0.60, stream) + 0.10 * smoothstep(0.04, 0.40, covered);
  thick.x = mix(thick.x, rivulet, (1.0 - cut) * smoothstep(0.20, 0.5, steep) * (1.0 - smoothstep(0.8, 1.2, covered)));
  thick.x = mix(thick.x, 0.06 * smoothstep(0.0, 0.5, thick.x) * (1.0 + rough) + 0.08 * max(thick.x - 0.35, 0.0) + max(thick.x - 1.4, 0.0), cut);
  // Between cells thickness falls off in straight lines; a border that starts where the noise has it hides them.
  // On a slope it is drawn out into tongues.
  float ragged = mix(rough, 0.9 * stream, 0.8 * smoothstep(0.15, 0.5, steep));
  vec2 least = vec2(0.018 + 0.12 * smoothstep(-0.5, 0.9, ragged));
  // It thins out towards the border, so that the surface under it is seen there.
  vec2 above = max(thick - 0.7 * least, 0.0);
  return above * smoothstep(-0.02, 0.20, above);
}

// What is seen of a surface of this colour under blood: liquid absorbs green and blue within a twentieth
// of a millimetre, red within a seventh of one; behind that is the blood's own red, the darker the deeper it is.
vec3 underBlood(vec3 colour, vec2 thick) {
  vec3 through = exp(-thick.x * vec3(7.0, 18.0, 20.0) - thick.y * vec3(8.0, 20.0, 22.0));
  vec3 fresh = mix(vec3(0.042, 0.0018, 0.0022), vec3(0.023, 0.0010, 0.0014), smoothstep(0.12, 1.1, thick.x));
  vec3 own = mix(fresh, vec3(0.016, 0.0014, 0.0014), thick.y / (thick.x + thick.y + 1e-4));
  return colour * through + own * (1.0 - through);
}
