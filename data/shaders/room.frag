// What is seen beside the table: the room, out of focus, darker towards the corners.
varying vec3 eyeRay;

float glow(vec3 d, vec3 at, float size) {
  return 1.0 - smoothstep(0.6 * size, 1.4 * size, length(d - normalize(at)));
}

void main() {
  vec3 d = toWorld(normalize(eyeRay));
  vec3 light = 0.55 * roomLight(d, 0.30) + vec3(0.006, 0.010, 0.011) * smoothstep(-0.75, -0.1, d.y);
  // Monitors and lamps of the equipment, far out of focus, and what the floor mirrors of them.
  vec3 lights = glow(d, vec3(-0.52, -0.30, -1.0), 0.090) * vec3(0.018, 0.052, 0.060) +
                glow(d, vec3(-0.40, -0.27, -1.0), 0.050) * vec3(0.030, 0.060, 0.045) +
                glow(d, vec3(0.45, -0.30, -1.0), 0.070) * vec3(0.065, 0.042, 0.020) +
                glow(d, vec3(0.10, -0.27, -1.0), 0.045) * vec3(0.025, 0.035, 0.050) +
                glow(d, vec3(0.62, -0.28, -1.0), 0.110) * vec3(0.012, 0.036, 0.046) +
                glow(d, vec3(1.0, -0.25, 0.3), 0.120) * vec3(0.020, 0.055, 0.070) +
                glow(d, vec3(1.0, -0.20, -0.25), 0.070) * vec3(0.060, 0.045, 0.030);
  light += lights;
  gl_FragColor = vec4(picture(light), 1.0);
}
