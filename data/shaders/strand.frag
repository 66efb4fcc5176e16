// Bare vessels: thin wet walls through which their content shines, with remnants of tissue and smears
// of blood on them; cut ends with their lumen; brown and shrivelled where heat has sealed them. And
// what hangs on the organ.
varying vec3 eyePosition;
varying vec3 objectPosition;  // at rest
varying vec3 objectNormal;
varying float cutShare;       // kind and look, see operation/blood/vessel_walls.h

const float kBend = 420.0;  // 1/m: of a thin vessel

// The wall itself, where it lies double at the rims of the tube.
vec3 strandWall(float kind) {
  if (kind < 0.5) return vec3(0.156, 0.110, 0.120);  // portal vein
  if (kind < 1.5) return vec3(0.090, 0.051, 0.066);  // hepatic vein
  if (kind < 2.5) return vec3(0.235, 0.128, 0.098);  // artery
  return vec3(0.156, 0.146, 0.056);                  // bile duct
}

// What shines through it: blood of the veins, which looks blue under a wall, or bile.
vec3 strandContent(float kind) {
  if (kind < 0.5) return vec3(0.044, 0.029, 0.052);
  if (kind < 1.5) return vec3(0.022, 0.009, 0.022);
  if (kind < 2.5) return vec3(0.120, 0.034, 0.028);
  return vec3(0.060, 0.072, 0.014);
}

// What hangs on the organ (operation/adnexa/liver_adnexa.h): a gallbladder through whose wall bile
// shines, and the stumps of the ligaments, pale folds with fat at the root and a dark cut edge.
vec3 adnexa(vec3 n0, vec3 p, float wide) {
  float kind = floor(cutShare + 0.02), share = clamp((cutShare - kind) / 0.9, 0.0, 1.0);
  vec4 broad = noise(p * 70.0 + 5.0), middle = noise(p.zxy * 210.0), fine = noise(p.yzx * 800.0);
  fine *= finer(800.0 * wide);
  // Fine vessels: where a noise passes through zero, here and there.
  float branches = 1.0 - smoothstep(0.01, 0.07, abs(noise(p * 110.0 + 0.9 * broad.yzw + 0.4 * middle.yzw).x));
  branches *= finer(110.0 * wide) * smoothstep(-0.25, 0.45, broad.z);
  Tissue t;
  t.lost = 0.05;
  t.cut = 0.0;
  t.wet = 0.80;
  t.bumps = 0.020 * middle.yzw + 0.012 * fine.yzw;
  t.waves = 0.045 * broad.yzw + 0.018 * middle.yzw;
  float bend = 60.0;
  if (kind < 16.5) {
    vec3 bile = vec3(0.017, 0.027, 0.021) * (1.0 + 0.25 * broad.x + 0.12 * middle.x);
    vec3 serosa = vec3(0.066, 0.052, 0.043);
    t.albedo = mix(bile, serosa, 0.22 + 0.16 * smoothstep(-0.4, 0.6, middle.x + 0.5 * broad.x));
    // Fat and red serosa towards the bed.
    float bed = 1.0 - smoothstep(0.10, 0.60, share + 0.22 * broad.x + 0.12 * middle.x);
    vec3 fat = mix(vec3(0.078, 0.026, 0.018), vec3(0.130, 0.066, 0.026), smoothstep(-0.3, 0.4, middle.x));
    t.albedo = mix(t.albedo, fat, 0.70 * bed);
    t.albedo = mix(t.albedo, vec3(0.085, 0.022, 0.018), 0.45 * branches);
  } else if (kind < 17.5) {
    bend = 300.0;
    // A thin membrane, through which the liver is seen the more the less it stands edgewise.
    vec3 capsule = vec3(0.072, 0.019, 0.016);
    float edgewise = 1.0 - abs(dot(normalize(gl_NormalMatrix * n0), normalize(eyePosition)));
    vec3 membrane = vec3(0.150, 0.084, 0.066) * (1.0 + 0.15 * broad.x + 0.08 * middle.x);
    t.albedo = mix(capsule, membrane, clamp(0.14 + 0.50 * edgewise * edgewise + 0.20 * middle.x + 0.16 * smoothstep(0.75, 0.95, share), 0.0, 1.0));
    float fat = (1.0 - smoothstep(0.05, 0.55, share + 0.30 * middle.x)) * smoothstep(0.0, 0.4, broad.x);
    t.albedo = mix(t.albedo, vec3(0.160, 0.090, 0.036), 0.70 * fat);
    t.albedo = mix(t.albedo, vec3(0.095, 0.016, 0.013), 0.35 * branches);
    // It grows out of the capsule.
    t.albedo = mix(capsule, t.albedo, smoothstep(0.05, 0.50, share + 0.15 * middle.x));
    t.bumps += 0.05 * middle.yzw + 0.02 * fine.yzw;
  } else {
    bend = 300.0;
    t.albedo = mix(vec3(0.110, 0.054, 0.038), vec3(0.140, 0.074, 0.030), smoothstep(-0.2, 0.5, broad.x));
    t.albedo *= 1.0 + 0.20 * middle.x + 0.10 * fine.x;
    t.albedo = mix(t.albedo, vec3(0.020, 0.022, 0.030), smoothstep(0.4, 0.7, share));  // the thread
  }
  vec2 blood = bloodAt(p, middle.x + 0.5 * fine.x, n0, 0.0);
  if (blood.x + blood.y > 0.0) {
    t.albedo = underBlood(t.albedo, blood);
    t.wet = mix(t.wet, 1.0, smoothstep(0.06, 0.5, blood.x));
  }
  Surroundings around = surroundings(eyePosition, pointToWorld(eyePosition));
  around.open = max(around.open, 0.35);
  return wetTissue(t, n0, bend, around, eyePosition);
}

