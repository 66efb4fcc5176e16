// A drape of plain weave with soft folds, in the colour of the model's material.
varying vec3 eyePosition;
varying vec3 objectPosition;
varying vec3 objectNormal;
varying vec3 baseColor;
uniform sampler2D pool;  // depth of blood on the table: 1 m square round the origin, 1 stands for 5 mm

void main() {
  vec3 n0 = normalize(objectNormal);
  vec3 a = abs(n0), p = objectPosition;
  vec3 point = pointToWorld(eyePosition);
  Surroundings around = softSurroundings(eyePosition, point);

  // The plane of the surface, and its two directions.
  vec2 q = a.y > 0.6 ? p.xz : (a.x > a.z ? p.zy : p.xy);
  vec3 s = a.x > a.z && a.y <= 0.6 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0);
  vec3 t = a.y > 0.6 ? vec3(0.0, 0.0, 1.0) : vec3(0.0, 1.0, 0.0);
  vec3 folds = noise2(q * vec2(7.0, 5.0)), creases = noise2(q.yx * vec2(23.0, 31.0) + 4.0);

  // Threads every 0.5 mm; where a pixel is wider they become a tone.
  vec2 thread = q * 2000.0, wide = fwidth(thread);
  float seen = 1.0 - smoothstep(0.07, 0.20, max(wide.x, wide.y));
  vec2 wave = sin(3.14159 * thread);
  float weave = seen * wave.x * wave.y;

  vec2 slope = 0.075 * folds.yz + 0.045 * creases.yz;
  vec3 n = normalize(n0 - slope.x * s - slope.y * t);
  n = toWorld(normalize(gl_NormalMatrix * n));
  vec3 v = toWorld(-normalize(eyePosition));

  vec3 l0, l1;
  vec3 e0 = lampLight(0, point, l0), e1 = 0.6 * lampLight(1, point, l1);
  // Woven cloth of many washings is duller and darker than its dye, blue more than green.
  vec3 dye = fromScreen(baseColor);
  vec3 grey = vec3(dot(dye, vec3(0.2126, 0.7152, 0.0722)));
  dye = dye.b > dye.g ? 0.32 * mix(grey, dye, 0.50) : 0.46 * mix(grey, dye, 0.66);
  vec3 albedo = dye * (1.0 + 0.14 * weave + 0.05 * creases.x);
  // Blood soaks into the cloth, which draws its border out along the threads, and stands on it where
  // it is deep: dark and glossy, with a rounded border.
  float depth = 0.0;
  if (abs(point.y) < 0.01) {
    vec2 drawn = 0.006 * vec2(noise2(point.xz * 38.0).x, noise2(point.zx * 38.0 + 7.0).x) +
                 0.0012 * vec2(noise2(point.xz * 190.0).x, noise2(point.zx * 190.0 + 7.0).x);
    depth = 5.0 * texture2D(pool, point.xz + 0.5 + drawn).r;
  }
  float soaked = smoothstep(0.02, 0.35, depth), deep = smoothstep(0.25, 0.90, depth);
  albedo = mix(albedo * exp(-2.0 * soaked * vec3(0.5, 1.6, 1.6)), vec3(0.030, 0.0013, 0.0016), smoothstep(0.25, 0.9, soaked));
  n = normalize(mix(n, vec3(0.0, 1.0, 0.0), 0.92 * deep));
  float open = around.tableOpen;
  // Light that has touched the organ comes back red.
  vec3 bounce = open * (1.0 - open) * vec3(0.10, 0.015, 0.01);
  vec3 diffuse = e0 * around.tableLit * max(dot(n, l0), 0.0) +
                 e1 * max(dot(n, l1), 0.0) * open + ambientLight(n) * open + bounce +
                 headLight(eyePosition) * max(dot(n, v), 0.0) * (0.4 + 0.6 * open);
  float x = 1.0 - max(dot(n, v), 0.0);
  vec3 color = albedo * diffuse + 0.04 * x * x * x * diffuse * open;  // lint at grazing sight
  if (deep > 0.0) {
    float facing = max(dot(n, v), 0.0);
    vec3 shine = mirrored(point, reflect(-v, n), 0.03) * min(fresnel(0.028, facing), 0.35);
    color += deep * mix(0.35, 1.0, around.tableLit) * open * shine;
  }
  gl_FragColor = vec4(picture(color, eyePosition), 1.0);
}
