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
// runs over a slope: thin blood gathers in rivulets there, and its borders are broken up by noise
// (`rough`, -1 to 1). n: normal; upright surfaces have the longest rivulets.
vec2 bloodAt(vec3 rest, float rough, vec3 n) {
  if (bloodPerMetre.x == 0.0) return vec2(0.0);
  vec2 thick = 2.0 * texture3D(bloodMap, (rest - bloodLow) * bloodPerMetre).ra;
  if (thick.x + thick.y == 0.0) return thick;
  vec3 down = vec3(0.0, -1.0, 0.0) + n * n.y;
  float steep = length(down);
  down /= max(steep, 1e-3);
  // Stretched along the slope, about the organ's middle: so it hardly bends with the normal.
  vec3 across = rest - bloodLow - 0.5 / bloodPerMetre;
  across -= 0.86 * dot(across, down) * down;
  float stream = noise(across * 170.0).x + 0.5 * noise(across * 430.0).x;
  float thin = (1.0 - smoothstep(0.10, 0.60, thick.x)) * smoothstep(0.15, 0.5, steep);
  thick.x *= mix(1.0, smoothstep(-0.75, 0.45, stream) * 1.5, thin);
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
