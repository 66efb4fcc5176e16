// Living liver: a wet capsule, reddish brown and faintly mottled; where it is cut, granular
// parenchyma, darker and moist, with vessels. Colours are linear.
//
// p: position at rest, `wide`: how far it moves within a pixel; n0: unit normal towards the eye's
// side; cutShare: as cutOrRim() gives it; eyePosition: in eye space; baseColor: of the capsule, as on a
// screen. Positions and normals in object space, m.
vec3 liver(vec3 p, float wide, vec3 n0, float cutShare, vec3 eyePosition, vec3 baseColor) {
  vec4 broad = noise(p * 55.0);
  vec4 fine = noise(p * 420.0 + 3.7) * finer(420.0 * wide);
  vec4 middle = noise(p * 160.0 + 9.1);

  // The edge of a cut wanders a little.
  float cut = smoothstep(0.38, 0.62, cutShare + 0.10 * middle.x * step(0.02, cutShare));
  float rim = cut * (1.0 - cut) * 4.0;

  vec3 capsule = fromScreen(baseColor);
  capsule *= 1.0 + 0.16 * broad.x + 0.10 * middle.x + 0.12 * fine.x;
  capsule = mix(capsule, vec3(1.25, 2.1, 1.7) * capsule, 0.35 * smoothstep(0.0, 0.7, -broad.x));

  vec3 bumps = 0.050 * broad.yzw + 0.042 * middle.yzw + 0.030 * fine.yzw;
  vec3 albedo = capsule;
  float wetness = 1.0;
  if (cut > 0.0) {
    vec4 grain = noise(p * 1000.0) * finer(1000.0 * wide);
    vec3 inside = vec3(0.0518, 0.0068, 0.0055);
    inside *= 1.0 + 0.22 * grain.x + 0.15 * fine.x + 0.12 * broad.x;
    // Lobules: paler centres in a darker net, about 1.5 mm.
    inside = mix(inside, vec3(0.0740, 0.0178, 0.0111), 0.40 * smoothstep(0.0, 0.7, fine.x + 0.5 * grain.x));
    // Vessels are curves in space, where two noises vanish together.
    float large = length(vec2(broad.x, noise(p.zxy * 50.0 + 17.3).x));
    float small = length(vec2(middle.x, noise(p.zxy * 140.0 + 5.1).x));
    // Walls pale, lumens full of dark blood.
    float wall = max(1.0 - smoothstep(0.17, 0.23, large), 0.7 - 0.7 * smoothstep(0.14, 0.22, small));
    float lumen = max(1.0 - smoothstep(0.11, 0.15, large), 0.8 - 0.8 * smoothstep(0.07, 0.13, small));
    inside = mix(inside, vec3(0.1665, 0.0703, 0.0536), 0.6 * wall);
    inside = mix(inside, vec3(0.060, 0.0035, 0.0045), lumen);
    albedo = mix(albedo, inside, cut);
    bumps = mix(bumps, 0.05 * middle.yzw + 0.09 * fine.yzw + 0.08 * grain.yzw, cut);
    wetness = mix(1.0, 0.85, cut);
  }
  albedo = mix(albedo, vec3(0.30, 0.14, 0.11), 0.25 * rim);
  albedo = mix(albedo, vec3(0.030, 0.0025, 0.003), 0.9 * max(-cutShare, 0.0));

  // The film of fluid is smoother than the tissue under it.
  vec3 slope = bumps - dot(bumps, n0) * n0;
  vec3 tissueEye = normalize(gl_NormalMatrix * (n0 - slope));
  vec3 filmEye = normalize(gl_NormalMatrix * (n0 - 0.55 * slope));
  vec3 flatEye = normalize(gl_NormalMatrix * n0);
  vec3 n = toWorld(tissueEye), film = toWorld(filmEye), flat_ = toWorld(flatEye);
  vec3 point = pointToWorld(eyePosition), v = toWorld(-normalize(eyePosition));

  float lit = lampVisible(eyePosition, flatEye);
  Surroundings around = surroundings(eyePosition, point);
  float open = around.open;
  vec3 l0, l1;
  vec3 e0 = lampLight(0, point, l0), e1 = lampLight(1, point, l1);

  // Red light travels farthest in tissue: it creeps round the terminator and into the shadow.
  vec3 wrap = vec3(0.32, 0.10, 0.07);
  vec3 soft0 = max((vec3(dot(n, l0)) + wrap) / (1.0 + wrap), 0.0);
  vec3 soft1 = max((vec3(dot(n, l1)) + wrap) / (1.0 + wrap), 0.0);
  vec3 through = vec3(sqrt(lit), lit, lit);
  vec3 diffuse = e0 * soft0 * through + e1 * soft1 * (0.15 + 0.85 * open) +
                 ambientLight(n) * vec3(sqrt(open), open, open);
  vec3 color = albedo * diffuse;

  float nv = max(dot(film, v), 0.0);
  vec3 r = reflect(-v, film);
  // Below the horizon the film mirrors the cloth, not the room.
  vec3 cloth = vec3(0.006, 0.050, 0.042) * (0.2 + 0.8 * around.tableLit) * around.tableOpen;
  vec3 mirror = mix(cloth, mirrored(point, r, mix(0.055, 0.08, cut)) * open * mix(0.2, 1.0, lit),
                    smoothstep(-0.2, 0.2, r.y));
  color += wetness * fresnel(0.028, nv) * mirror;
  color += 0.020 * e0 * lit * max(dot(n, l0), 0.0) * glossLobe(n, l0, v, 0.48);
  color += 0.020 * e1 * max(dot(n, l1), 0.0) * glossLobe(n, l1, v, 0.48);

  return picture(color);
}
