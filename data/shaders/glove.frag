// Surgeon's hands: latex of a glove and cloth of a sleeve, matt. A hand that would hide what its
// instrument works at fades away.
varying vec3 eyePosition;
varying vec3 objectPosition;
varying vec3 objectNormal;
varying vec3 baseColor;

// How far the part of the hand round `centre` (hand's frame, m) is clear of the line of sight to the
// instrument's tip, m; below 0 where it hides the tip.
float clear(vec3 centre, vec3 tip) {
  const float kRadius = 0.045;
  vec3 p = (gl_ModelViewMatrix * vec4(centre, 1.0)).xyz;
  float along = dot(p, normalize(tip));
  return along > length(tip) ? 1.0 : length(p - along * normalize(tip)) - kRadius;
}

// Share of the hand that is drawn, 0 to 1. The texture's matrix tells how far the tip is from the
// fingers, and how far from its tip the instrument is bloody (m), since no texture is on a hand.
float shown() {
  vec3 tip = (gl_ModelViewMatrix * vec4(0.0, 0.0, -gl_TextureMatrix[0][3].x, 1.0)).xyz;
  float least = min(clear(vec3(0.0), tip),
                    min(clear(vec3(0.03, 0.0, 0.05), tip), clear(vec3(0.07, 0.0, 0.11), tip)));
  // A hand close to the eye would hide half of the picture.
  float away = -(gl_ModelViewMatrix * vec4(0.04, 0.0, 0.06, 1.0)).z;
  return smoothstep(0.0, 0.004, least) * smoothstep(0.26, 0.27, away);
}

// How much of the glove is stained, 0 to 1: fingertips, where the instrument is bloody.
float stained() {
  float bloody = smoothstep(0.008, 0.035, gl_TextureMatrix[0][3].y);
  if (bloody <= 0.0) return 0.0;
  float border = 0.055 * bloody + 0.016 * noise(objectPosition * 55.0).x;
  float smears = smoothstep(-0.5, 0.35, noise(objectPosition * vec3(230.0, 230.0, 90.0)).x + 0.25);
  return bloody * smoothstep(border + 0.006, border - 0.010, length(objectPosition)) * mix(0.15, 0.9, smears);
}

void main() {
  // Pixels of a fading hand are left out in a fine pattern.
  float pattern = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  if (shown() <= pattern) discard;

  vec3 n0 = normalize(objectNormal);
  float latex = step(baseColor.g, baseColor.r);
  vec3 q = objectPosition * mix(vec3(60.0), vec3(90.0), latex);
  vec4 wrinkles = noise(q) * finer(widest(q));
  vec3 slope = mix(0.10, 0.05, latex) * wrinkles.yzw;
  // Creases of thin latex: ridges where a noise changes its sign.
  vec3 c = objectPosition.zxy * vec3(150.0, 110.0, 130.0);
  vec4 crease = noise(c) * finer(widest(c));
  slope += 0.09 * latex * exp(-18.0 * crease.x * crease.x) * crease.wyz;
  vec3 n = toWorld(normalize(gl_NormalMatrix * (n0 - slope + dot(slope, n0) * n0)));
  vec3 point = pointToWorld(eyePosition), v = toWorld(-normalize(eyePosition));
  if (dot(n, v) < 0.0) n = normalize(n - 2.0 * dot(n, v) * v);

  // Duller than its dye: the eye goes to the organ.
  vec3 albedo = 0.26 * fromScreen(baseColor) * (1.0 + 0.05 * wrinkles.x);
  float blood = stained();
  albedo = mix(albedo, vec3(0.085, 0.0035, 0.003), blood);
  vec3 l0, l1;
  vec3 e0 = lampLight(0, point, l0), e1 = lampLight(1, point, l1);
  vec3 wrap = vec3(0.30, 0.22, 0.18) * latex;  // light comes through thin latex and skin
  vec3 soft = max((vec3(dot(n, l0)) + wrap) / (1.0 + wrap), 0.0);
  float facing = max(dot(n, v), 0.0);
  // Light that has touched the organ comes back red from below.
  vec3 below = vec3(0.16, 0.030, 0.022) * (0.5 - 0.5 * n.y);
  vec3 diffuse = e0 * soft + e1 * max(dot(n, l1), 0.0) + 1.2 * ambientLight(n) + below +
                 0.7 * headLight(eyePosition) * facing;
  vec3 color = albedo * diffuse;
  color += mix(0.05, 0.035, blood) * latex * (e0 * max(dot(n, l0), 0.0) * glossLobe(n, l0, v, mix(0.42, 0.24, blood)) +
                           headLight(eyePosition) * facing * glossLobe(n, v, v, mix(0.40, 0.24, blood)));
  gl_FragColor = vec4(picture(color, eyePosition), 1.0);
}
