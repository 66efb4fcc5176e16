// What is seen beside the table: the room, out of focus, darker towards the corners.
varying vec3 eyeRay;

float glow(vec3 d, vec3 at, float size) {
  return 1.0 - smoothstep(0.7 * size, 1.25 * size, length(d - normalize(at)));
}

void main() {
  vec3 d = toWorld(normalize(eyeRay));
  vec3 light = 0.55 * roomLight(d, 0.30) + vec3(0.006, 0.010, 0.011) * smoothstep(-0.75, -0.1, d.y);
  // Monitors and lamps of the equipment, far out of focus, and what the floor mirrors of them.
  vec3 lights = glow(d, vec3(-0.40, -0.385, -1.0), 0.030) * vec3(0.018, 0.052, 0.060) +
                glow(d, vec3(-0.345, -0.36, -1.0), 0.018) * vec3(0.030, 0.060, 0.045) +
                glow(d, vec3(-0.20, -0.40, -1.0), 0.013) * vec3(0.016, 0.030, 0.034) +
                glow(d, vec3(0.16, -0.37, -1.0), 0.016) * vec3(0.022, 0.030, 0.042) +
                glow(d, vec3(0.31, -0.39, -1.0), 0.026) * vec3(0.055, 0.036, 0.018) +
                glow(d, vec3(0.385, -0.36, -1.0), 0.036) * vec3(0.012, 0.036, 0.046) +
                glow(d, vec3(1.0, -0.40, 0.35), 0.050) * vec3(0.018, 0.050, 0.060) +
                glow(d, vec3(1.0, -0.36, 0.70), 0.030) * vec3(0.055, 0.040, 0.025);
  light += lights;
  gl_FragColor = vec4(picture(light), 1.0);
}
