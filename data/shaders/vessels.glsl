// Vessels on the cut faces of tissue, exactly where they run: the pixel's place at rest is tested
// against the segments in its bin.
uniform sampler2D vesselBins, vesselList;
uniform vec3 vesselLow, vesselDims;  // of the bins: place of the first one, m; numbers along the axes
uniform float vesselBin;             // side of a bin, m; 0: no vessels are known
uniform vec2 vesselRows;             // of the two textures; a row has 1024 texels

vec4 texelOf(sampler2D list, float number, float rows) {
  float row = floor(number / 1024.0);
  return texture2D(list, vec2((number - 1024.0 * row + 0.5) / 1024.0, (row + 0.5) / rows));
}

struct Vessel {
  float off;     // distance of the place from the wall's inner side, m; below 0 in the lumen
  float wall;    // thickness of the wall, m
  float radius;  // of the lumen, m; 0: no vessel is near
  float kind;    // 0 portal vein, 1 hepatic vein, 2 artery, 3 bile duct
  vec3 out_;     // unit, away from the axis
};

// As wallOf() in organ/picture/picture_vessels.h.
float wallOf(float kind, float radius) {
  if (kind < 0.5) return 0.00012 + 0.20 * radius;
  if (kind < 1.5) return 0.00006 + 0.05 * radius;
  if (kind < 2.5) return 0.00012 + 0.35 * radius;
  return 0.00012 + 0.30 * radius;
}

// The vessel into whose lumen or wall the place reaches deepest.
Vessel vesselAt(vec3 p) {
  Vessel found = Vessel(1.0, 0.0, 0.0, 0.0, vec3(0.0));
  if (vesselBin == 0.0) return found;
  vec3 cell = floor((p - vesselLow) / vesselBin);
  if (any(lessThan(cell, vec3(0.0))) || any(greaterThanEqual(cell, vesselDims))) return found;
  vec2 range = texelOf(vesselBins, (cell.z * vesselDims.y + cell.y) * vesselDims.x + cell.x, vesselRows.x).rg;
  for (float i = 0.0; i < range.y; i += 1.0) {
    vec4 start = texelOf(vesselList, 2.0 * (range.x + i), vesselRows.y);
    vec4 end = texelOf(vesselList, 2.0 * (range.x + i) + 1.0, vesselRows.y);
    vec3 way = end.xyz - start.xyz, from = p - start.xyz;
    vec3 away = from - clamp(dot(from, way) / max(dot(way, way), 1e-12), 0.0, 1.0) * way;
    float off = length(away) - start.w, wall = wallOf(end.w, start.w);
    if (off - wall < found.off - found.wall)
      found = Vessel(off, wall, start.w, end.w, away / max(length(away), 1e-6));
  }
  return found;
}

vec3 wallColour(float kind) {
  if (kind < 0.5) return vec3(0.25, 0.138, 0.104);  // portal vein, in its pale sheath
  if (kind < 1.5) return vec3(0.20, 0.070, 0.062);
  if (kind < 2.5) return vec3(0.27, 0.135, 0.105);
  return vec3(0.170, 0.130, 0.066);
}

vec3 lumenColour(float kind) {
  if (kind < 1.5) return vec3(0.030, 0.0022, 0.0035);
  return kind < 2.5 ? vec3(0.085, 0.004, 0.004) : vec3(0.070, 0.060, 0.006);
}
