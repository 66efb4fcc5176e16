// Living liver: a matt mahogany capsule under a thin film of fluid, which glints in places; where it
// is cut, granular moist parenchyma with vessels. Colours are linear. Positions and normals in
// object space, m, unless a name says otherwise.

// Patterns on the tissue, by its place at rest. Each is a noise, its gradient in yzw. They are turned
// against each other, so that no lattice shows.
struct Patterns {
  vec4 low, broad, middle, fine;  // waves of some 40, 18, 7 and 2.5 mm
  float lost;                     // how much of the film's roughness is finer than a pixel
};

Patterns patternsAt(vec3 p, float wide) {
  const mat3 turn = mat3(0.36, 0.48, -0.80, -0.80, 0.60, 0.0, 0.48, 0.64, 0.60);
  Patterns at;
  at.low = noise(p * 26.0 + 1.3);
  at.broad = noise(turn * p * 55.0);
  at.broad.yzw = at.broad.yzw * turn;
  at.middle = noise(p * 150.0 + 9.1);
  at.fine = noise(turn * p * 420.0 + 3.7) * finer(420.0 * wide);
  at.fine.yzw = at.fine.yzw * turn;
  at.lost = 0.03 * (1.0 - finer(420.0 * wide)) + 0.04 * (1.0 - finer(150.0 * wide));
  return at;
}

vec3 capsuleColour(Patterns at, vec3 base) {
  vec3 colour = base * vec3(0.60, 0.98, 1.07);
  colour *= 1.0 + 0.13 * at.low.x + 0.08 * at.broad.x + 0.05 * at.middle.x + 0.07 * at.fine.x;
  // A faint haze where the capsule is thicker.
  float haze = smoothstep(0.0, 0.8, at.low.x - 0.4 * at.broad.x);
  return mix(colour, vec3(0.20, 0.085, 0.070), 0.14 * haze);
}

#ifndef PLAIN

// Vessels of an organ of which no vessels are known: curves in space, where two noises vanish together.
// Walls are pale, lumens full of dark blood.
vec3 withCurves(vec3 inside, Patterns at, vec3 p) {
  float large = length(vec2(at.broad.x, noise(p.zxy * 50.0 + 17.3).x));
  float small = length(vec2(at.middle.x, noise(p.zxy * 140.0 + 5.1).x));
  float wall = max(1.0 - smoothstep(0.17, 0.23, large), 0.7 - 0.7 * smoothstep(0.14, 0.22, small));
  float lumen = max(1.0 - smoothstep(0.11, 0.15, large), 0.8 - 0.8 * smoothstep(0.07, 0.13, small));
  inside = mix(inside, vec3(0.26, 0.115, 0.085), 0.6 * wall);
  return mix(inside, vec3(0.050, 0.0035, 0.0045), lumen);
}

// seen: 0 where lobules are finer than a pixel.
vec3 parenchymaColour(Patterns at, vec4 lobule, float seen, vec4 grain, vec3 p) {
  vec3 inside = vec3(0.080, 0.0175, 0.0130) * (1.0 + 0.10 * at.broad.x + 0.10 * at.middle.x);
  // Lobules: each of its own shade, in a darker net, with a dark vein in the middle.
  float off = length(lobule.xyz);
  inside = mix(inside, vec3(0.118, 0.030, 0.021), 0.70 * mix(0.5, smoothstep(-0.5, 0.6, at.fine.x + 0.3 * grain.x) * smoothstep(0.12, 0.30, off), seen));
  inside = mix(inside, vec3(0.046, 0.0055, 0.0055), 0.36 * mix(0.25, lobule.w, seen));
  inside = mix(inside, vec3(0.060, 0.0080, 0.0070), 0.6 * seen * (1.0 - smoothstep(0.06, 0.16, off)));
  return vesselBin > 0.0 ? inside : withCurves(inside, at, p);
}

#endif

