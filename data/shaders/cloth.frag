// A green drape of plain weave, with soft folds.
varying vec3 eyePosition;
varying vec3 objectPosition;
varying vec3 objectNormal;
varying vec3 baseColor;

void main() {
  vec3 n0 = normalize(objectNormal);
  vec3 p = objectPosition;
  vec4 folds = noise(p * vec3(9.0, 9.0, 5.0)), creases = noise(p * vec3(38.0, 30.0, 17.0) + 4.0);

  // Threads every 0.9 mm in the plane of the surface; where a pixel is wider they become a tone.
  vec3 a = abs(n0);
  vec2 q = a.y > 0.6 ? p.xz : (a.x > 0.6 ? p.zy : p.xy);
  vec2 thread = q * 1100.0;
  float seen = 1.0 - smoothstep(0.25, 0.8, max(fwidth(thread.x), fwidth(thread.y)));
  vec2 wave = sin(3.14159 * thread);
  float weave = seen * wave.x * wave.y;

  vec3 slope = 0.22 * folds.yzw / 9.0 * 0.9 + 0.11 * creases.yzw / 3.0 * 0.35;
  slope -= dot(slope, n0) * n0;
  vec3 flatEye = normalize(gl_NormalMatrix * n0);
  vec3 n = toWorld(normalize(gl_NormalMatrix * (n0 - slope))), flat_ = toWorld(flatEye);
  vec3 point = pointToWorld(eyePosition), v = toWorld(-normalize(eyePosition));

  float lit = lampVisible(eyePosition, flatEye), open = openness(eyePosition, point, flat_);
  vec3 l0, l1;
  vec3 e0 = lampLight(0, point, l0), e1 = lampLight(1, point, l1);
  vec3 albedo = vec3(0.035, 0.165, 0.150) * (1.0 + 0.22 * weave + 0.06 * folds.x);
  // Light that has touched the organ comes back red.
  vec3 near = vec3(open + 0.12 * open * (1.0 - open) * 4.0, open, open);
  vec3 diffuse = e0 * lit * max(dot(n, l0), 0.0) + e1 * max(dot(n, l1), 0.0) * (0.35 + 0.65 * open) +
                 ambientLight(n) * near;
  vec3 color = albedo * diffuse;
  float x = 1.0 - max(dot(n, v), 0.0);
  color += 0.05 * x * x * x * diffuse;  // lint
  gl_FragColor = vec4(picture(color), 1.0);
}
