// Smoke: steam and fine particles, blue-grey, in wisps.
varying vec3 eyePosition;
varying vec2 corner;
varying vec3 pattern;
varying float density;

void main() {
  float r = dot(corner, corner);
  if (r > 1.0) discard;
  float wisp = 0.55 + 0.75 * noise(pattern).x;
  float hides = density * (1.0 - r) * (1.0 - r) * clamp(wisp, 0.1, 1.3);
  vec3 way;
  vec3 light = lampLight(0, pointToWorld(eyePosition), way) + headLight(eyePosition) + vec3(0.06);
  vec3 color = picture(vec3(0.29, 0.31, 0.335) * light, eyePosition);
  gl_FragColor = vec4(hides * color, hides);
}
