// How tissue under a film of fluid is lit: scattering, what shines through, sheen and glints.

struct Tissue {
  vec3 albedo;
  vec3 bumps;  // slope of the tissue
  vec3 waves;  // slope of the film on it: few and long, so that a lamp breaks into some pieces
  float wet;   // how thick the film is, 0 to 1
  float lost;  // how much of the film's roughness is finer than a pixel
  float cut;   // 0 skin of an organ, 1 a carved face
};

// n0: unit normal towards the eye's side, object space; bend: curvature, 1/m; eyePosition: in eye
// space.
vec3 wetTissue(Tissue t, vec3 n0, float bend, Surroundings around, vec3 eyePosition) {
  vec3 slope = t.bumps - dot(t.bumps, n0) * n0, waves = t.waves - dot(t.waves, n0) * n0;
  vec3 flatEye = normalize(gl_NormalMatrix * n0);
  vec3 film = toWorld(normalize(gl_NormalMatrix * (n0 - waves))), flat_ = toWorld(flatEye);
  vec3 n = toWorld(normalize(gl_NormalMatrix * (n0 - slope)));
  vec3 point = pointToWorld(eyePosition), v = toWorld(-normalize(eyePosition));
  // Carved faces carry the rows of the lattice: what scatters under them shades softer than they are.
  n = normalize(mix(n, v, 0.42 * t.cut));

  float lit = lampVisible(eyePosition, flatEye);
  float open = around.open;
  vec3 l0, l1;
  vec3 e0 = lampLight(0, point, l0), e1 = lampLight(1, point, l1), eh = headLight(eyePosition);
  eh *= mix(0.35 + 0.65 * open, 0.75 + 0.25 * open, t.cut);  // the lamp at the eye shines into a wound

  // Light under the surface: the more the surface bends, the farther round the terminator it comes,
  // red farthest; and it crosses what is thin.
  vec3 wrap = vec3(0.22, 0.06, 0.04) + vec3(0.38, 0.14, 0.10) * smoothstep(25.0, 300.0, bend);
  vec3 soft0 = max((vec3(dot(n, l0)) + wrap) / (1.0 + wrap), 0.0);
  soft0 *= soft0 / (soft0 + 0.06) * 1.06;  // no edge where it ends
  vec3 soft1 = max((vec3(dot(n, l1)) + wrap) / (1.0 + wrap), 0.0);
  vec3 softH = max((vec3(dot(n, v)) + 0.5 * wrap) / (1.0 + 0.5 * wrap), 0.0);
  softH *= softH * softH;
  vec3 crossed = lampThrough(eyePosition);
  vec3 behind = 0.6 * crossed * smoothstep(0.15, -0.35, dot(flat_, l0));
  // What is hidden from the room is lit by the tissue round it, in red.
  vec3 again = min(3.0 * t.albedo, 0.85);
  vec3 hidden = vec3(open) / (1.0 - again * (1.0 - open));
  vec3 diffuse = 1.55 * eh * softH + 1.05 * e0 * (soft0 * max(vec3(lit), crossed) + behind) +
                 0.28 * e1 * soft1 * hidden * (0.1 + 0.9 * open) +
                 0.42 * ambientLight(n) * hidden * open;
  // Some light comes through the tissue to every place: no border is black.
  diffuse += vec3(0.014, 0.007, 0.006);
  vec3 color = t.albedo * diffuse;

  // The film mirrors the cloth below the horizon, above it one soft gradient.
  vec3 r = reflect(-v, n);
  vec3 cloth = vec3(0.004, 0.020, 0.016) * (0.2 + 0.8 * around.tableLit) * around.tableOpen;
  vec3 sky = mix(cloth, vec3(0.11, 0.12, 0.13) * open, smoothstep(-0.3, 0.6, r.y));
  float nv = max(dot(n, v), 0.0);
  color += min(fresnel(0.028, nv), 0.20) * sky * smoothstep(0.0, 0.25, dot(flat_, v));
  // The lamps' sheen, soft, and their glints where the film is thick enough.
  color += 0.010 * e0 * lit * max(dot(n, l0), 0.0) * glossLobe(n, l0, v, 0.55);
  color += 0.007 * e0 * lit * max(dot(flat_, l0), 0.0) * glossLobe(flat_, l0, v, 0.36);
  color += 0.010 * e1 * open * max(dot(n, l1), 0.0) * glossLobe(n, l1, v, 0.55);
  float rough = 0.15 + 1.5 * t.lost, third = 0.333;
  float fromMain = 0.014 * dot(e0, vec3(third)) * max(dot(film, l0), 0.0);
  float fromSecond = 0.026 * dot(e1, vec3(third)) * max(dot(film, l1), 0.0);
  float glints = lit * (fromMain * glossLobe(film, l0, v, rough + 0.02) +
                        fromSecond * glossLobe(film, l1, v, rough));
  color += t.wet * t.wet * smoothstep(0.05, 0.25, dot(flat_, v)) *
           (0.014 * eh * glossLobe(film, v, v, rough) + vec3(1.0, 0.985, 0.95) * glints);
  return picture(color, eyePosition);
}
