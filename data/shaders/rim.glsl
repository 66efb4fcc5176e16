// The rim of a cut: a thin line of blood, to be seen also where the lips touch.
//
// Vertices of the skin at the rim have the cut share -1 (wound/wound_brick.h). Between them and the
// skin's other vertices the share falls to 0; from its slope follows the distance from the rim.
// Returns the share of cut tissue, 0 to 1, or else minus the strength of the line, 0 to 1.
//
// place: position at rest, m.
float cutOrRim(float share, vec3 place) {
  if (share >= 0.0) return share;
  vec2 slope = vec2(dFdx(share), dFdy(share));  // per pixel
  float steep = max(length(slope), 1e-6);
  // What a pixel covers across the line, and how far off the line is; m.
  float pixel = length(dFdx(place) * slope.x + dFdy(place) * slope.y) / steep;
  float off = (1.0 + share) / steep * pixel;
  float half_ = max(0.00025, 0.45 * pixel);
  return -1.0 + smoothstep(half_, 1.8 * half_, off);
}
