// What is seen beside the table: dark green drapes that hang round it, out of focus, lit from below
// and dark towards the top.
varying vec3 eyeRay;

void main() {
  const float kFar = 1.5;  // m: of the drapes from the table's middle
  vec3 d = toWorld(normalize(eyeRay)), o = pointToWorld(vec3(0.0));
  // Where the ray meets the round of drapes.
  float a = max(dot(d.xz, d.xz), 1e-4), b = dot(o.xz, d.xz), c = dot(o.xz, o.xz) - kFar * kFar;
  vec3 q = o + d * ((sqrt(max(b * b - a * c, 0.0)) - b) / a);
  float along = kFar * atan(q.x, -q.z);
  vec3 folds = noise2(vec2(5.0 * along + 0.3 * q.y, 0.7 * q.y));
  vec3 small = noise2(vec2(13.0 * along, 1.1 * q.y + 7.0));
  float shade = 0.75 + 0.16 * folds.y + 0.10 * small.y;
  float reach = exp(-abs(q.y + 0.1) / 0.40);
  vec3 light = vec3(0.0040, 0.0125, 0.0108) * shade * (0.12 + 1.1 * reach);
  gl_FragColor = vec4(picture(light, eyeRay), 1.0);
}
