// Still tissue round the organ, in the operative field: what its kinds have in common. Each kind's
// file defines
//   void sceneryTissue(inout Tissue t, vec3 p, float wide);
// t comes with the model's colour and no film; p: position in the model, m; wide: how far it moves
// within a pixel.
varying vec3 eyePosition;
varying vec3 objectPosition;
varying vec3 objectNormal;
varying vec3 baseColor;
uniform sampler2D pool;  // depth of blood on the table: 1 m square round the origin, 1 stands for 5 mm

void sceneryTissue(inout Tissue t, vec3 p, float wide);

// Fine vessels in a skin: curves where a noise vanishes, of some length; 0 to 1.
float fineVessels(vec3 p, float perMetre, float wide) {
  vec3 bent = p + 0.004 * noise(p * 90.0).yzw / 3.0;
  float line = abs(noise(bent * perMetre).x), some = smoothstep(-0.1, 0.5, noise(p * 0.31 * perMetre + 8.0).x);
  float soft = 0.035 + perMetre * wide;
  return some * (1.0 - smoothstep(0.0, soft, line)) * 0.07 / (0.035 + soft);
}

void main() {
  vec3 n = normalize(objectNormal);
  if (dot(gl_NormalMatrix * n, eyePosition) > 0.0) n = -n;
  vec3 point = pointToWorld(eyePosition);
  float wide = widest(objectPosition);
  // What stands round the organ is lit less than the organ: the eye goes there.
  Tissue t = Tissue(0.40 * fromScreen(baseColor), vec3(0.0), vec3(0.0), 0.3, 0.0, 0.0);
  sceneryTissue(t, objectPosition, wide);
  if (point.y < 0.03 && abs(point.x) < 0.5 && abs(point.z) < 0.5) {
    // The pool is deepest in the grooves.
    float depth = 5.0 * texture2D(pool, point.xz + 0.5).r;
    depth *= 1.6 - 1.4 * smoothstep(-0.008, 0.006, point.y + 0.0015 * noise(objectPosition * 160.0).x);
    if (depth > 0.01) {
      t.albedo = underBlood(t.albedo, vec2(0.5 * depth, 0.0));
      float covered = smoothstep(0.05, 0.6, depth);
      t.bumps *= 1.0 - 0.8 * covered;
      t.waves *= 1.0 - 0.6 * covered;
      t.wet = mix(t.wet, 1.0, covered);
    }
  }
  Surroundings around = surroundings(eyePosition, point);
  around.open = mix(around.tableOpen, 1.0, clamp(point.y / 0.09, 0.0, 1.0));
  gl_FragColor = vec4(wetTissue(t, n, 60.0, around, eyePosition), 1.0);
}