void main() {
  vec3 n0 = normalize(objectNormal);
  if (dot(gl_NormalMatrix * n0, eyePosition) > 0.0) n0 = -n0;
  vec3 p = objectPosition;
  float wide = widest(p);
  if (cutShare > 15.5) {
    gl_FragColor = vec4(adnexa(n0, p, wide), 1.0);
    return;
  }
  float kind = floor((cutShare + 0.01) / 4.0), look = cutShare - 4.0 * kind;
  vec4 broad = noise(p.yzx * 130.0 + 3.0), smear = noise(p * 330.0), fine = noise(p.zxy * 1100.0);
  fine *= finer(1100.0 * wide);

  Tissue t;
  t.lost = 0.05;
  t.cut = 0.0;
  // The more slanting the sight, the more of the wall and the less of its content is seen.
  float facing = max(dot(normalize(gl_NormalMatrix * n0), -normalize(eyePosition)), 0.0);
  float thick = kind < 1.5 ? (kind < 0.5 ? 0.62 : 0.26) : 1.3;
  thick *= 1.0 + 0.55 * broad.x + 0.35 * smear.x;
  float wall = 1.0 - exp(-thick / (0.18 + facing));
  t.albedo = mix(strandContent(kind), strandWall(kind) * (1.0 + 0.16 * smear.x + 0.10 * fine.x), wall);
  // Shreds of the sheath, pale; then crumbs of liver that stuck to it; then thin blood.
  float sheath = smoothstep(0.0, 0.8, broad.x - 0.3 * smear.x + 0.2 * fine.x);
  t.albedo = mix(t.albedo, vec3(0.165, 0.100, 0.080), (kind > 0.5 && kind < 1.5 ? 0.12 : 0.30) * sheath);
  float crumb = smoothstep(0.28, 0.50, smear.x + 0.45 * fine.x - 0.35 * broad.x);
  t.albedo = mix(t.albedo, vec3(0.074, 0.018, 0.014) * (1.0 + 0.4 * fine.x), 0.85 * crumb);
  float blood = 0.12 + 0.88 * smoothstep(-0.15, 0.75, 0.6 * smear.x - 0.8 * broad.x + 0.30 * fine.x);
  t.albedo *= exp(-blood * (1.0 - crumb) * vec3(0.45, 2.3, 2.3));
  t.bumps = 0.030 * smear.yzw + 0.022 * fine.yzw + 0.05 * crumb * fine.yzw;
  t.waves = 0.045 * smear.yzw + 0.012 * fine.yzw;
  t.wet = 0.95 - 0.45 * crumb;

  float burnt = look < 1.5 ? look : 0.0;
  if (burnt > 0.0) {
    float rough = 0.5 * smear.x + 0.4 * fine.x, tan_ = smoothstep(0.10, 0.65, burnt + 0.25 * rough);
    vec3 dry = mix(vec3(0.135, 0.082, 0.052), vec3(0.030, 0.018, 0.013), smoothstep(0.45, 1.15, burnt + 0.5 * rough));
    t.albedo = mix(t.albedo, dry * (1.0 + 0.3 * fine.x), tan_);
    t.wet *= 1.0 - 0.8 * tan_;
    t.bumps += tan_ * (0.05 * smear.yzw + 0.04 * fine.yzw);
  }
  float open = 0.30;  // at least: vessels are bared in wounds, as in liver()
  if (look > 1.5) {
    float deep = smoothstep(0.02, 0.55, look - 2.0);
    vec3 rim = mix(strandWall(kind), vec3(0.17, 0.085, 0.07), 0.5) * (0.8 + 0.2 * fine.x);
    vec3 inside = kind < 2.5 ? vec3(0.040, 0.0022, 0.0030) : vec3(0.055, 0.048, 0.008);
    t.albedo = mix(rim, inside, deep);
    t.wet = 0.45 + 0.4 * deep;
    open *= 1.0 - 0.8 * deep;
  }
  Surroundings around = surroundings(eyePosition, pointToWorld(eyePosition));
  around.open = look > 1.5 ? min(around.open, max(open, 0.1)) : max(around.open, open);
  gl_FragColor = vec4(wetTissue(t, n0, kBend, around, eyePosition), 1.0);
}