// share: as cutOrRim() gives it; base: of the capsule; n: unit normal. With PLAIN: the tissue's skin
// without blood, marks of heat and structures below it.
Tissue tissueAt(vec3 p, float wide, float share, vec3 base, vec3 n) {
  Patterns at = patternsAt(p, wide);
  // The edge of a cut wanders a little; the capsule there is a thin pale line.
  float wandering = share + (0.08 * at.middle.x + 0.14 * at.fine.x) * step(0.02, share);
  float border = smoothstep(0.34, 0.46, wandering);
  float pale = smoothstep(0.16, 0.28, wandering) * (1.0 - border);

  Tissue t;
  t.cut = border;
  t.lost = at.lost;
  t.albedo = capsuleColour(at, base);
  t.bumps = 0.016 * at.broad.yzw + 0.014 * at.middle.yzw + 0.012 * at.fine.yzw;
  t.waves = 0.050 * at.broad.yzw + 0.060 * at.middle.yzw + 0.030 * at.fine.yzw;
  t.wet = smoothstep(0.02, 0.42, 0.8 * at.low.x + 0.45 * at.broad.x + 0.15);
#ifndef PLAIN
  if (border > 0.0) {
    vec4 grain = noise(p * 1000.0) * finer(1000.0 * wide);
    vec4 lobule = grains(p * 720.0 + 0.35 * at.fine.yzw);
    float seen = finer(720.0 * wide);
    t.albedo = mix(t.albedo, parenchymaColour(at, lobule, seen, grain, p), border);
    // A torn surface: lobules stand out as grains.
    vec3 rough = 0.03 * at.middle.yzw + 0.05 * at.fine.yzw + 0.05 * grain.yzw - 0.42 * seen * lobule.xyz;
    t.bumps = mix(t.bumps, rough, border);
    t.waves += border * (0.10 * at.fine.yzw - 0.25 * seen * lobule.xyz);
    t.wet = mix(t.wet, 0.8, border);
    // Tumours are pale, firm and mottled, with a redder margin; the border has the noise of the tissue.
    float rough_ = 0.10 * at.middle.x + 0.05 * at.fine.x;
    vec2 structure = structureAt(p) + rough_;
    float tumour = border * smoothstep(0.44, 0.52, structure.x), inner = smoothstep(0.5, 0.8, structure.x);
    vec3 pale_ = mix(vec3(0.27, 0.120, 0.085), vec3(0.36, 0.245, 0.170), inner);
    t.albedo = mix(t.albedo, pale_ * (1.0 + 0.30 * at.middle.x + 0.25 * at.broad.x + 0.12 * grain.x), 0.9 * tumour);
    t.albedo = mix(t.albedo, vec3(0.20, 0.17, 0.060) * (1.0 + 0.15 * at.middle.x), 0.85 * border * smoothstep(0.44, 0.52, structure.y));
    t.bumps = mix(t.bumps, 0.7 * t.bumps, tumour);
    t.wet = mix(t.wet, 0.6, tumour);
    Vessel vessel = vesselAt(p);
    float soft = max(0.6 * wide, 0.00003);
    float wall = border * (1.0 - smoothstep(vessel.wall - soft, vessel.wall + soft, vessel.off));
    float lumen = border * (1.0 - smoothstep(-soft, soft, vessel.off));
    if (wall > 0.0) {
      t.albedo = mix(t.albedo, wallColour(vessel.kind), wall);
      t.albedo = mix(t.albedo, lumenColour(vessel.kind), lumen);
      // The wall stands out as a lip; the lumen falls away inwards.
      float lip = (vessel.off - 0.5 * vessel.wall) / vessel.wall;
      t.bumps = mix(t.bumps, -0.5 * clamp(lip, -1.0, 1.0) * vessel.out_, wall * (1.0 - lumen));
      t.bumps = mix(t.bumps, 0.8 * vessel.out_, lumen);
      t.wet = mix(t.wet, 1.0, wall);
    }
  }
  if (border < 1.0) {  // a tumour below the capsule shines through
    float below = smoothstep(0.25, 0.85, structureAt(p).x + 0.10 * at.broad.x + 0.06 * at.middle.x);
    t.albedo = mix(t.albedo, vec3(0.22, 0.115, 0.085), 0.5 * (1.0 - border) * below);
  }
#endif
  t.albedo = mix(t.albedo, vec3(0.21, 0.098, 0.074), 0.08 * pale);
  t.albedo = mix(t.albedo, vec3(0.030, 0.0025, 0.003), 0.9 * max(-share, 0.0));  // blood in a rim
#ifndef PLAIN
  vec2 heat = heatAt(p);
  if (heat.x > 0.0) {
    // Coagulated tissue is matt and pale grey-tan, blanched at its edge; its crust is brown in spots; then
    // it is black. The borders are soft, and follow the noise.
    float rough = 0.6 * at.middle.x + 0.5 * at.fine.x;
    float tan_ = smoothstep(0.12, 0.70, heat.x + 0.28 * rough), edge = smoothstep(0.0, 0.30, heat.x + 0.10 * rough) * (1.0 - tan_);
    float crust = smoothstep(0.55, 0.95, heat.x) * smoothstep(0.05, 0.45, at.middle.x - 0.6 * at.fine.x);
    float brown = smoothstep(0.02, 0.30, heat.y * (1.0 + 0.8 * rough)), char_ = smoothstep(0.45, 0.75, heat.y * (1.0 + 0.3 * rough));
    t.albedo = mix(t.albedo, vec3(0.090, 0.046, 0.033), 0.75 * edge);
    t.albedo = mix(t.albedo, vec3(0.086, 0.071, 0.057) * (1.0 + 0.30 * rough), 0.96 * tan_);
    t.albedo = mix(t.albedo, vec3(0.048, 0.026, 0.016) * (1.0 + 0.4 * at.fine.x), 0.85 * crust);
    t.albedo = mix(t.albedo, vec3(0.034, 0.017, 0.010) * (1.0 + 0.4 * at.fine.x), 0.9 * brown);
    t.albedo = mix(t.albedo, vec3(0.0075, 0.0062, 0.0055), char_);
    t.wet *= 1.0 - 0.9 * tan_;
    t.lost += 0.10 * tan_;
    t.bumps += (0.05 * tan_ + 0.05 * char_) * at.fine.yzw + 0.03 * tan_ * at.middle.yzw;
  }
  vec2 blood = bloodAt(p, at.middle.x + 0.5 * at.fine.x, n, t.cut);
  blood *= 1.0 - 0.85 * smoothstep(0.3, 0.9, heat.x + 0.2 * at.middle.x + 0.15 * at.fine.x);  // boiled away
  if (blood.x + blood.y > 0.0) {
    t.albedo = underBlood(t.albedo, blood);
    float covered = smoothstep(0.06, 0.5, blood.x), clot = smoothstep(0.05, 0.3, blood.y - blood.x);
    t.bumps = mix(t.bumps, 0.25 * t.bumps, covered);
    t.waves = mix(t.waves, 0.35 * t.waves, covered);
    float border_ = smoothstep(0.0, 0.05, blood.x) * (1.0 - smoothstep(0.06, 0.25, blood.x));
    t.waves += 0.35 * border_ * at.middle.yzw;
    t.wet = mix(t.wet, 1.0 - 0.6 * clot, max(covered, clot));
    t.lost *= 1.0 - 0.7 * covered;
  }
#endif
  return t;
}

// p: position at rest, `wide`: how far it moves within a pixel; n0: unit normal towards the eye's
// side; bend: curvature, 1/m; share: as cutOrRim() gives it; eyePosition: in eye space; baseColor:
// of the capsule, as on a screen.
vec3 liver(vec3 p, float wide, vec3 n0, float bend, float share, vec3 eyePosition, vec3 baseColor) {
  Tissue t = tissueAt(p, wide, share, fromScreen(baseColor), n0);
  Surroundings around = surroundings(eyePosition, pointToWorld(eyePosition));
  // Inside a wound the map of heights knows nothing: there some of the room is seen.
  around.open = mix(around.open, max(around.open, 0.30), t.cut);
  return wetTissue(t, n0, bend, around, eyePosition);
}
